#include "stats/sample/ensemble.hpp"

#include "core/error.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

// 1 … n: mean (n+1)/2, variance n(n+1)/12. Numbers below 2^53 apart, so that an offset of 1e9 is exact; each
// of the n steps rounds by ε of the offset at most, less than n ε 1e9 = 2e-4 in the mean of spread 289.
TEST_CASE("the numbers 1 to n have mean (n+1)/2 and variance n(n+1)/12, on any offset", "[ensemble][exact]") {
  const double n = 1000;
  for (double offset : {0.0, 1e9}) {
    Ensemble ensemble;
    for (double x = 1; x <= n; ++x) ensemble.add(Eigen::ArrayXd::Constant(1, offset + x));
    const double rounding = n * epsilon * (offset + n);
    const double variance = n * (n + 1) / 12;
    CHECK(std::abs(ensemble.mean()(0) - offset - (n + 1) / 2) <= rounding);
    CHECK(std::abs(ensemble.spread()(0) - std::sqrt(variance)) <= rounding);
    CHECK(std::abs(ensemble.standard_error()(0) - std::sqrt(variance / n)) <= rounding);
  }
}

TEST_CASE("a realisation without a quantity counts for the others only", "[ensemble][contract]") {
  Ensemble ensemble;
  ensemble.add(Eigen::Array3d(1, NAN, NAN));
  ensemble.add(Eigen::Array3d(3, 7, NAN));
  CHECK(ensemble.count()(0) == 2);
  CHECK(ensemble.count()(1) == 1);
  CHECK(ensemble.mean()(0) == 2);
  CHECK(ensemble.mean()(1) == 7);
  CHECK(ensemble.spread()(0) == Approx(std::sqrt(2)).epsilon(1e-15));
  CHECK(std::isnan(ensemble.spread()(1)));
  CHECK(std::isnan(ensemble.mean()(2)));
  CHECK_THROWS_AS(ensemble.add(Eigen::Array2d(1, 2)), DataError);
}
