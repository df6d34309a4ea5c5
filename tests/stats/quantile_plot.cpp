#include <gsl/gsl_cdf.h>

#include "core/error.hpp"
#include "fields.hpp"
#include "stats/height/material_ratio.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

EffectiveSampleSize independent(const Grid& g) {
  return EffectiveSampleSize(triangular_correlation({1, 1}), g);
}

}  // namespace

// The heights are the quantiles at k/(N-1), between which the curve is straight; so is Φ⁻¹ to second order.
TEST_CASE("heights that are a Gaussian's quantiles lie on the line", "[quantile-plot][exact]") {
  const Index n = 10001;
  const Field z = Field::NullaryExpr(1, n, [&](Index, Index i) {
    return 5 +
           2 * gsl_cdf_ugaussian_Pinv((static_cast<double>(i) + 1e-9) / (static_cast<double>(n) - 1 + 2e-9));
  });
  const auto points = quantile_plot(MaterialRatioCurve(z), {.mean = 5, .sq = 2}, independent(grid(1, n)), 20);
  CHECK(points.size() == 20);
  CHECK(points[0].share == 0.025);
  for (const QuantilePoint& point : points) {
    CHECK(std::abs(point.gaussian - (5 + 2 * point.normal)) <= 1e-14);
    CHECK(std::abs(point.height - point.gaussian) <= 1e-6);
  }
}

// All S_k are 1: p(1-p)/φ² - 1 about the mean, and x²/2 less about the line.
TEST_CASE("independent heights stray by Bahadur's error, less what a fitted mean and Sq explain",
          "[quantile-plot][exact]") {
  const Field z = white_noise({20, 20}, 41);
  for (const QuantilePoint& q :
       quantile_plot(MaterialRatioCurve(z), {.sq = 2}, independent(grid(20, 20)), 10)) {
    const double density = std::exp(-q.normal * q.normal / 2) / std::sqrt(2 * std::numbers::pi);
    const double all = q.share * (1 - q.share) / (density * density) - 1;
    CHECK(relative_error(q.height_error, 2 * std::sqrt(all / 400)) <= 1e-10);
    CHECK(relative_error(q.misfit_error, 2 * std::sqrt((all - q.normal * q.normal / 2) / 400)) <= 1e-9);
  }
}

// 500 fields: each mean square is 1 with a spread of √(2/500) = 6.3 %, four of them, and 10 % of second
// order.
TEST_CASE("a correlated Gaussian field strays from its line by one error at each quantile",
          "[quantile-plot][statistics]") {
  const Shape window{4, 4};
  const Grid g = grid(56, 56);
  const EffectiveSampleSize size(triangular_correlation(window), g);
  std::vector<Spread> misfit(8);
  for (unsigned seed = 0; seed < 500; ++seed) {
    const Field z = moving_average(g.shape, window, seed);
    const auto points = quantile_plot(MaterialRatioCurve(z), moments(z), size, 8);
    for (std::size_t i = 0; i < points.size(); ++i)
      misfit[i].add(std::pow((points[i].height - points[i].gaussian) / points[i].misfit_error, 2));
  }
  for (const Spread& square : misfit) CHECK(square.mean() == Approx(1).margin(0.35));
}

TEST_CASE("a plot of no quantile is refused", "[quantile-plot][contract]") {
  const Field z = white_noise({9, 9}, 42);
  CHECK_THROWS_AS(quantile_plot(MaterialRatioCurve(z), moments(z), independent(grid(9, 9)), 0),
                  ParameterError);
}
