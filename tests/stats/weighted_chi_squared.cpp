#include "stats/uncertainty/weighted_chi_squared.hpp"

#include <gsl/gsl_cdf.h>

#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// exp(-y) Σ yᵏ/k! over k < n/2, y = x/2, of n degrees, n even; erfc(√y) of one.
double chi_squared_exceedance(double x, int degrees) {
  if (degrees == 1) return std::erfc(std::sqrt(x / 2));
  double term = std::exp(-x / 2), sum = term;
  for (int k = 1; k < degrees / 2; ++k) sum += term *= x / 2 / k;
  return sum;
}

}  // namespace

// The rule's error, 4e-17 of the integrand, and the round-off of a hundred nodes, each of a K and an x s up
// to 100: 100 · 100 ε = 2e-12. 1e-10 is what the header says.
TEST_CASE("equal weights give the chi-squared law of as many degrees", "[weighted-chi-squared][exact]") {
  for (int degrees : {1, 2, 4, 12, 60})
    for (double weight : {1.0, 3e-7})
      for (double quantile : {0.01, 0.5, 0.95, 0.999, 1 - 1e-12}) {
        const double x = gsl_cdf_chisq_Pinv(quantile, degrees);
        const double p =
            weighted_chi_squared_exceedance(Eigen::ArrayXd::Constant(degrees, weight), weight * x);
        CAPTURE(degrees, weight, quantile);
        CHECK(relative_error(p, chi_squared_exceedance(x, degrees)) <= 1e-10);
      }
}

// Pairs a, a, b, b, c, c: Σ λ²/Π(λ - λ') exp(-x/2λ), a mixture of exponentials whose terms cancel to a tenth.
TEST_CASE("pairs of weights give the closed mixture of exponentials", "[weighted-chi-squared][exact]") {
  const double a = 1, b = 0.5, c = 0.3;
  Eigen::ArrayXd weights(6);
  weights << a, b, c, c, b, a;
  for (double x : {0.1, 1.0, 4.0, 10.0, 30.0, 200.0}) {
    auto term = [x](double l, double m, double n) {
      return l * l / ((l - m) * (l - n)) * std::exp(-x / 2 / l);
    };
    const double exact = term(a, b, c) + term(b, a, c) + term(c, a, b);
    CAPTURE(x);
    CHECK(relative_error(weighted_chi_squared_exceedance(weights, x), exact) <= 1e-10);
  }
}

// A² of a known Gaussian has the weights 1/(j(j+1)); its quantiles at 10 %, 5 % and 1 % are 1.932958,
// 2.492367 and 3.878125 (Marsaglia and Marsaglia, J. Stat. Softw. 9 (2004) 2). The weights beyond 400 are
// worth their mean, 1/401, and a variance of 2/(3·401³), 1e-8.
TEST_CASE("the weights 1/j(j+1) give the quantiles of Anderson and Darling",
          "[weighted-chi-squared][exact]") {
  const Eigen::ArrayXd weights = Eigen::ArrayXd::NullaryExpr(
      400, [](Eigen::Index j) { return 1 / static_cast<double>((j + 1) * (j + 2)); });
  for (auto [quantile, p] : {std::pair{1.932958, 0.10}, {2.492367, 0.05}, {3.878125, 0.01}})
    CHECK(std::abs(weighted_chi_squared_exceedance(weights, quantile - 1.0 / 401) - p) <= 1e-6);
}

TEST_CASE("no weight, or a value below zero, leaves no doubt", "[weighted-chi-squared][contract]") {
  CHECK(weighted_chi_squared_exceedance(Eigen::ArrayXd::Zero(3), 0.1) == 0);
  CHECK(weighted_chi_squared_exceedance(Eigen::ArrayXd::Ones(8), 0) == 1);
  CHECK(weighted_chi_squared_exceedance(Eigen::ArrayXd::Ones(8), 1e7) == 0);
}
