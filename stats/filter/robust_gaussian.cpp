#include "stats/filter/robust_gaussian.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/gaussian_sums.hpp"
#include "stats/filter/missing.hpp"

namespace asperity {
namespace {

constexpr double width_of_median = 4.4478;  // 3 × 1.4826, of (3)
constexpr double tolerance = 1e-3;          // of c
constexpr double least_weight = 1e-6;       // of Σ s δ: below, round-off of the sums would be divided by it

double median_size(const Field& differences) {
  std::vector<double> sizes;
  sizes.reserve(size(differences.size()));
  for (const double r : differences.reshaped<Eigen::RowMajor>())
    if (!std::isnan(r)) sizes.push_back(std::abs(r));
  if (sizes.empty()) return 0;
  const auto middle = sizes.begin() + std::ssize(sizes) / 2;
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

// (2); zero where a point is missing.
Field biweights(const Field& differences, double width) {
  return (differences.abs() < width).select((1 - (differences / width).square()).square(), 0);
}

// (1) with weights δ; where they leave nothing to fit, w keeps its former value.
Field regression(GaussianSums& sums, const Field& z, const Field& delta, const Field& former) {
  const Field sum = sums.of(delta);
  return (sum > least_weight).select(sums.of(delta * z) / sum, former);
}

}  // namespace

RobustMeanSurface robust_gaussian_mean_surface(const Field& heights, const Grid& grid, double cutoff,
                                               int threads, int most) {
  const double level = mean(heights);
  const Field z = heights - level, filled = zero_filled(z), valid = validity(z);
  GaussianSums sums(grid, cutoff, threads);
  RobustMeanSurface out{.surface = regression(sums, filled, valid, Field::Zero(z.rows(), z.cols())),
                        .steps = 1};
  while (!out.converged && out.steps < most) {
    ++out.steps;
    out.width = width_of_median * median_size(z - out.surface);
    const Field weights = biweights(z - out.surface, out.width),
                next = regression(sums, filled, weights, out.surface);
    const Field moves = valid * (next - out.surface);
    out.change = std::sqrt(moves.square().sum() / valid.sum());
    out.largest = moves.abs().maxCoeff();
    out.surface = next;
    out.ignored = (valid * (weights == 0).select(Field::Ones(z.rows(), z.cols()), 0)).sum() / valid.sum();
    out.converged = out.change <= tolerance * out.width;
  }
  out.surface = (valid > 0).select(out.surface + level, NAN);
  return out;
}

}  // namespace asperity
