#include "acf/target.hpp"

#include <limits>

#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

EllipticTarget exponential(double length_x, double length_y, double level = 0.1) {
  return {Model::exponential, length_x, length_y, level};
}

}  // namespace

// One exponential, one logarithm and a square root: a few ε, times |ln level| < 5 in the exponent.
TEST_CASE("the exponential target is level at its lengths and 1/e at its decay lengths", "[target][exact]") {
  for (double level : {0.01, 0.1, 0.5}) {
    const Target target = exponential(17, 4, level).target();
    CHECK(target(0, 0) == 1);
    CHECK(relative_error(target(17, 0), level) <= 20 * epsilon);
    CHECK(relative_error(target(0, -4), level) <= 20 * epsilon);
    CHECK(relative_error(target(17 / -std::log(level), 0), std::exp(-1)) <= 20 * epsilon);
    CHECK(relative_error(target(0, 4 / -std::log(level)), std::exp(-1)) <= 20 * epsilon);
    CHECK(relative_error(target(17 * 0.6, 4 * 0.8), level) <= 20 * epsilon);  // on the same ellipse
  }
}

TEST_CASE("17 x 4 samples at 10 % reach six decay lengths in the least numbers of lags above these",
          "[target][exact]") {
  const double six_decays = std::exp(-6);  // decay lengths 7.383 and 1.737
  CHECK(exponential(17, 4).target().reach(six_decays) == Shape{45, 11});
  CHECK(exponential(0.01, 0.01).target().reach(six_decays) == Shape{1, 1});
}

TEST_CASE("a length or a level out of bounds is refused by its name", "[target][contract]") {
  auto refused = [](const EllipticTarget& target) {
    try {
      target.check();
    } catch (const ParameterError& e) {
      return e.name;
    }
    return std::string();
  };
  CHECK(refused(exponential(17, 4)).empty());
  CHECK(refused(exponential(0, 4)) == "length");
  CHECK(refused(exponential(17, -4)) == "length");
  CHECK(refused(exponential(17, std::numeric_limits<double>::infinity())) == "length");
  CHECK(refused(exponential(std::nan(""), 4)) == "length");
  CHECK(refused(exponential(17, 4, 0)) == "length-level");
  CHECK(refused(exponential(17, 4, 1)) == "length-level");
  CHECK(refused(exponential(17, 4, std::nan(""))) == "length-level");
}
