#include "stats/spectrum/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "stats/filter/missing.hpp"
#include "stats/spatial/pairs.hpp"
#include "transform/pruned.hpp"

namespace asperity {
namespace {

// Of mean square 1.
Eigen::ArrayXd window_of(DataWindow window, Index n) {
  Eigen::ArrayXd w = Eigen::ArrayXd::Ones(n);
  if (window == DataWindow::hann)
    for (Index i = 0; i < n; ++i)
      w(i) -= std::cos(2 * std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(n));
  return w / std::sqrt(w.square().mean());
}

// I of the variance.
double inflation(DataWindow window) { return window == DataWindow::hann ? 35.0 / 18 : 1; }

// Σ x_i y_j over the points that are there.
double sum_over(const Field& valid, const Eigen::ArrayXd& x, const Eigen::ArrayXd& y) {
  return x.matrix().dot(valid.matrix() * y.matrix());
}

// Eight columns l of the transform to the columns ±l of the half-plane.
void store(const PrunedTransform& transform, Index b, const Complex* block, double scale, Field& out) {
  const Index nx = transform.torus().nx, middle = out.cols() / 2, first = b * PrunedTransform::width;
  const Index columns = std::min(PrunedTransform::width, transform.columns() - first);
  for (Index p = 0; p < out.rows(); ++p)
    for (Index c = 0; c < columns; ++c) {
      const Complex* column = block + c * transform.stride();
      out(p, middle - first - c) = scale * std::norm(column[(nx - p) % nx]);
      out(p, middle + first + c) = scale * std::norm(column[p]);
    }
}

// How often a wave number of index k ≤ n/2 stands for itself in a sum over all n: its mirror image, at half
// the period its own, is another entry.
double times_met(Index k, Index n) { return 2 * std::abs(k) == n ? 0.5 : 1; }

// Wave numbers lie on the bounds of rings and sectors, whatever the unit of length.
constexpr double round_off = 1e-12;

struct WaveNumbers {
  explicit WaveNumbers(const Grid& grid)
      : torus{grid.shape, grid.dx, grid.dy, true},
        step_x(2 * std::numbers::pi / grid.size_x()),
        step_y(2 * std::numbers::pi / grid.size_y()),
        last(std::numbers::pi / std::max(grid.dx, grid.dy)) {}

  double step() const { return std::max(step_x, step_y); }
  void for_each(const LagField& psd, const auto& visit) const {
    for_each_lag(psd, torus, [&](Index p, Index q, double weight) {
      visit(static_cast<double>(p) * step_x, static_cast<double>(q) * step_y, weight, psd(p, q));
    });
  }

