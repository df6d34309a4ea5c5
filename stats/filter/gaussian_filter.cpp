#include "stats/filter/gaussian_filter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/missing.hpp"
#include "transform/convolution.hpp"

namespace asperity {
namespace {

constexpr double reach = 1.65;  // of the weight in cut-offs: there exp(-π(1.65/α)²) is below 1e-16

// The weights along one axis of n samples, 0, 1, … samples away, cut at the reach and where the axis ends.
class Weights {
 public:
  Weights(Index n, double step, double cutoff) {
    constexpr double ln2 = std::numbers::ln2, pi = std::numbers::pi;
    const double count = std::min(std::ceil(reach * cutoff / step), static_cast<double>(n));
    w_ = Eigen::ArrayXd::NullaryExpr(static_cast<Index>(count), [=](Index k) {
      const double x = static_cast<double>(k) * step / cutoff;
      return std::exp(-pi * pi * x * x / ln2);
    });
    w_ /= 2 * w_.sum() - w_[0];
  }

  double operator()(Index k) const { return k < w_.size() ? w_[k] : 0; }
  /// A length on which n samples meet nothing that has wrapped around.
  Index padded(Index n) const { return fast_length(n + w_.size() - 1, 2); }
  /// How much of the weights about each of n samples lies within them.
  Eigen::ArrayXd inside(Index n) const {
    Eigen::ArrayXd below(n + 1);  // Σ of those less than k samples away on one side, w_0 by half
    below[0] = -w_[0] / 2;
    for (Index k = 0; k < n; ++k) below[k + 1] = below[k] + (*this)(k);
    return Eigen::ArrayXd::NullaryExpr(n, [&](Index i) { return below[i + 1] + below[n - i]; });
  }

 private:
  Eigen::ArrayXd w_;
};

EvenConvolution open_average(const Grid& grid, const Weights& along_x, const Weights& along_y, int threads) {
  const Shape torus{along_x.padded(grid.shape.nx), along_y.padded(grid.shape.ny)};
  auto weight = [&](Index i, Index j) { return along_x(i) * along_y(j); };
  return {grid.shape, torus, even_transfer_function(torus, weight, threads), threads};
}

// Every wave by (2).
EvenConvolution periodic_average(const Grid& grid, double cutoff, int threads) {
  const double rx = cutoff / grid.size_x(), ry = cutoff / grid.size_y();
  const Field transmission =
      Field::NullaryExpr(grid.shape.nx / 2 + 1, grid.shape.ny / 2 + 1, [=](Index k, Index l) {
        const double x = rx * static_cast<double>(k), y = ry * static_cast<double>(l);
        return std::exp2(-(x * x + y * y));
      });
  return {grid.shape, grid.shape, transmission, threads};
}

// With weights divided by what of them falls on points that are there; missing points stay missing.
Field over_valid(EvenConvolution& average, const Field& heights) {
  const Field valid = validity(heights);
  Field sum, weight;
  average.apply(zero_filled(heights), sum);
  average.apply(valid, weight);
  return (valid > 0).select(sum / weight, NAN);
}

}  // namespace

Field gaussian_mean_surface(const Field& z, const Grid& grid, double cutoff, int threads) {
  const double least = 2 * std::max(grid.dx, grid.dy);
  if (!(cutoff >= least && std::isfinite(cutoff)))
    throw ParameterError("cut-off", "'" + shortest(cutoff) + " m' is not finite or is below two samples, " +
                                        shortest(least) + " m");
  const double level = mean(z);
  const Field heights = z - level;
  const Weights along_x(grid.shape.nx, grid.dx, cutoff), along_y(grid.shape.ny, grid.dy, cutoff);
  EvenConvolution average = grid.periodic.both() ? periodic_average(grid, cutoff, threads)
                                                 : open_average(grid, along_x, along_y, threads);
  if (has_missing(z)) return over_valid(average, heights) + level;
  Field out;
  average.apply(heights, out);
  if (!grid.periodic.both()) {
    out.colwise() /= along_x.inside(grid.shape.nx);
    out.rowwise() /= along_y.inside(grid.shape.ny).transpose();
  }
  return out + level;
}

}  // namespace asperity
