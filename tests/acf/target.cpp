#include "acf/target.hpp"

#include <limits>

#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

// One exponential, one logarithm and a square root: a few ε, times |ln level| < 5 in the exponent.
TEST_CASE("the exponential target is level at its lengths and 1/e at its decay lengths", "[target][exact]") {
  for (double level : {0.01, 0.1, 0.5}) {
    const ExponentialTarget target{17, 4, level};
    CHECK(target(0, 0) == 1);
    CHECK(relative_error(target(17, 0), level) <= 20 * epsilon);
    CHECK(relative_error(target(0, -4), level) <= 20 * epsilon);
    CHECK(relative_error(target(target.decay_length_x(), 0), std::exp(-1)) <= 20 * epsilon);
    CHECK(relative_error(target(0, target.decay_length_y()), std::exp(-1)) <= 20 * epsilon);
    CHECK(relative_error(target(17 * 0.6, 4 * 0.8), level) <= 20 * epsilon);  // on the same ellipse
  }
}

TEST_CASE("the default lags of 17 x 4 samples at 10 % are the least numbers above six decay lengths",
          "[target][exact]") {
  const ExponentialTarget target{17, 4};  // decay lengths 7.383 and 1.737
  CHECK(target.lags() == Shape{45, 11});
  CHECK(ExponentialTarget{0.01, 0.01}.lags() == Shape{1, 1});
}

TEST_CASE("a length or a level out of bounds is refused by its name", "[target][contract]") {
  auto refused = [](ExponentialTarget target) {
    try {
      target.check();
    } catch (const ParameterError& e) {
      return e.name;
    }
    return std::string();
  };
  CHECK(refused({17, 4}).empty());
  CHECK(refused({0, 4}) == "length");
  CHECK(refused({17, -4}) == "length");
  CHECK(refused({17, std::numeric_limits<double>::infinity()}) == "length");
  CHECK(refused({std::nan(""), 4}) == "length");
  CHECK(refused({17, 4, 0}) == "level");
  CHECK(refused({17, 4, 1}) == "level");
  CHECK(refused({17, 4, std::nan("")}) == "level");
}
