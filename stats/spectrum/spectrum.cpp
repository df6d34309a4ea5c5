#include "stats/spectrum/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "core/memory.hpp"
#include "core/parallel.hpp"
#include "stats/filter/missing.hpp"
#include "stats/sample/quantiles.hpp"
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

// Σ x_i y_j over the points that are there.
double sum_over(const Field& d, const Eigen::ArrayXd& x, const Eigen::ArrayXd& y) {
  double out = 0;
  for (Index i = 0; i < d.rows(); ++i) out += x(i) * d.row(i).isNaN().select(0.0, y.transpose()).sum();
  return out;
}

// The power of eight columns at ±l, l ≥ 0, in row p: as a complex number in place of that at l.
void to_powers(const PrunedTransform& transform, Complex* block, double scale) {
  const Index nx = transform.torus().nx;
  for (Index c = 0; c < PrunedTransform::width; ++c) {
    Complex* column = block + c * transform.stride();
    for (Index p = 0; p <= nx / 2; ++p)
      column[p] = {scale * std::norm(column[p]), scale * std::norm(column[(nx - p) % nx])};
  }
}

Field rows_of_powers(const PrunedTransform& transform, std::span<const Complex> powers, int threads) {
  constexpr Index width = PrunedTransform::width;
  const auto [nx, ny] = transform.field();
  const Index middle = ny / 2;
  Field out = large_field({nx / 2 + 1, 2 * middle + 1});
  parallel_ranges(out.rows(), threads, [&](Index begin, Index end, int) {
    for (Index p = begin; p < end; ++p)
      for (Index l = middle; l >= 0; --l) {
        const Complex both = powers[size((l / width * nx + p) * width + l % width)];
        out(p, middle - l) = both.imag();
        out(p, middle + l) = both.real();
      }
  });
  return out;
}

// Wave numbers are on the bounds of rings and sectors, whatever the unit of length.
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

SharedPower shared_power(const Field& d, DataWindows windows) {
  return {d, window_of(windows.x, d.rows()).square(), window_of(windows.y, d.cols()).square()};
}

const char* reason(NoError why) {
  switch (why) {
    case NoError::form:
      return "form";
    case NoError::leakage:
      return "leakage";
    case NoError::resolution:
      return "resolution";
    case NoError::holes:
      return "holes";
    case NoError::none:
      break;
  }
  return "";
}

Interval SpectrumPoint::interval(double level) const {
  if (no_error != NoError::none) {
    Interval none;
    none.why = std::string("no interval: ") + reason(no_error);
    return none;
  }
  const double tail = (1 - level) / 2;
  return Interval::of(density, density / chi_squared_share(tail, degrees) * std::exp(std::min(-bias, 0.0)),
                      density / chi_squared_share(1 - tail, degrees) * std::exp(std::max(-bias, 0.0)));
}

LagField power_spectrum(const Field& d, const Grid& grid, DataWindows windows, int threads) {
  const Index nx = grid.shape.nx, ny = grid.shape.ny;
  const Eigen::ArrayXd wx = window_of(windows.x, nx), wy = window_of(windows.y, ny);
  const PrunedTransform transform(grid.shape, grid.shape, Ways::forward_only);
  HalfSpectrum half = transform.half_spectrum();
  const bool complete = !has_missing(d);
  const double mean_square =
      complete ? 1 : sum_over(d, wx.square(), wy.square()) / static_cast<double>(d.size());
  const RowSource windowed = [&](Index i, double* row) {
    Eigen::Map<Eigen::Array<double, 1, Eigen::Dynamic>> out(row, ny);
    out = d.row(i) * wx(i) * wy.transpose();
    if (!complete) out = out.isNaN().select(0.0, out);
  };
  transform.forward_each_row(windowed, half, threads);

  const double scale = grid.cell_area() / (static_cast<double>(grid.shape.cells()) * mean_square);
  transform.change_each_block(half, threads,
                              [&](Index, Complex* block) { to_powers(transform, block, scale); });
  return LagField(rows_of_powers(transform, half, threads));
}

Field over_both_signs(const LagField& psd, const Grid& grid) {
  Field out = psd.half_plane();
  if (grid.shape.nx % 2 == 0) out.row(grid.shape.nx / 2) /= 2;
  if (grid.shape.ny % 2 == 0) out.leftCols(1) /= 2, out.rightCols(1) /= 2;
  return out;
}

std::vector<SpectrumPoint> profile_spectrum(const Field& d, const Grid& grid, Axis1D axis, DataWindow window,
                                            int threads) {
  const DataWindows windows = windows_along(axis, window);
  return profile_spectrum(power_spectrum(d, grid, windows, threads), grid, axis, shared_power(d, windows));
}

std::vector<SpectrumPoint> profile_spectrum(const LagField& psd, const Grid& grid, Axis1D axis,
                                            const SharedPower& shared) {
  const bool x = axis == Axis1D::x;
  const double step = 2 * std::numbers::pi / (x ? grid.size_x() : grid.size_y()),
               across = x ? grid.dy : grid.dx;
  const auto count = static_cast<double>(x ? grid.shape.ny : grid.shape.nx);
  std::vector<SpectrumPoint> out;
  for (const MeanPower& row : shared.means(psd, (x ? psd.max_p() : psd.max_q()) + 1,
                                           [&](Index p, Index q) { return x ? p : std::abs(q); }))
    out.push_back({.wave_number = step * static_cast<double>(out.size()),
                   .density = row.mean / across,
                   .standard_error = std::sqrt(row.variance) / across,
                   .degrees = row.degrees,
                   .count = count});
  return out;
}

std::vector<SpectrumPoint> radial_spectrum(const LagField& psd, const Grid& grid, const SharedPower& shared) {
  const WaveNumbers q(grid);
  const auto rings = static_cast<Index>(q.last / q.step() * (1 + round_off));
  const auto ring_of = [&](double length) {
    const auto ring = static_cast<Index>(length / q.step() * (1 + round_off) + 0.5);
    return ring <= rings ? ring - 1 : -1;
  };
  std::vector<SpectrumPoint> out;
  for (const MeanPower& ring : shared.means(psd, rings, [&](Index k, Index l) {
         return ring_of(std::hypot(static_cast<double>(k) * q.step_x, static_cast<double>(l) * q.step_y));
       }))
    out.push_back({.density = ring.mean,
                   .standard_error = std::sqrt(ring.variance),
                   .degrees = ring.degrees,
                   .count = ring.count});
  q.for_each(psd, [&](double qx, double qy, double weight, double) {
    const double length = std::hypot(qx, qy);
    if (const Index ring = ring_of(length); ring >= 0)
      out[static_cast<std::size_t>(ring)].wave_number +=
          weight * length / out[static_cast<std::size_t>(ring)].count;
  });
  return out;
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
