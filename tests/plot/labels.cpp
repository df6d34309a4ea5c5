// Texts of a picture stand clear of each other, and say what is stretched.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "plot/boxes.hpp"
#include "tools/plot/layout.hpp"
#include "tools/plot/tics.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

void write_map(const std::string& name, Shape shape, double dx, double dy) {
  Dataset data;
  set_grid(data, {shape, dx, dy});
  set_field(data, "heights", 0.4e-6 * random_field(shape, 1), {"m", "height"});
  write_dataset(data, name);
}

}  // namespace

// The numbers of a map of 6 mm by 10 µm ran into the label of y, those of a narrow surface in perspective into
// each other and into x, and at panels of ±500 µm side by side stood "500−500".
TEST_CASE("no text of a picture stands on another", "[plot][law]") {
  for (const char* kind :
       {"map", "surface", "profile", "acf", "pdf", "contact", "von-mises", "abbott", "psd", "qq", "maxima"}) {
    CAPTURE(kind);
    REQUIRE(test::plot(std::string("--kind ") + kind + " -o apart.svg").exit == 0);
    check_apart("apart.svg");
  }
  write_map("long.nc", {300, 20}, 1e-5, 1e-5);
  write_map("flat.nc", {300, 2}, 2e-5, 5e-6);
  write_map("upright.nc", {20, 300}, 1e-5, 1e-5);
  write_map("square.nc", {50, 50}, 2e-5, 2e-5);
  const std::string three = "square.nc square.nc square.nc --labels a,b,c --kind ";
  for (const std::string& arguments :
       {std::string("long.nc --kind map"), std::string("long.nc --kind surface"),
        std::string("flat.nc --kind map"), std::string("upright.nc --kind map"),
        std::string("upright.nc --kind surface"), three + "map", three + "surface", three + "abbott",
        three + "map --columns 1", three + "map --pixels 900x400"}) {
    CAPTURE(arguments);
    REQUIRE(shell("asperity-plot " + arguments + " -o apart.svg").exit == 0);
    check_apart("apart.svg");
  }
}

TEST_CASE("numbers along an axis never touch, however many digits they have", "[plot][law]") {
  for (const plot::Range& range :
       {plot::Range{-500, 500}, {-0.005, 0.005}, {1234.5, 1234.6}, {-1e-3, 2e5}, {0, 1}, {1, 1 + 1e-9}})
    for (const double length : {3.0, 8.0, 12.0, 26.0, 60.0}) {
      const plot::Axis axis{range, "x"};
      const plot::Tics tics = plot::tics_along(axis, length);
      CAPTURE(range.low, range.high, length);
      CHECK(!tics.empty());
      for (std::size_t k = 1; k < tics.size(); ++k) {
        CHECK(tics[k].text != tics[k - 1].text);
        const double apart = (tics[k].at - tics[k - 1].at) / range.width() * length;
        CHECK(apart >= 0.5 * (plot::length_of(tics[k].text) + plot::length_of(tics[k - 1].text)));
      }
    }
}

TEST_CASE("a logarithmic axis has powers of ten, or 1, 2 and 5 times them where it is short",
          "[plot][exact]") {
  auto words = [](plot::Range range, double length) {
    std::string out;
    for (const plot::Tic& t : plot::tics_along({range, "q", false, true}, length)) out += t.text + ' ';
    return out;
  };
  CHECK(words({1, 30}, 26) == "1 2 5 10 20 ");
  CHECK(words({0.5, 2000}, 26) == "1 10 100 1000 ");
  CHECK(words({1e-6, 1e2}, 12) == "10⁻⁶ 10⁻³ 1 ");
}

// 15:1, and of a section 0.1 mm deep and 10 mm long, whatever the title.
TEST_CASE("an axis that is stretched says by how much, in a note below", "[plot][contract]") {
  write_map("long.nc", {300, 20}, 1e-5, 1e-5);
  write_map("square.nc", {50, 50}, 2e-5, 2e-5);
  REQUIRE(shell("asperity-plot long.nc --kind map --title mine -o a.svg").exit == 0);
  CHECK_THAT(words_of("a.svg"), ContainsSubstring("x [mm]\ny × 2.4\n"));  // 0.16 · 15
  REQUIRE(shell("asperity-plot square.nc --kind map -o a.svg").exit == 0);
  CHECK_THAT(words_of("a.svg"), ContainsSubstring("x [µm]\n"));
  // Of several maps with different sides each says its own.
  REQUIRE(shell("asperity-plot square.nc long.nc --kind map --columns 1 --labels a,b -o a.svg").exit == 0);
  CHECK_THAT(words_of("a.svg"), ContainsSubstring("\nx [mm]\ny × 15\n") && ContainsSubstring("\na\n"));
  REQUIRE(shell("asperity-plot long.nc square.nc --kind map --columns 1 --labels a,b -o a.svg").exit == 0);
  CHECK_THAT(words_of("a.svg"),
             ContainsSubstring("\nx [mm]\ny × 2.4\n") && ContainsSubstring("\nx [µm]\nx × 6.25\n"));
  REQUIRE(test::plot("--kind von-mises --depth-range 0um,10um --title mine -o a.svg").exit == 0);
  CHECK_THAT(words_of("a.svg"), ContainsSubstring("x [µm]\ndepth × 14.4\n"));  // 0.25 · 575 µm / 10 µm
  REQUIRE(shell("asperity-plot square.nc --kind surface --title mine -o a.svg").exit == 0);
  CHECK_THAT(words_of("a.svg"), ContainsSubstring("height [nm] × 200\n"));
}

