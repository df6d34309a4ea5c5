#include "stress/cell_sum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stress/corner_tile.hpp"

namespace asperity {
namespace {

using stress::Component;
using stress::Tensor;
using stress::Traction;

constexpr Index lanes = corner_lanes, most_rows = 8;
constexpr double beside = 1e-30;        // of a corner: on it an arc tangent is that of 0/0
constexpr double corners_cancel = 100;  // cells of depth, times the root of those loaded

}  // namespace

CellSum::CellSum(LoadedBody body, int threads)
    : grid_(body.grid),
      poisson_(body.poisson),
      deepest_(corners_cancel * std::min(grid_.dx, grid_.dy) *
               std::sqrt(static_cast<double>((body.pressure != 0).count()))),
      weights_(body.friction.weights()),
      points_(std::move(body), threads) {
  if (grid_.periodic.any()) return;
  const auto [nx, ny] = grid_.shape;
  const Field& load = points_.body().pressure;
  auto p = [&](Index i, Index j) { return i >= 0 && j >= 0 && i < nx && j < ny ? load(i, j) : 0.0; };
  for (Index i = 0; i <= nx; i += lanes)
    for (Index j = 0; j <= ny; j += most_rows) {
      const Index rows = std::min(most_rows, ny + 1 - j), i0 = std::max(i - 1, Index{0}),
                  j0 = std::max(j - 1, Index{0});
      if ((load.block(i0, j0, std::min(i + lanes, nx) - i0, std::min(j + rows, ny) - j0) == 0).all())
        continue;
      blocks_.push_back({i, j, rows, twists_.size()});
      for (Index n = j; n < j + rows; ++n)
        for (Index m = i; m < i + lanes; ++m)
          twists_.push_back(p(m, n) - p(m - 1, n) - p(m, n - 1) + p(m - 1, n - 1));
    }
}

void CellSum::add(const Block& b, double x, double y, double z, Tensor& sum) const {
  double X[lanes], Y[most_rows], values[3][6][lanes * most_rows], signed_twists[4][lanes * most_rows];
  double x_sign[lanes];
  double* out[3][6];
  for (Traction t : stress::tractions)
    for (Component c : stress::components) out[t][c] = weights_[t] == 0 ? nullptr : values[t][c];
  for (Index l = 0; l < lanes; ++l) {
    const double at = x / grid_.dx + 0.5 * static_cast<double>(grid_.shape.nx) - static_cast<double>(b.i + l);
    X[l] = std::max(std::abs(at), beside), x_sign[l] = at < 0 ? -1 : 1;
  }
  // By what turns the sign of a function: neither axis, y, x, both.
  const double* twist = twists_.data() + b.twists;
  for (Index j = 0; j < b.rows; ++j) {
    const double at = (y + 0.5 * grid_.size_y() - static_cast<double>(b.j + j) * grid_.dy) / grid_.dx,
                 y_sign = at < 0 ? -1 : 1;
    Y[j] = std::abs(at);
    for (Index l = 0; l < lanes; ++l) {
      const Index k = lanes * j + l;
      signed_twists[0][k] = twist[k], signed_twists[1][k] = y_sign * twist[k];
      signed_twists[2][k] = x_sign[l] * twist[k], signed_twists[3][k] = x_sign[l] * y_sign * twist[k];
    }
  }
  corner_tile(X, Y, b.rows, z / grid_.dx, poisson_, out);
  using Vector = Eigen::Map<const Eigen::VectorXd>;
  for (Traction t : stress::tractions)
    for (Component c : stress::components)
      if (weights_[t] != 0)
        sum[c] += weights_[t] *
                  Vector(out[t][c], lanes * b.rows)
                      .dot(Vector(signed_twists[2 * !odd_in_x(c, t) + !odd_in_y(c, t)], lanes * b.rows));
}

Tensor CellSum::at(double x, double y, double z) const {
  if (grid_.periodic.any() || z > deepest_) return points_.at(x, y, z);
  Tensor sum{};
  for (const Block& b : blocks_) add(b, x, y, z, sum);
  for (double& s : sum) s /= 2 * std::numbers::pi;
  return sum;
}

}  // namespace asperity
