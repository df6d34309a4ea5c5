// Curves of measured fields hold the numbers that the tools print.
#include <cmath>
#include <sstream>

#include "core/words.hpp"
#include "plot/pictures.hpp"
#include "tools/plot/figure.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

using Rows = std::vector<std::vector<double>>;

// The rows of a tool's table, without its words.
Rows rows_of(const std::string& command) {
  std::istringstream lines(shell(command).out);
  Rows out;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream cells(line);
    std::vector<double> row;
    for (std::string cell; std::getline(cells, cell, '\t');)
      if (const auto number = to_number<double>(cell)) row.push_back(*number);
    out.push_back(std::move(row));
  }
  return out;
}

plot::Cases case_of(const std::string& name) { return {{read_dataset(name), "one"}}; }

plot::Request svg() {
  plot::Request out;
  out.format = "svg";
  return out;
}

// The layers whose command holds a word, in their order.
std::vector<plot::Layer> layers_with(const plot::Panel& panel, std::string_view word) {
  std::vector<plot::Layer> out;
  for (const plot::Layer& l : panel.layers)
    if (l.command.find(word) != l.command.npos) out.push_back(l);
  return out;
}

// All their numbers.
std::vector<double> numbers_with(const plot::Panel& panel, std::string_view word) {
  std::vector<double> out;
  for (const plot::Layer& l : layers_with(panel, word))
    out.insert(out.end(), l.numbers.begin(), l.numbers.end());
  return out;
}

void draw(const std::string& more) {
  REQUIRE(
      shell(
          "asperity-generate --shape 64x48 --size 1mm,0.75mm --rq 0.4um --length 5px,3px --seed 7 -o d.nc " +
          more)
          .exit == 0);
}

// Numbers in units with a prefix are those in SI but for the rounding of one division and one product.
constexpr double rounding = 1e-14;
bool same(double drawn, double unit, double printed) {
  return std::abs(drawn * unit - printed) <= rounding * std::abs(printed);
}

}  // namespace

TEST_CASE("a Q-Q plot holds the quantiles of asperity-pdf, and the band its misfit of 1.96",
          "[plot][exact]") {
  draw("");
  const Rows rows = rows_of("asperity-pdf d.nc --estimate quantiles --rows 199");
  const plot::Figure figure = plot::qq(case_of("d.nc"), svg());
  const auto dots = layers_with(figure.panels[0], "with points"),
             band = layers_with(figure.panels[0], "filledcurves");
  REQUIRE((rows.size() == 199 && dots.size() == 1 && band.size() == 1 && dots[0].numbers.size() == 398));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    CAPTURE(k);
    const double height = rows[k][2], gaussian = rows[k][6], misfit = rows[k][7];
    CHECK(dots[0].numbers[2 * k] == rows[k][1]);
    CHECK(same(dots[0].numbers[2 * k + 1], 1e-6, height));
    const double half = 0.5e-6 * (band[0].numbers[3 * k + 2] - band[0].numbers[3 * k + 1]);
    // The misfit's numerator is a difference of heights: rounding in units of them.
    CHECK(std::abs(half * misfit - 1.959963984540054 * (height - gaussian)) <=
          1e-14 * std::abs(height) + 1e-20);
  }
}

TEST_CASE("spectra are drawn with the densities and intervals of asperity-psd", "[plot][exact]") {
  draw("");
  const plot::Figure figure = plot::psd(case_of("d.nc"), svg());
  REQUIRE(figure.panels.size() == 2);
  Rows rings = rows_of("asperity-psd d.nc --result radial");
  std::erase_if(rings, [](const auto& ring) { return std::isnan(ring[2]); });  // drawn as circles
  const std::vector<double> lines = numbers_with(figure.panels[0], "with lines"),
                            bands = numbers_with(figure.panels[0], "filledcurves");
  REQUIRE((rings.size() > 10 && lines.size() == 2 * rings.size() && bands.size() == 3 * rings.size()));
  for (std::size_t k = 0; k < rings.size(); ++k) {
    CAPTURE(k);
    CHECK(same(lines[2 * k], 1e3, rings[k][0]));
    CHECK(same(lines[2 * k + 1], 1e-24, rings[k][1]));
    CHECK(same(bands[3 * k + 1], 1e-24, rings[k][3]));
    CHECK(same(bands[3 * k + 2], 1e-24, rings[k][4]));
  }
}

// A smooth surface that ends leaks: beyond some wave number nothing but leakage is left, without an error.
TEST_CASE("points of a spectrum that have no error are hollow, as many as asperity-psd leaves without",
          "[plot][exact]") {
  REQUIRE(
      shell("asperity-generate --shape 64x64 --size 1mm --rq 0.4um --model gaussian --length 9px --seed 7 -o "
            "d.nc")
          .exit == 0);
  std::size_t without = 0, with = 0;
  for (const auto& row : rows_of("asperity-psd d.nc --result radial"))
    ++(std::isnan(row[2]) ? without : with);
  REQUIRE((without > 3 && with > 3));
  const plot::Figure figure = plot::psd(case_of("d.nc"), svg());
  std::size_t hollow = 0;
  for (const auto& l : layers_with(figure.panels[0], "pointtype 6")) hollow += l.numbers.size() / 2;
  CHECK(hollow == without);
  const auto& told = figure.legend.back();
  CHECK((told.key == plot::LegendEntry::Key::circle && told.name == "no error known"));
}

