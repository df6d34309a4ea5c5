// asperity-stress on several surfaces: rows of their maxima, and means by depth.
#include <cmath>
#include <vector>

#include <nlohmann/json.hpp>

#include "support.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;
using Json = nlohmann::json;

namespace {

constexpr std::size_t members = 3;

// p_1.nc, p_2.nc, p_3.nc
void press() {
  static const bool pressed =
      shell(
          "asperity-generate -q --periodic --shape 32x24 --size 1mm,0.5mm --rq 0.4um --length 100um "
          "--seed 1 --count 3 -o c_%d.nc; asperity-contact -q --young 208GPa --poisson 0.3 --load 60N "
          "'c_?.nc' --each p_%d.nc -o contacts.tsv")
          .exit == 0;
  REQUIRE(pressed);
}

std::vector<double> column(const Json& table, const std::string& name) {
  std::vector<double> out;
  for (const Json& value : table.at(name)["values"])
    out.push_back(value.is_null() ? NAN : value.get<double>());
  return out;
}

// Mean and standard error of three values, by two sums.
void check_mean(double mean, double error, const std::vector<double>& values) {
  double sum = 0, squares = 0;
  for (const double v : values) sum += v;
  for (const double v : values) squares += std::pow(v - sum / members, 2);
  const double expected = std::sqrt(squares / (members - 1) / members);
  CHECK(relative_error(mean, sum / members) <= 10 * epsilon);
  CHECK(std::abs(error - expected) <= 1e-9 * expected + 10 * epsilon * std::abs(sum));
}

std::string name_of(std::size_t k) { return "p_" + std::to_string(k + 1) + ".nc"; }

}  // namespace

TEST_CASE("each of several surfaces has the row of its own maximum, and the mean is that of the rows",
          "[stress][several][law]") {
  press();
  const std::string command = "asperity-stress -q --maximum --below 2px ";
  const Json all = Json::parse(require(command + "'p_?.nc' --json").out);
  CHECK(all["surface"]["values"] == Json({"p_1.nc", "p_2.nc", "p_3.nc", "mean", "standard_error"}));
  for (const std::string name : {"max_von_mises", "max_depth"}) {
    const std::vector<double> rows = column(all, name);
    for (std::size_t k = 0; k < members; ++k) {
      require(command + name_of(k) + " -o one.nc");
      CAPTURE(name, k);
      CHECK(rows[k] == read_dataset("one.nc").attributes.number("stress_" + name, NAN));
    }
    check_mean(rows[members], rows[members + 1], {rows[0], rows[1], rows[2]});
  }
  CHECK(std::isnan(column(all, "max_x")[members]));  // places on a periodic surface have no mean
}

TEST_CASE("the maximum by depth is averaged over several surfaces", "[stress][several][law]") {
  press();
  const std::string command =
      "asperity-stress -q --result maxima --of max_shear --depths 2px:0.2mm:3 --json ";
  const Json all = Json::parse(require(command + "'p_?.nc'").out);
  for (std::size_t layer = 0; layer < 3; ++layer) {
    std::vector<double> values;
    for (std::size_t k = 0; k < members; ++k)
      values.push_back(column(Json::parse(require(command + name_of(k)).out), "max_shear")[layer]);
    CAPTURE(layer);
    check_mean(column(all, "max_shear")[layer], column(all, "standard_error")[layer], values);
    CHECK(column(all, "surfaces")[layer] == members);
  }
}

TEST_CASE("a surface without a stress is a row without numbers, and warnings are told once",
          "[stress][several][contract]") {
  press();
  const Outcome run = shell("asperity-stress -q --maximum p_1.nc c_1.nc p_2.nc p_3.nc --json");
  CAPTURE(run.error);
  CHECK(run.exit == 4);
  CHECK_THAT(run.error, ContainsSubstring("warning: c_1.nc: pressure is missing"));
  const Json all = Json::parse(run.out),
             three = Json::parse(shell("asperity-stress --maximum 'p_?.nc' --json").out);
  CHECK(std::isnan(column(all, "max_von_mises")[1]));
  CHECK(column(all, "max_von_mises")[4] == column(three, "max_von_mises")[3]);
  // Maxima near the surface of so few cells are doubted, for all of them in two lines.
  const Outcome shallow = shell("asperity-stress --maximum 'p_?.nc'");
  CHECK(lines(shallow.error) == 2);
  CHECK_THAT(shallow.error,
             ContainsSubstring("2 more surfaces, up to p_3.nc: the largest von Mises stress lies"));
}

TEST_CASE("what is of one surface is refused for several", "[stress][several][contract]") {
  press();
  for (const auto& [options, words] :
       {std::pair{"--depths 0:0.1mm:3", "--depths: writes the dataset of one surface"},
        {"--points places", "--points are those of one surface"},
        {"--maximum --report r.json", "--report belongs to a dataset"},
        {"--maximum p_1.nc", "'p_1.nc' is given twice"}}) {
    const Outcome run =
        shell("echo 0mm 0mm 1um > places; asperity-stress p_1.nc p_2.nc " + std::string(options));
    CAPTURE(options, run.error);
    CHECK((run.exit == 2 && lines(run.error) == 1 && run.out.empty()));
    CHECK_THAT(run.error, ContainsSubstring(words));
  }
}
