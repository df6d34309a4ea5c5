// What other programs write, through the tools: units, signs, descending coordinates, two datasets in one
// stream.
#include <filesystem>

#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string draw =
    "asperity-generate --shape 32x24 --size 3.2mm,2.4mm --rq 0.4um --length 6px,3px --seed 7 ";
const std::string press = "asperity-contact --radius 50mm --young 208GPa --poisson 0.3 --load 500N ";

void write_pressed() {
  static const bool once = [] {
    const Outcome run = shell(draw + "-o drawn.nc && " + press + "drawn.nc -o pressed.nc");
    INFO(run.error);
    REQUIRE(run.exit == 0);
    return true;
  }();
  REQUIRE(once);
}

std::vector<double>& doubles(Dataset& data, const char* name) {
  return std::get<std::vector<double>>(data.find(name)->values);
}

// The pressure as another program has it.
void write_pressure(const std::string& name, const char* unit, double factor) {
  Dataset data = read_dataset("pressed.nc");
  for (double& p : doubles(data, "pressure")) p *= factor;
  Attributes& attributes = data.find("pressure")->attributes;
  attributes.erase("units");
  if (unit) attributes.set("units", unit);
  write_dataset(data, name);
}

const std::string stress = "asperity-stress --depths 0:0.5mm:3 ";

// Every variable on x backwards, as xarray's isel leaves it.
Dataset backwards(Dataset data) {
  for (Variable& v : data.variables) {
    if (v.dimensions.empty() || v.dimensions.front() != "x") continue;
    std::visit(
        [&](auto& values) {
          const auto rows = data.length("x"), piece = static_cast<Index>(values.size()) / rows;
          for (Index i = 0; i < rows / 2; ++i)
            std::swap_ranges(values.begin() + i * piece, values.begin() + (i + 1) * piece,
                             values.begin() + (rows - 1 - i) * piece);
        },
        v.values);
  }
  return data;
}

}  // namespace

// In MPa, psi, m or without a unit it passed as Pa. Factors are known to ε, the stress is linear in them.
TEST_CASE("a pressure in MPa makes the stress of the same pressure in Pa", "[units][exact]") {
  write_pressed();
  REQUIRE(shell(stress + "pressed.nc -o pa.nc").exit == 0);
  const std::vector<double> pascals = numbers(read_dataset("pa.nc").at("von_mises").values);
  const double largest = *std::ranges::max_element(pascals);
  for (const auto& [unit, factor] : {std::pair{"MPa", 1e-6}, {"N/mm2", 1e-6}, {"kPa", 1e-3}}) {
    write_pressure("other.nc", unit, factor);
    const Outcome run = shell(stress + "other.nc -o other-stress.nc");
    CAPTURE(unit, run.error);
    REQUIRE(run.exit == 0);
    const std::vector<double> other = numbers(read_dataset("other-stress.nc").at("von_mises").values);
    for (std::size_t i = 0; i < other.size(); ++i)
      if (!(std::abs(other[i] - pascals[i]) <= 64 * epsilon * largest)) FAIL(i << " " << other[i]);
  }
}

TEST_CASE("a pressure of no unit, of another quantity, that pulls or is no number is refused by name",
          "[units][contract]") {
  write_pressed();
  auto refused = [](const std::string& words) {
    const Outcome run = shell(stress + "other.nc -o other-stress.nc");
    CAPTURE(run.error);
    CHECK(run.exit == 4);
    CHECK(lines(run.error) == 1);
    CHECK_THAT(run.error,
               ContainsSubstring("asperity-stress: other.nc: pressure") && ContainsSubstring(words));
  };
  write_pressure("other.nc", nullptr, 1);
  refused("has no unit");
  write_pressure("other.nc", "m", 1);
  refused("'m' cannot be converted to 'Pa'");
  write_pressure("other.nc", "Pa @ 5", 1);
  refused("their zeros differ");
  for (const auto& [value, words] : {std::pair{-3e6, "at point (2, 1) it is -3"},
                                     {std::nan(""), "the value at point (2, 1) is not a number"}}) {
    Dataset data = read_dataset("pressed.nc");
    doubles(data, "pressure")[2 * 24 + 1] = value;
    write_dataset(data, "other.nc");
    refused(words);
  }
}