// Sk is the fall of the core line over the whole ratio, and a triangle has the area of the hill it replaces.
TEST_CASE("the construction of the material ratio curve is that of asperity-stats", "[plot][exact]") {
  draw("");
  const plot::Figure figure = plot::abbott(case_of("d.nc"), svg());
  const Rows stats = rows_of("asperity-stats d.nc --parameters material");
  const auto core = layers_with(figure.panels[0], "dashtype (8,5)"),
             triangles = layers_with(figure.panels[0], "closed");
  REQUIRE((core.size() == 1 && triangles.size() == 2 && stats.size() > 5));
  const std::vector<double>&line = core[0].numbers, &hill = triangles[0].numbers,
        &dale = triangles[1].numbers;
  auto stated = [&](double value) {
    return std::ranges::any_of(stats, [&](const auto& row) {
      return !row.empty() &&
             std::abs(row[0] - value) <= 1e-13 * std::abs(value);  // of differences of heights
    });
  };
  CHECK(stated(1e-6 * (line[1] - line[3])));  // Sk
  CHECK(stated(1e-6 * (hill[3] - hill[1])));  // Spk
  CHECK(stated(1e-6 * (dale[1] - dale[3])));  // Svk
  CHECK(stated(0.01 * hill[4]));              // Smr1
  CHECK(stated(0.01 * dale[4]));              // Smr2
}

TEST_CASE(
    "of a field of one value curves are refused by name, and of a pressure only its distribution is drawn",
    "[plot][contract]") {
  Dataset flat;
  set_grid(flat, {{16, 12}, 1e-6, 1e-6});
  set_field(flat, "heights", Field::Constant(16, 12, 2e-6), {"m", "height"});
  write_dataset(flat, "flat.nc");
  for (const std::string kind : {"abbott", "psd", "qq"}) {
    const Outcome run = shell("asperity-plot flat.nc -o f.svg --kind " + kind);
    CAPTURE(kind, run.error);
    CHECK((run.exit == 4 && lines(run.error) == 1));
    CHECK_THAT(run.error, ContainsSubstring("heights: every value is the same"));
    if (kind == "psd") continue;
    const Outcome part = test::plot("--variable pressure -o p.svg --kind " + kind);
    CHECK((part.exit == 4 && lines(part.error) == 1));
    CHECK_THAT(part.error, ContainsSubstring("pressure: only the cells that are in contact have one"));
  }
}

// The curve of a column is orange; the legend said "along x" in blue.
TEST_CASE("the legend of spectra names the profiles that are drawn, in their colours", "[plot][contract]") {
  for (const Shape shape : {Shape{1, 128}, Shape{128, 1}, Shape{32, 32}}) {
    Dataset data;
    set_grid(data, {shape, 1e-6, 1e-6});
    set_field(data, "heights", 1e-6 * random_field(shape, 1), {"m", "height"});
    write_dataset(data, "row.nc");
    const plot::Figure figure = plot::psd(case_of("row.nc"), svg());
    auto colour_of = [&](const std::string& name) -> std::string {
      for (const plot::LegendEntry& e : figure.legend)
        if (e.name.ends_with(name)) return e.colour;
      return "none";
    };
    CAPTURE(shape.nx, shape.ny);
    CHECK(colour_of("along x") == (shape.nx > 1 ? plot::line_colour(0) : "none"));
    CHECK(colour_of("along y") == (shape.ny > 1 ? plot::line_colour(1) : "none"));
    for (const std::string& colour : {colour_of("along x"), colour_of("along y")})
      if (colour != "none") CHECK(!layers_with(figure.panels.back(), colour).empty());
  }
}

// Both curves are drawn about the mean, under the plain name of the quantity; voltages were called heights.
TEST_CASE("curves about the mean say so, and call heights only what is one", "[plot][contract]") {
  Dataset data;
  set_grid(data, {{32, 32}, 1e-6, 1e-6});
  set_field(data, "heights", 5e-6 + 1e-6 * random_field({32, 32}, 1), {"m", "height"});
  set_field(data, "potential", 5 + random_field({32, 32}, 2), {"V", "potential"});
  write_dataset(data, "volts.nc");
  for (auto* kind : {plot::abbott, plot::qq}) {
    const plot::Figure heights = kind(case_of("volts.nc"), svg());
    CHECK(heights.panels[0].y->label == "height above the mean [µm]");
    CHECK(heights.legend[0].name.starts_with("heights"));
    plot::Request request = svg();
    request.variable = "potential";
    const plot::Figure volts = kind(case_of("volts.nc"), request);
    CHECK(volts.panels[0].y->label == "potential above the mean [V]");
    CHECK(volts.legend[0].name.starts_with("values"));
  }
}
