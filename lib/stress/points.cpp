#include "stress/points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"
#include "stress/corner.hpp"
#include "stress/images.hpp"
#include "stress/influence.hpp"

namespace asperity {
namespace {

using stress::Component;
using stress::Tensor;
using stress::Traction;

constexpr double on_a_side = 1e-9;        // of a side: coordinates have this much round-off
constexpr double step_that_shows = 1e-3;  // of the largest pressure: times ln(1e9)/π, 0.7 % of it
constexpr double faded = 40;              // qz of a mode of which (1 + qz) e^-qz = 2e-16 is left
constexpr double uniform = 1e-14;         // of the mean of a row
constexpr Index most_rows = 8;            // of corners at once
constexpr double off_corner = 1e-30;      // of a corner: on it an arc tangent is that of 0/0
constexpr double corners_cancel = 100;    // cells of depth, times the root of those loaded

// exp(i 2π k share) for k = 0 … n/2; of k = n/2 half, for its two directions.
Eigen::ArrayXcd waves(Index n, double share) {
  return Eigen::ArrayXcd::NullaryExpr(n / 2 + 1, [=](Index k) {
    return std::polar(2 * k == n ? 0.5 : 1.0,
                      2 * std::numbers::pi * std::remainder(static_cast<double>(k) * share, 1));
  });
}

void add(Tensor& sum, double factor, const Tensor& s) {
  for (Component c : stress::components) sum[c] += factor * s[c];
}

// The modes (±kx, ky), with the waves of the place, for even symbols and for odd ones.
struct Pair {
  Complex even, odd;
};

void add(const Pair& p, const stress::Wave& wave, const LoadWeights& weights, Tensor& sum) {
  for (Traction t : stress::tractions) {
    if (weights[t] == 0) continue;
    for (Component c : stress::components) {
      const Complex& z = odd_in_x(c, t) ? p.odd : p.even;
      const double part[] = {z.real(), z.imag(), -z.real()};  // of (-i)^m z
      sum[c] += weights[t] * wave(t, c) * part[odd_in_x(c, t) + odd_in_y(c, t)];
    }
  }
}

// Likewise of a row of modes kx.
void add_row(const Eigen::ArrayXcd& even, const Eigen::ArrayXcd& odd,
             const stress::Waves<Eigen::ArrayXd>& wave, const LoadWeights& weights, Tensor& sum) {
  for (Traction t : stress::tractions) {
    if (weights[t] == 0) continue;
    for (Component c : stress::components) {
      const Eigen::ArrayXcd& z = odd_in_x(c, t) ? odd : even;
      const int turns = odd_in_x(c, t) + odd_in_y(c, t);
      Eigen::ArrayXd part = z.real();
      if (turns == 1) part = z.imag();
      sum[c] += (turns == 2 ? -weights[t] : weights[t]) * (wave(t, c) * part).sum();
    }
  }
}

}  // namespace

// A point along an axis of cells. Within round-off of a side it is half a side away from the middles of both
// cells, so that neither, or both, would take it for a point of their own.
struct StressPoints::Axis {
  double at, spacing;
  Index cells;
  double sides = at / spacing + 0.5 * static_cast<double>(cells);  // from the first one
  bool on_side = std::abs(sides - std::round(sides)) <= on_a_side && std::round(sides) >= 0 &&
                 std::round(sides) <= static_cast<double>(cells);