// Panels of other sizes had neither numbers nor a unit, and were read on the scale of their neighbour.
TEST_CASE("panels borrow the numbers of a neighbour only where their ranges and units are the same",
          "[plot][law]") {
  write_map("square.nc", {50, 50}, 2e-5, 2e-5);
  write_map("wide.nc", {50, 25}, 4e-5, 4e-5);  // 2 mm x 1 mm
  write_map("again.nc", {100, 100}, 1e-5, 1e-5);
  write_map("km.nc", {50, 50}, 20, 20);
  auto axes = [](const std::string& files, const char* columns) {
    REQUIRE(shell("asperity-plot --kind map " + files + " --columns " + columns + " -o own.svg").exit == 0);
    check_apart("own.svg");
    std::vector<std::string> out;
    std::istringstream words(words_of("own.svg"));
    for (std::string line; std::getline(words, line);)
      if (line.starts_with("x [") || line.starts_with("y [")) out.push_back(line);
    std::ranges::sort(out);
    return out;
  };
  using Words = std::vector<std::string>;
  CHECK(axes("square.nc again.nc --labels a,b", "2") == Words{"x [µm]", "x [µm]", "y [µm]"});
  CHECK(axes("square.nc again.nc --labels a,b", "1") == Words{"x [µm]", "y [µm]", "y [µm]"});
  CHECK(axes("square.nc km.nc --labels a,b", "2") == Words{"x [m]", "x [µm]", "y [m]", "y [µm]"});
  CHECK(axes("square.nc km.nc --labels a,b", "1") == Words{"x [m]", "x [µm]", "y [m]", "y [µm]"});
  CHECK(axes("wide.nc square.nc again.nc wide.nc --labels a,b,c,d", "2").size() == 8);
}

// 2.3456 mm ± 10 nm: the bar had numbers of eight digits, and the title said from 2.35 to 2.35 mm.
TEST_CASE("values that differ little are coloured from their mean, which the bar and the title name",
          "[plot][contract]") {
  for (const double level : {2.3456e-3, -2.3456e-3, 9e-6}) {
    Dataset data;
    set_grid(data, {{40, 40}, 1e-6, 1e-6});
    const Field wave = Field::NullaryExpr(
        40, 40, [](Index i, Index) { return 1e-8 * std::sin(static_cast<double>(i) * 0.05 * 3.14159265); });
    set_field(data, "heights", level + wave, {"m", "height"});
    write_dataset(data, "level.nc");
    REQUIRE(shell("asperity-plot level.nc --kind map -o level.svg").exit == 0);
    check_apart("level.svg");
    const std::string words = words_of("level.svg");
    if (level == 9e-6) {  // 2e-8 / 9e-6 is more than 1e-3
      CHECK_THAT(words, ContainsSubstring("height from 8.99 to 9.01 µm\n"));
      continue;
    }
    REQUIRE(shell("asperity-plot level.nc --kind surface -o seen.svg").exit == 0);
    CHECK_THAT(words_of("seen.svg"),
               ContainsSubstring(level < 0 ? "height + 2.3456 mm [nm]" : "height − 2.3456 mm [nm]"));
    const std::string named = level < 0 ? "above −2.3456 mm" : "above 2.3456 mm";
    CHECK_THAT(words, ContainsSubstring("height from −10 to 10 nm " + named + "\n") &&
                          ContainsSubstring("height " + named + " [nm]\n"));
  }
}

// Of x from −492 to 492 µm a narrow panel had the number 0 alone, and so had the sides of a surface.
TEST_CASE("every axis has two numbers at least where two have room", "[plot][law]") {
  for (const double half : {492.0, 41.5, 0.98, 1.2, 7.3})
    for (const double length : {9.0, 11.6, 15.0, 26.0}) {
      CAPTURE(half, length);
      CHECK(plot::tics_along({{-half, half}, "x"}, length).size() >= 2);
    }
  write_map("ninety.nc", {90, 220}, 1e-6, 1e-6);
  REQUIRE(shell("asperity-plot ninety.nc --kind surface -o a.svg").exit == 0);
  std::istringstream words(words_of("a.svg"));
  int numbers = 0;
  for (std::string line; std::getline(words, line);)
    numbers += line.find_first_not_of("−0123456789.") == line.npos ? 1 : 0;
  CHECK(numbers >= 6);
}
