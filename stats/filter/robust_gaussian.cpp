#include "stats/filter/robust_gaussian.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/local_quadratic.hpp"
#include "stats/filter/missing.hpp"

namespace asperity {
namespace {

constexpr double width_of_median = 4.4478;  // 3 × 1.4826, of (3)
constexpr double tolerance = 1e-3 / 3;      // of c
constexpr double round_off = 1e-12;         // of the largest height

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

}  // namespace

RobustMeanSurface robust_gaussian_mean_surface(const Field& heights, const Grid& grid, double cutoff,
                                               int threads, int most) {
  const double level = mean(heights);
  const Field z = heights - level, filled = zero_filled(z), valid = validity(z);
  const LocalQuadratic regression(grid, cutoff, threads);
  const double least = round_off * filled.abs().maxCoeff();
  RobustMeanSurface out{.surface = regression(filled, valid, filled), .steps = 1};
  while (!out.converged && out.steps < most) {
    ++out.steps;
    out.width = width_of_median * median_size(z - out.surface);
    const Field weights = biweights(z - out.surface, out.width),
                next = regression(filled, weights, out.surface);
    const Field moves = valid * (next - out.surface);
    out.change = std::sqrt(moves.square().sum() / valid.sum());
    out.largest = moves.abs().maxCoeff();
    out.surface = next;
    out.ignored = (valid * (weights == 0).select(Field::Ones(z.rows(), z.cols()), 0)).sum() / valid.sum();
    out.converged = out.change <= std::max(tolerance * out.width, least);
  }
  out.surface = (valid > 0).select(out.surface + level, NAN);
  return out;
}

}  // namespace asperity
