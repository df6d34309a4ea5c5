#include "stats/filter/robust_gaussian.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/gaussian_filter.hpp"
#include "stats/filter/missing.hpp"

namespace asperity {
namespace {

constexpr double width_of_median = 4.4478;  // 3 × 1.4826, of (3)
constexpr double tolerance = 1e-4;          // of c
constexpr double least_weight = 1e-6;       // of Σ s δ: below, round-off of the sums would be divided by it

double median_size(const Field& differences) {
  std::vector<double> sizes;
  sizes.reserve(size(differences.size()));
  for (const double r : differences.reshaped<Eigen::RowMajor>())
    if (!std::isnan(r)) sizes.push_back(std::abs(r));
  const auto middle = sizes.begin() + std::ssize(sizes) / 2;
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

// (2); zero where a point is missing.
Field biweights(const Field& differences, double width) {
  return (differences.abs() < width).select((1 - (differences / width).square()).square(), 0);
}

}  // namespace

RobustMeanSurface robust_gaussian_mean_surface(const Field& heights, const Grid& grid, double cutoff,
                                               int order, int threads, int most) {
  check_parameter(order == 0, "order", "'" + std::to_string(order) + "' is not 0");
  GaussianSums sums(grid, cutoff, threads);
  const double level = mean(heights);
  const Field z = heights - level, filled = zero_filled(z), valid = validity(z);
  RobustMeanSurface out{.surface = sums.of(filled) / sums.of(valid).max(least_weight), .steps = 1};
  while (!out.converged && out.steps < most) {
    ++out.steps;
    out.width = width_of_median * median_size(z - out.surface);
    const Field weights = biweights(z - out.surface, out.width), sum = sums.of(weights);
    const Field next = (sum > least_weight).select(sums.of(weights * filled) / sum, out.surface);
    out.change = (valid * (next - out.surface)).abs().maxCoeff();
    out.surface = next;
    out.ignored = (valid * (weights == 0).select(Field::Ones(z.rows(), z.cols()), 0)).sum() / valid.sum();
    out.converged = out.change <= tolerance * out.width;
  }
  out.surface = (valid > 0).select(out.surface + level, NAN);
  return out;
}

}  // namespace asperity
