// Ranges that are too narrow, too small or too large for a picture.
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "support.hpp"
#include "tools/plot/scale.hpp"

using namespace asperity;
using namespace asperity::plot;

namespace {

constexpr double ulp = std::numeric_limits<double>::epsilon(),
                 denormal = std::numeric_limits<double>::denorm_min();

}  // namespace

// From 1 to the next double a step of 5e-17 went on for ever: 1 / 5e-17 + 1 is the same number.
TEST_CASE("the multiples of a step are counted before they are made", "[scale][contract]") {
  const Range ranges[] = {{1, 1 + ulp}, {-1e308, 1e308}, {0, denormal}, {3e300, 3e300 * (1 + ulp)}, {0, 1}};
  for (const Range& range : ranges)
    for (const double step : {round_step(range.width(), 6), 1e-16, 0.0, denormal, std::nan("")}) {
      CAPTURE(range.low, range.high, step);
      CHECK(multiples(range, step).size() <= 1000);
    }
  CHECK(multiples({0, 1000}, 1).empty());
  CHECK(multiples({0, 999}, 1).size() == 1000);
}

TEST_CASE("a range that doubles hardly divide is drawn as a constant is, any other as it is",
          "[scale][contract]") {
  CHECK(drawable({1, 1 + ulp}).width() == Approx(0.1));
  CHECK(drawable({-2e-9, -2e-9 * (1 - ulp)}).width() == Approx(2e-10));
  CHECK(drawable({0, denormal}).width() == 1);
  CHECK(drawable({5, 5}).width() == Approx(0.5));
  for (const Range& whole : {Range{1, 1 + 1e-9}, Range{-1e-9, 1e-9}, Range{0, 1e-280}, Range{-1e300, 1e300}})
    CHECK(drawable(whole) == whole);
  for (const double huge : {1e308, HUGE_VAL, std::nan("")}) {
    CHECK_THROWS_AS(drawable({-huge, huge}), DataError);
    CHECK_THROWS_AS(about_zero({-huge, huge}), DataError);
    CHECK_THROWS_AS(one_sided({0, huge}), DataError);
  }
}