// Lags in mm counted samples: a surface of another size, or a demand for one.
TEST_CASE("a kernel whose lags and heights are in mm and um draws the same surface", "[units][exact]") {
  REQUIRE(shell("asperity-kernel --length 6px,3px --spacing 0.1mm --rq 0.4um -o kernel.nc").exit == 0);
  Dataset data = read_dataset("kernel.nc");
  for (const auto& [name, unit, factor] : {std::tuple{"p", "mm", 1e3},
                                           {"q", "mm", 1e3},
                                           {"kernel", "um", 1e6},
                                           {"acf_target", "um2", 1e12},
                                           {"acf_achieved", "um2", 1e12}}) {
    for (double& v : doubles(data, name)) v *= factor;
    data.find(name)->attributes.set("units", unit);
  }
  write_dataset(data, "other.nc");
  const Outcome run = shell(
      "for k in kernel other; do asperity-generate --kernel $k.nc --shape 32x24 --seed 3 -o "
      "$k-drawn.nc || exit; done");
  INFO(run.error);
  REQUIRE(run.exit == 0);
  const Dataset one = read_dataset("kernel-drawn.nc"), other = read_dataset("other-drawn.nc");
  CHECK(relative_error(grid_of(other).dx, grid_of(one).dx) <= 8 * epsilon);
  const Field a = field_of(one, "heights"), b = field_of(other, "heights");
  CHECK((a - b).abs().maxCoeff() <= 64 * epsilon * a.abs().maxCoeff());
  data.find("acf_target")->attributes.set("units", "Pa2");
  write_dataset(data, "other.nc");
  CHECK_THAT(shell("asperity-generate --kernel other.nc --shape 32x24 --seed 3 -o d.nc").error,
             ContainsSubstring("acf_target: 'Pa2' cannot be converted"));
}

// Parameters of the mirror image; the place of the largest stress had the wrong sign.
TEST_CASE("a surface whose x descends is turned around, which a note and the history say once",
          "[axes][contract]") {
  write_pressed();
  write_dataset(read_dataset("pressed.nc"), "up.nc");
  const Dataset up = read_dataset("up.nc");
  write_dataset(backwards(up), "down.nc");
  const std::string find = "asperity-stress --maximum --no-history ";
  const Outcome one = shell(find + "up.nc -o up-stress.nc"),
                other = shell(find + "down.nc -o down-stress.nc");
  INFO(other.error);
  REQUIRE((one.exit == 0 && other.exit == 0));
  const std::string line = "descending coordinate x reversed, with all values on it";
  const std::string said = "asperity-stress: down.nc: " + line + "\n";
  const std::size_t at = other.error.find(said);
  CHECK((at != other.error.npos && other.error.find(said, at + 1) == other.error.npos));
  CHECK(one.error.find(line) == one.error.npos);
  CHECK(shell(find + "--quiet down.nc -o down-stress.nc").error.find(line) == std::string::npos);
  const Dataset a = read_dataset("up-stress.nc"), b = read_dataset("down-stress.nc");
  CHECK(a.attributes.number("stress_max_x", 0) == b.attributes.number("stress_max_x", 1));
  CHECK(a.at("heights").values == b.at("heights").values);
  CHECK(b.attributes.text("history").starts_with(line + "\n"));
  CHECK(shell("asperity-stats down-stress.nc").error.empty());
}

// The second was lost without a word.
TEST_CASE("two datasets in one stream are refused with the number of bytes of the second", "[contract]") {
  write_pressed();
  const auto bytes = std::to_string(std::filesystem::file_size(scratch("drawn.nc")));
  for (const std::string& line : {std::string("cat drawn.nc drawn.nc | asperity-stats"),
                                  std::string("cat drawn.nc drawn.nc > two.nc; asperity-psd two.nc"),
                                  std::string("cat drawn.nc drawn.nc | ") + press + "-o p.nc"}) {
    const Outcome run = shell(line);
    CAPTURE(line, run.error);
    CHECK(run.exit == 4);
    CHECK_THAT(run.error, ContainsSubstring("dataset: " + bytes + " bytes follow its end"));
  }
}

TEST_CASE("pictures and statistics of a packed field in MPa are those of the field in Pa", "[units][exact]") {
  write_pressed();
  write_pressure("other.nc", "MPa", 1e-6);
  const std::string sq = "asperity-stats --variable pressure --parameters height ";
  const Outcome pa = shell(sq + "pressed.nc"), mpa = shell(sq + "other.nc");
  INFO(mpa.error);
  REQUIRE((pa.exit == 0 && mpa.exit == 0));
  CHECK(pa.out.substr(0, pa.out.find("Ssk")).size() > 10);
  const auto number = [](const std::string& table) { return std::stod(table.substr(table.find("Sq") + 2)); };
  CHECK(relative_error(number(mpa.out), number(pa.out)) <= 1e-10);
}