  bool within() const { return sides > -0.5 && sides < static_cast<double>(cells) + 0.5; }
  // The one that holds the point, or the one beyond its side.
  Index cell() const { return static_cast<Index>(on_side ? std::round(sides) : std::floor(sides)); }
  double size() const { return static_cast<double>(cells) * spacing; }
  // From the middle of a cell.
  double from(Index i) const {
    return on_side ? (static_cast<double>(cell() - i) - 0.5) * spacing
                   : at - ((static_cast<double>(i) + 0.5) * spacing - 0.5 * size());
  }
  // From that of its image m periods on, the nearest one being m = 0.
  double from_image(Index i, int m) const {
    if (!on_side) return std::remainder(from(i), size()) + m * size();
    const auto halves = static_cast<double>(2 * (cell() - i) - 1), period = static_cast<double>(2 * cells);
    return 0.5 * (std::remainder(halves, period) + m * period) * spacing;
  }
};

StressPoints::StressPoints(LoadedBody body, int threads)
    : body_(std::move(body)), weights_(body_.friction.weights()) {
  body_.check();
  if (body_.grid.periodic.both()) modes_.emplace(body_, 1, threads);
}

Tensor StressPoints::at(double x, double y, double z) const {
  if (!(std::abs(x) <= farthest && std::abs(y) <= farthest))
    throw ParameterError("place", fmt::format("({}, {}) m is farther than {:g} m", x, y, farthest));
  check_depth(z);
  if (body_.grid.periodic.both()) return below_waves(x, y, z);
  return body_.grid.periodic.any() ? below_images(x, y, z) : below_cells(x, y, z);
}

// At a place seen from the middle of a cell of these half sides, under its pressure and tractions.
Tensor StressPoints::of_cell(double x, double y, double z, double a, double b) const {
  Tensor sum{};
  for (Traction t : stress::tractions)
    if (weights_[t] != 0) add(sum, weights_[t], uniform_load_stress(x, y, z, a, b, body_.poisson, t));
  return sum;
}

std::array<StressPoints::Axis, 2> StressPoints::axes(double x, double y) const {
  const Grid& grid = body_.grid;
  if (grid.periodic.x) x = std::remainder(x, grid.size_x());
  if (grid.periodic.y) y = std::remainder(y, grid.size_y());
  return {Axis{x, grid.dx, grid.shape.nx}, Axis{y, grid.dy, grid.shape.ny}};
}

// The mean along the periodic axis of the cells with the k-th place across; 0 beyond the domain.
double StressPoints::mean_at(Index k) const {
  const bool in_x = body_.grid.periodic.x;
  if (k < 0 || k >= (in_x ? body_.pressure.cols() : body_.pressure.rows())) return 0;
  return in_x ? body_.pressure.col(k).mean() : body_.pressure.row(k).mean();
}

bool StressPoints::singular(double x, double y, double z) const {
  const Grid& grid = body_.grid;
  const auto [along_x, along_y] = axes(x, y);
  const bool surface = z <= on_a_side * std::min(grid.dx, grid.dy);
  if (grid.periodic.both() || !surface || !along_x.within() || !along_y.within()) return false;
  const bool on_x = along_x.on_side, on_y = along_y.on_side;
  const Index i = along_x.cell(), j = along_y.cell();
  const double step = step_that_shows * body_.pressure.maxCoeff(), here = body_.at(i, j),
               left = body_.at(i - 1, j), under = body_.at(i, j - 1), across = body_.at(i - 1, j - 1);
  auto steps = [&](double difference) { return std::abs(difference) > step; };
  if (on_x && on_y && body_.poisson < 0.5 && steps(here - left - under + across)) return true;
  if (body_.friction.coefficient == 0) return false;
  const Periodic along = grid.periodic;  // (2) has the steps of the means too
  if (along.one() && (along.x ? on_y : on_x) &&
      steps(mean_at(along.x ? j : i) - mean_at((along.x ? j : i) - 1)))
    return true;
  return (on_x && steps(here - left)) || (on_y && steps(here - under)) ||
         (on_x && on_y && (steps(under - across) || steps(left - across)));
}

Tensor StressPoints::below_cells(double x, double y, double z) const {
  const Grid& grid = body_.grid;
  const auto [along_x, along_y] = axes(x, y);
  Tensor sum{};
  for (Index i = 0; i < grid.shape.nx; ++i)
    for (Index j = 0; j < grid.shape.ny; ++j)
      if (const double p = body_.pressure(i, j); p != 0)
        add(sum, p, of_cell(along_x.from(i), along_y.from(j), z, grid.dx / 2, grid.dy / 2));
  return sum;
}

// S of stress/images.hpp.
Tensor StressPoints::of_images(const Axis& along, Index cell, double across, double z) const {
  const double a = body_.grid.dx / 2, b = body_.grid.dy / 2;
  Tensor sum{};
  for (int m = -image_periods; m <= image_periods; ++m) {
    const double at = along.from_image(cell, m), weight = image_weight(at / along.size());
    if (weight > 0)
      add(sum, weight, body_.grid.periodic.x ? of_cell(at, across, z, a, b) : of_cell(across, at, z, a, b));
  }
  return sum;
}

Tensor StressPoints::below_images(double x, double y, double z) const {
  const Grid& grid = body_.grid;
  const auto [nx, ny] = grid.shape;
  const bool in_x = grid.periodic.x;
  const auto [along_x, along_y] = axes(x, y);
  const Axis &along = in_x ? along_x : along_y, &across = in_x ? along_y : along_x;
  const double endless = 1e20 * (in_x ? grid.size_x() : grid.size_y());
  Tensor sum{};
  for (Index row = 0; row < (in_x ? ny : nx); ++row) {
    const Eigen::ArrayXd p =
        in_x ? Eigen::ArrayXd(body_.pressure.col(row)) : Eigen::ArrayXd(body_.pressure.row(row).transpose());
    const double mean = p.mean();
    if ((p == 0).all()) continue;
    add(sum, mean,
        in_x ? of_cell(0, across.from(row), z, endless, grid.dy / 2)
             : of_cell(across.from(row), 0, z, grid.dx / 2, endless));
    if ((p - mean).abs().maxCoeff() <= uniform * std::abs(mean)) continue;
    for (Index k = 0; k < p.size(); ++k) add(sum, p(k) - mean, of_images(along, k, across.from(row), z));
  }
  return sum;
}

Tensor StressPoints::below_waves(double x, double y, double z) const {
  const Grid& grid = body_.grid;
  const auto [nx, ny] = grid.shape;
  const Eigen::ArrayXcd along_x = waves(nx, (x - grid.x(0)) / grid.size_x()),
                        along_y = waves(ny, (y - grid.y(0)) / grid.size_y());
  const double first_x = 2 * std::numbers::pi / grid.size_x(), first_y = 2 * std::numbers::pi / grid.size_y();
  const Eigen::ArrayXd qx = first_x * Eigen::ArrayXd::LinSpaced(nx / 2 + 1, 0, static_cast<double>(nx / 2));
  const Index stride = modes_->transform.stride();
  Tensor sum{};
  for (Index ky = 0; ky <= ny / 2; ++ky) {
    const Complex* p = modes_->pressure(ky / block_columns) + ky % block_columns * stride;
    const Complex across = (ky == 0 ? 1.0 : 2.0) * along_y(ky);  // with (-kx, -ky)
    const double qy = first_y * static_cast<double>(ky), felt = faded / std::max(z, 1e-300);
    if (qy > felt) break;
    const Complex middle = p[0] * along_x(0) * across;
    add({middle, middle}, stress::Wave{0, qy, z, body_.poisson}, weights_, sum);
    const Index n = static_cast<Index>(
        std::min(static_cast<double>(nx / 2), std::sqrt((felt - qy) * (felt + qy)) / first_x));
    if (n == 0) continue;
    using Modes = Eigen::Map<const Eigen::ArrayXcd>;
    const auto phase = along_x.segment(1, n);
    const Eigen::ArrayXcd ahead = Modes(p + 1, n) * phase * across,
                          back = Modes(p + nx - n, n).reverse() * phase.conjugate() * across;
    const stress::Waves<Eigen::ArrayXd> wave{qx.segment(1, n), Eigen::ArrayXd::Constant(n, qy), z,
                                             body_.poisson};
    add_row(ahead + back, ahead - back, wave, weights_, sum);
  }
  return sum;
}

CellSum::CellSum(LoadedBody body, int threads)
    : grid_(body.grid),
      poisson_(body.poisson),
      deepest_(corners_cancel * std::min(grid_.dx, grid_.dy) *
               std::sqrt(static_cast<double>((body.pressure != 0).count()))),
      weights_(body.friction.weights()),
      points_(std::move(body), threads) {
  if (grid_.periodic.any()) return;
  const Index nx = grid_.shape.nx, ny = grid_.shape.ny;
  const Field& load = points_.body().pressure;
  auto p = [&](Index i, Index j) { return points_.body().at(i, j); };
  for (Index i = 0; i <= nx; i += corner_lanes)
    for (Index j = 0; j <= ny; j += most_rows) {
      const Index rows = std::min(most_rows, ny + 1 - j), i0 = std::max(i - 1, Index{0}),
                  j0 = std::max(j - 1, Index{0});
      if ((load.block(i0, j0, std::min(i + corner_lanes, nx) - i0, std::min(j + rows, ny) - j0) == 0).all())
        continue;
      blocks_.push_back({i, j, rows, twists_.size()});
      for (Index n = j; n < j + rows; ++n)
        for (Index m = i; m < i + corner_lanes; ++m)
          twists_.push_back(p(m, n) - p(m - 1, n) - p(m, n - 1) + p(m - 1, n - 1));
    }
}

void CellSum::add(const Block& b, double x, double y, double z, Tensor& sum) const {
  double X[corner_lanes], Y[most_rows], values[3][6][corner_lanes * most_rows],
      signed_twists[4][corner_lanes * most_rows];
  double x_sign[corner_lanes];
  double* out[3][6];
  for (Traction t : stress::tractions)
    for (Component c : stress::components) out[t][c] = weights_[t] == 0 ? nullptr : values[t][c];
  for (Index l = 0; l < corner_lanes; ++l) {
    const double at = x / grid_.dx + 0.5 * static_cast<double>(grid_.shape.nx) - static_cast<double>(b.i + l);
    X[l] = std::max(std::abs(at), off_corner), x_sign[l] = at < 0 ? -1 : 1;
  }
  // By what turns the sign of a function: neither axis, y, x, both.
  const double* twist = twists_.data() + b.twists;
  for (Index j = 0; j < b.rows; ++j) {
    const double at = (y + 0.5 * grid_.size_y() - static_cast<double>(b.j + j) * grid_.dy) / grid_.dx,
                 y_sign = at < 0 ? -1 : 1;
    Y[j] = std::abs(at);
    for (Index l = 0; l < corner_lanes; ++l) {
      const Index k = corner_lanes * j + l;
      signed_twists[0][k] = twist[k], signed_twists[1][k] = y_sign * twist[k];
      signed_twists[2][k] = x_sign[l] * twist[k], signed_twists[3][k] = x_sign[l] * y_sign * twist[k];
    }
  }
  corner_tile(X, Y, b.rows, z / grid_.dx, poisson_, out);
  using Vector = Eigen::Map<const Eigen::VectorXd>;
  for (Traction t : stress::tractions)
    for (Component c : stress::components)
      if (weights_[t] != 0)
        sum[c] += weights_[t] * Vector(out[t][c], corner_lanes * b.rows)
                                    .dot(Vector(signed_twists[2 * !odd_in_x(c, t) + !odd_in_y(c, t)],
                                                corner_lanes * b.rows));
}

Tensor CellSum::at(double x, double y, double z) const {
  if (grid_.periodic.any() || z > deepest_) return points_.at(x, y, z);
  Tensor sum{};
  for (const Block& b : blocks_) add(b, x, y, z, sum);
  for (double& s : sum) s /= 2 * std::numbers::pi;
  return sum;
}

}  // namespace asperity
