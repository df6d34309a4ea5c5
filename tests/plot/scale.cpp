#include "tools/plot/scale.hpp"

#include <cstdlib>

#include "support.hpp"
#include "tools/plot/gnuplot.hpp"

using namespace asperity;
using namespace asperity::plot;

namespace {

double linear(int byte) {
  const double c = byte / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// CIE 1976 lightness of an sRGB colour "#rrggbb" (IEC 61966-2-1).
double lightness(const std::string& colour) {
  const auto rgb = std::strtol(colour.c_str() + 1, nullptr, 16);
  const double y = 0.2126 * linear(static_cast<int>(rgb >> 16 & 255)) +
                   0.7152 * linear(static_cast<int>(rgb >> 8 & 255)) +
                   0.0722 * linear(static_cast<int>(rgb & 255));
  return 116 * std::cbrt(y) - 16;
}

}  // namespace

// Viridis is even in the lightness J' of CAM02-UCS, whose steps differ by up to a fifth in L*.
TEST_CASE("the sequential palette is viridis, from dark to light by like steps", "[palette][law]") {
  const auto& colours = control_colours(Palette::sequential);
  REQUIRE(colours.size() == 11);
  CHECK(colours.front() == "#440154");
  CHECK(colours[4] == "#2a788e");
  CHECK(colours.back() == "#fde725");
  const double step = (lightness(colours.back()) - lightness(colours.front())) / 10;
  CHECK(step >= 7);
  for (std::size_t k = 1; k < colours.size(); ++k) {
    CAPTURE(k);
    CHECK(std::abs(lightness(colours[k]) - lightness(colours[k - 1]) - step) <= 0.2 * step);
  }
}

// A byte of green, the channel that weighs most, is worth at most dL* = 0.9 where it is darkest; half a byte
// of rounding in each channel at either end of a step makes less than 1.
TEST_CASE("the diverging palette is as light at equal distances from its middle", "[palette][law]") {
  const auto& colours = control_colours(Palette::diverging);
  const std::size_t last = colours.size() - 1;
  for (std::size_t k = 0; k < last / 2; ++k) {
    CAPTURE(k);
    CHECK(std::abs(lightness(colours[k]) - lightness(colours[last - k])) <= 1);
    CHECK(std::abs(lightness(colours[k + 1]) - lightness(colours[k]) - 12.6) <= 1);
  }
}

TEST_CASE("a prefix brings a magnitude into 1 up to 1000", "[scale][exact]") {
  for (const auto& [magnitude, unit, name] : {std::tuple{3e-3, "m", "mm"},
                                              {0.4e-6, "m", "nm"},
                                              {1e-6, "m", "µm"},
                                              {3.6e9, "Pa", "GPa"},
                                              {999e6, "Pa", "MPa"},
                                              {3.0, "1", ""},
                                              {1e-13, "m", "nm"}}) {
    CAPTURE(magnitude);
    CHECK(unit_for(magnitude, unit).name == name);
  }
}

TEST_CASE("a step is the least of 1, 2, 5 times a power of ten that leaves no more steps than asked",
          "[scale][exact]") {
  CHECK(round_step(3, 6) == Approx(0.5));
  CHECK(round_step(3, 5.9) == Approx(1));
  CHECK(round_step(0.8, 4) == Approx(0.2));
  CHECK(round_step(1e-9, 3) == Approx(5e-10));
  CHECK(multiples({-1.1, 0.5}, 0.5).size() == 4);
}

TEST_CASE("heights are coloured over their range, pressures from zero, stresses evenly about zero",
          "[scale][exact]") {
  CHECK(sequential({0.1, 4}).range == Range{0.1, 4});
  CHECK(one_sided({0.1, 4}).range == Range{0, 4});
  CHECK(one_sided({3, 4}).range == Range{3, 4});
  CHECK(one_sided({2, 2}).range.width() > 0);
  CHECK(about_zero({-1, 3}).range == Range{-3, 3});
  CHECK(about_zero({-1, 3}).palette == Palette::diverging);
}

// In single quotes, doubled inside, gnuplot misread a text that begins or ends with one.
TEST_CASE("a quoted text ends where its quote ends, whatever it holds", "[gnuplot][contract]") {
  CHECK(gnuplot_string("it's `date` \"x\" \\") == R"("it\047s \140date\140 \042x\042 \134")");
  CHECK(gnuplot_string("a\nset output 'x'") == R"("a set output \047x\047")");
  CHECK(gnuplot_string("17 37.58 u") == R"("17 37\056\065\070 u")");
}