  Grid torus;
  double step_x, step_y, last;
};

constexpr Index sectors = 360;  // of π
constexpr double sector = std::numbers::pi / sectors, narrowest = 2 * std::numbers::pi / 180;

// Adds a wave number to F of (5), on sectors from -π/2 on.
void spread(Eigen::ArrayXd& F, double angle, double half_width, double power) {
  const auto first = static_cast<Index>(std::ceil((angle - half_width) / sector)),
             last = static_cast<Index>(std::floor((angle + half_width) / sector));
  for (Index s = first; s <= last; ++s) {
    const double distance = std::abs(static_cast<double>(s) * sector - angle) / half_width;
    F((s + 5 * sectors / 2) % sectors) += power * (1 - distance) / half_width;
  }
}

}  // namespace

DataWindows default_windows(const Grid& grid) {
  const DataWindow both = grid.periodic.both() ? DataWindow::none : DataWindow::hann;
  return {both, both};
}

double spectrum_inflation(const Field& d, DataWindows windows) {
  if (!has_missing(d)) return inflation(windows.x) * inflation(windows.y);
  const Field valid = validity(d);
  const Eigen::ArrayXd x = window_of(windows.x, d.rows()).square(),
                       y = window_of(windows.y, d.cols()).square();
  const double squares = sum_over(valid, x, y);
  return static_cast<double>(d.size()) * sum_over(valid, x.square(), y.square()) / (squares * squares);
}

LagField power_spectrum(const Field& d, const Grid& grid, DataWindows windows, int threads) {
  const auto [nx, ny] = grid.shape;
  const Eigen::ArrayXd wx = window_of(windows.x, nx), wy = window_of(windows.y, ny);
  const PrunedTransform transform(grid.shape, grid.shape);
  HalfSpectrum half = transform.half_spectrum();
  Field windowed = (d.colwise() * wx).rowwise() * wy.transpose();
  double mean_square = 1;
  if (has_missing(windowed)) {
    mean_square = sum_over(validity(d), wx.square(), wy.square()) / static_cast<double>(d.size());
    windowed = zero_filled(windowed);
  }
  transform.forward_rows(windowed, half, threads);

  Field out(nx / 2 + 1, 2 * (ny / 2) + 1);
  const double scale = grid.cell_area() / (static_cast<double>(grid.shape.cells()) * mean_square);
  transform.each_block(half, threads,
                       [&](Index b, const Complex* block) { store(transform, b, block, scale, out); });
  return LagField(std::move(out));
}

std::vector<SpectrumPoint> profile_spectrum(const Field& d, const Grid& grid, Axis1D axis, DataWindow window,
                                            int threads) {
  if (axis == Axis1D::y) {
    const Grid turned{{grid.shape.ny, grid.shape.nx}, grid.dy, grid.dx, {grid.periodic.y, grid.periodic.x}};
    return profile_spectrum(d.transpose(), turned, Axis1D::x, window, threads);
  }
  const DataWindows windows{window, DataWindow::none};
  const LagField psd = power_spectrum(d, grid, windows, threads);
  const double shared = spectrum_inflation(d, windows);
  std::vector<SpectrumPoint> out;
  for (Index p = 0; p <= psd.max_p(); ++p) {
    double sum = 0, squares = 0;
    for (Index q = -psd.max_q(); q <= psd.max_q(); ++q) {
      const double weight = times_met(q, grid.shape.ny), value = psd(p, q);
      sum += weight * value;
      squares += weight * value * value;
    }
    // Without a partner (-p, -q) of its own, as at p = 0 and n/2, a row is one half of it over again.
    const double repeated = p == 0 || 2 * p == grid.shape.nx ? 2 : 1;
    out.push_back({.wave_number = 2 * std::numbers::pi * static_cast<double>(p) / grid.size_x(),
                   .density = sum / grid.size_y(),
                   .standard_error = std::sqrt(0.5 * repeated * shared * squares) / grid.size_y(),
                   .count = static_cast<double>(grid.shape.ny)});
  }
  return out;
}

std::vector<SpectrumPoint> radial_spectrum(const LagField& psd, const Grid& grid, double inflation) {
  const WaveNumbers q(grid);
  std::vector<SpectrumPoint> rings(static_cast<std::size_t>(q.last / q.step() * (1 + round_off)));
  q.for_each(psd, [&](double qx, double qy, double weight, double value) {
    const double length = std::hypot(qx, qy);
    const auto ring = static_cast<std::size_t>(std::lround(length / q.step()));
    if (ring < 1 || ring > rings.size()) return;
    SpectrumPoint& sum = rings[ring - 1];
    sum.count += weight;
    sum.wave_number += weight * length;
    sum.density += weight * value;
    sum.standard_error += weight * value * value;
  });
  for (SpectrumPoint& ring : rings)
    ring = {.wave_number = ring.wave_number / ring.count,
            .density = ring.density / ring.count,
            .standard_error = std::sqrt(inflation * ring.standard_error) / ring.count,
            .count = ring.count};
  return rings;
}

// The vertex of the parabola through the largest F and its neighbours.
TextureDirection texture_direction(const LagField& psd, const Grid& grid) {
  const WaveNumbers q(grid);
  Eigen::ArrayXd F = Eigen::ArrayXd::Zero(sectors);
  q.for_each(psd, [&](double qx, double qy, double weight, double value) {
    const double length = std::hypot(qx, qy);
    if (length < 4 * q.step() * (1 - round_off) || length > q.last * (1 + round_off)) return;
    spread(F, std::atan2(qy, qx), std::max(narrowest, q.step() / length), weight * value);
  });
  Index top = 0;
  const double highest = F.maxCoeff(&top);
  if (!(highest > 0)) return {NAN, NAN};
  const double before = F((top + sectors - 1) % sectors), after = F((top + 1) % sectors);
  const double bend = before - 2 * highest + after, shift = bend < 0 ? 0.5 * (before - after) / bend : 0;
  const double angle = (static_cast<double>(top) + shift) * sector - std::numbers::pi / 2;
  return {angle > -std::numbers::pi / 2 ? angle : angle + std::numbers::pi, highest / F.mean()};
}

}  // namespace asperity
