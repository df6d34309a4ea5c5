#include "stats/filter/robust_gaussian.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/gaussian_filter.hpp"
#include "stats/filter/local_quadratic.hpp"
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
  const auto middle = sizes.begin() + std::ssize(sizes) / 2;
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

// (2); zero where a point is missing.
Field biweights(const Field& differences, double width) {
  return (differences.abs() < width).select((1 - (differences / width).square()).square(), 0);
}

// (1) with weights δ; where they leave nothing to fit, w keeps its former value.
class Regression {
 public:
  Regression(const Field& z, const Grid& grid, double cutoff, int order, int threads)
      : z_(z), grid_(grid), cutoff_(cutoff), order_(order), threads_(threads), sums_(grid, cutoff, threads) {}

  Field surface(const Field& delta, const Field& former) {
    if (order_ == 2) return local_quadratic(z_, delta, former, grid_, cutoff_, threads_);
    const Field sum = sums_.of(delta);
    return (sum > least_weight).select(sums_.of(delta * z_) / sum, former);
  }

 private:
  const Field& z_;
  Grid grid_;
  double cutoff_;
  int order_, threads_;
  GaussianSums sums_;
};

}  // namespace

RobustMeanSurface robust_gaussian_mean_surface(const Field& heights, const Grid& grid, double cutoff,
                                               int order, int threads, int most) {
  check_parameter(order == 0 || order == 2, "order", "'" + std::to_string(order) + "' is not 0 or 2");
  const double level = mean(heights);
  const Field z = heights - level, filled = zero_filled(z), valid = validity(z);
  Regression regression(filled, grid, cutoff, order, threads);
  RobustMeanSurface out{.surface = regression.surface(valid, Field::Zero(z.rows(), z.cols())), .steps = 1};
  while (!out.converged && out.steps < most) {
    ++out.steps;
    out.width = width_of_median * median_size(z - out.surface);
    const Field weights = biweights(z - out.surface, out.width),
                next = regression.surface(weights, out.surface);
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
