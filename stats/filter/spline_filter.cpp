#include "stats/filter/spline_filter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/gaussian_filter.hpp"
#include "stats/filter/missing.hpp"
#include "transform/convolution.hpp"

namespace asperity {
namespace {

constexpr double residual = 1e-12;  // of (3)
constexpr int most_steps = 2000;

double fourth_power_of_alpha(double step, double cutoff) {
  return std::pow(2 * std::sin(std::numbers::pi * step / cutoff), -4);
}

// (1) along the rows of a field of n rows, a free axis: 1 + α⁴ DᵀD = L diag(d) Lᵀ with two bands in L.
class FreeAxis {
 public:
  FreeAxis(Index n, double alpha4) : d_(n), first_(n), second_(n) {
    Eigen::ArrayXd diagonal = Eigen::ArrayXd::Ones(n), below = Eigen::ArrayXd::Zero(n);
    for (Index k = 1; k + 1 < n; ++k) {  // a row 1, -2, 1 of D
      diagonal[k - 1] += alpha4, diagonal[k] += 4 * alpha4, diagonal[k + 1] += alpha4;
      below[k] -= 2 * alpha4, below[k + 1] -= 2 * alpha4;
    }
    first_.setZero(), second_.setZero();
    for (Index i = 0; i < n; ++i) {
      if (i > 1) second_[i] = alpha4 / d_[i - 2];
      if (i > 0) first_[i] = (below[i] - (i > 1 ? alpha4 * first_[i - 1] : 0)) / d_[i - 1];
      d_[i] = diagonal[i];
      if (i > 0) d_[i] -= first_[i] * first_[i] * d_[i - 1];
      if (i > 1) d_[i] -= second_[i] * alpha4;
    }
  }

  void solve(Eigen::Ref<Field, 0, Eigen::OuterStride<>> z) const {
    const Index n = z.rows();
    for (Index i = 1; i < n; ++i) {
      z.row(i) -= first_[i] * z.row(i - 1);
      if (i > 1) z.row(i) -= second_[i] * z.row(i - 2);
    }
    for (Index i = n - 1; i >= 0; --i) {
      z.row(i) /= d_[i];
      if (i + 1 < n) z.row(i) -= first_[i + 1] * z.row(i + 1);
      if (i + 2 < n) z.row(i) -= second_[i + 2] * z.row(i + 2);
    }
  }

 private:
  Eigen::ArrayXd d_, first_, second_;
};

Field solved_along_rows(Field z, const FreeAxis& axis, int threads) {
  parallel_ranges(z.cols(), threads,
                  [&](Index begin, Index end, int) { axis.solve(z.middleCols(begin, end - begin)); });
  return z;
}

// (2) of the waves of a periodic axis; along a free one all pass.
Eigen::ArrayXd transmission(Index n, bool periodic, double alpha4) {
  return Eigen::ArrayXd::NullaryExpr(n / 2 + 1, [=](Index k) {
    if (!periodic) return 1.0;
    const double s = std::sin(std::numbers::pi * static_cast<double>(k) / static_cast<double>(n));
    return 1 / (1 + 16 * alpha4 * std::pow(s, 4));
  });
}

// ((1 + α_x⁴ Q_x)(1 + α_y⁴ Q_y))⁻¹.
class Spline {
 public:
  Spline(const Grid& grid, double cutoff, int threads) : grid_(grid), threads_(threads) {
    const auto [nx, ny] = grid.shape;
    const double of_x = fourth_power_of_alpha(grid.dx, cutoff), of_y = fourth_power_of_alpha(grid.dy, cutoff);
    if (!grid.periodic.x) x_.emplace(nx, of_x);
    if (!grid.periodic.y) y_.emplace(ny, of_y);
    if (grid.periodic.any())
      waves_.emplace(grid.shape, grid.shape,
                     Field(transmission(nx, grid.periodic.x, of_x).matrix() *
                           transmission(ny, grid.periodic.y, of_y).matrix().transpose()),
                     threads);
  }

  Field solve(Field z) {
    if (waves_) waves_->apply(z, z);
    if (x_) z = solved_along_rows(std::move(z), *x_, threads_);
    if (y_) z = solved_along_rows(z.transpose(), *y_, threads_).transpose();
    return z;
  }

 private:
  Grid grid_;
  int threads_;
  std::optional<FreeAxis> x_, y_;
  std::optional<EvenConvolution> waves_;
};

double dot(const Field& a, const Field& b) { return (a * b).rowwise().sum().sum(); }

// (3) by conjugate gradients, preconditioned by the equation without missing points, A. A p follows from the
// recurrence of p, so that A itself is never applied.
Field over_valid(Spline& spline, const Field& z) {
  const Field valid = validity(z);
  Field w = Field::Zero(z.rows(), z.cols()), r = zero_filled(z), p = w, Ap = w;
  double before = 0, first = 0;
  for (int step = 0; step < most_steps; ++step) {
    const Field y = spline.solve(r);
    const double now = dot(r, y);
    if (step == 0) first = now;
    if (!(now > residual * residual * first)) return w;
    const double beta = step == 0 ? 0 : now / before;
    p = y + beta * p;
    Ap = r + beta * Ap;
    const Field image = Ap - (1 - valid) * p;
    const double length = now / dot(p, image);
    w += length * p;
    r -= length * image;
    before = now;
  }
  throw DataError("heights", "the spline filter has not converged over the missing points: fill them first");
}

}  // namespace

Field spline_mean_surface(const Field& z, const Grid& grid, double cutoff, int threads) {
  check_cutoff(grid, cutoff);
  Spline spline(grid, cutoff, threads);
  const double level = mean(z);
  if (!has_missing(z)) return spline.solve(z - level) + level;
  return z.isNaN().select(NAN, over_valid(spline, z - level) + level);
}

}  // namespace asperity
