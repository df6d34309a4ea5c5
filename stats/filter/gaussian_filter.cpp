#include "stats/filter/gaussian_filter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/missing.hpp"
#include "transform/convolution.hpp"

namespace asperity {
namespace {

constexpr double reach = 1.65;  // of the weight in cut-offs: there exp(-π(1.65/α)²) is below 1e-16

// The weights along one axis of n samples, 0, 1, … samples away, cut at the reach and where the axis ends.
Eigen::ArrayXd weights(Index n, double step, double cutoff) {
  constexpr double ln2 = std::numbers::ln2, pi = std::numbers::pi;
  const double count = std::min(std::ceil(reach * cutoff / step), static_cast<double>(n));
  Eigen::ArrayXd w = Eigen::ArrayXd::NullaryExpr(static_cast<Index>(count), [=](Index k) {
    const double x = static_cast<double>(k) * step / cutoff;
    return std::exp(-pi * pi * x * x / ln2);
  });
  return w / (2 * w.sum() - w[0]);
}

// One axis: its torus, the weights' transform, and how much of the weights about each sample lies within.
struct AxisAverage {
  Index torus;
  Eigen::ArrayXd symbol, inside;
};

// Every wave by (2).
AxisAverage periodic_axis(Index n, double step, double cutoff) {
  const double ratio = cutoff / (static_cast<double>(n) * step);
  auto transmission = [=](Index k) { return std::exp2(-std::pow(ratio * static_cast<double>(k), 2)); };
  return {n, Eigen::ArrayXd::NullaryExpr(n / 2 + 1, transmission), Eigen::ArrayXd::Ones(n)};
}

// On a length on which n samples meet nothing that has wrapped around.
AxisAverage open_axis(Index n, double step, double cutoff) {
  const Eigen::ArrayXd w = weights(n, step, cutoff);
  const Index torus = fast_length(n + w.size() - 1, 2);
  auto weight = [&](Index i, Index k) { return i == 0 && k < w.size() ? w[k] : 0; };
  Eigen::ArrayXd below =
      Eigen::ArrayXd::Zero(n + 1);  // Σ of those less than k samples away on one side, w_0 by half
  below[0] = -w[0] / 2;
  for (Index k = 0; k < n; ++k) below[k + 1] = below[k] + weight(0, k);
  return {torus, even_transfer_function({2, torus}, weight).row(0),
          Eigen::ArrayXd::NullaryExpr(n, [&](Index i) { return below[i + 1] + below[n - i]; })};
}

AxisAverage axis_average(Index n, double step, bool periodic, double cutoff) {
  return periodic ? periodic_axis(n, step, cutoff) : open_axis(n, step, cutoff);
}

// Sums under the weight (1) over the points of a field, and along periodic axes over their images.
class GaussianSums {
 public:
  GaussianSums(const Grid& grid, double cutoff, int threads) {
    check_cutoff(grid, cutoff);
    const AxisAverage x = axis_average(grid.shape.nx, grid.dx, grid.periodic.x, cutoff),
                      y = axis_average(grid.shape.ny, grid.dy, grid.periodic.y, cutoff);
    sums_.emplace(grid.shape, Shape{x.torus, y.torus}, x.symbol.matrix() * y.symbol.matrix().transpose(),
                  threads);
    inside_x_ = x.inside, inside_y_ = y.inside;
  }

  // Σ s z about each point; no point is missing.
  Field of(Field z) {
    sums_->apply(z, z);
    return z;
  }
  // Σ s z / Σ s.
  Field mean(Field z) {
    z = of(std::move(z));
    for (Index i = 0; i < z.rows(); ++i) z.row(i) /= inside_x_[i] * inside_y_.transpose();
    return z;
  }

 private:
  std::optional<EvenConvolution> sums_;
  Eigen::ArrayXd inside_x_, inside_y_;  // Σ s along each axis
};

}  // namespace

void check_cutoff(const Grid& grid, double cutoff) {
  if (!(cutoff > 0 && std::isfinite(cutoff)))
    throw ParameterError("cut-off", "'" + in_digits(cutoff, 12) + " m' is not a positive length");
  for (const auto& [axis, n, spacing] :
       {std::tuple{"x", grid.shape.nx, grid.dx}, std::tuple{"y", grid.shape.ny, grid.dy}})
    if (n > 1 && cutoff < 2 * spacing)
      throw ParameterError("cut-off", "'" + in_digits(cutoff, 12) + " m' is below two samples along " + axis +
                                          ", " + in_digits(2 * spacing, 12) + " m");
}

Field gaussian_mean_surface(const Field& z, const Grid& grid, double cutoff, int threads) {
  GaussianSums sums(grid, cutoff, threads);
  const double level = mean(z);
  if (!has_missing(z)) {
    Field out = sums.mean(z - level);
    out += level;
    return out;
  }
  const Field valid = validity(z);
  return (valid > 0).select(sums.of(zero_filled(z - level)) / sums.of(valid), NAN) + level;
}

}  // namespace asperity
