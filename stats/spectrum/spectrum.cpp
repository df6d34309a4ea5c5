#include "stats/spectrum/spectrum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>
#include <utility>

#include "core/memory.hpp"
#include "core/parallel.hpp"
#include "math/noise.hpp"
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
  const Index nx = transform.field().nx, middle = transform.field().ny / 2;
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

// A wave number, or several of the narrowest in one direction.
struct Ray {
  double angle, half_width, power, square = power * power;
};

// (5) on sectors from -π/2 on, and its variance but for what wave numbers share.
struct AngularSpectrum {
  Eigen::ArrayXd F = Eigen::ArrayXd::Zero(sectors), variance = Eigen::ArrayXd::Zero(sectors);

  void add(const Ray& ray) {
    const auto first = static_cast<Index>(std::ceil((ray.angle - ray.half_width) / sector)),
               last = static_cast<Index>(std::floor((ray.angle + ray.half_width) / sector));
    for (Index s = first; s <= last; ++s) {
      const double distance = std::abs(static_cast<double>(s) * sector - ray.angle) / ray.half_width;
      const Index k = (s + 5 * sectors / 2) % sectors;
      F(k) += ray.power * (1 - distance) / ray.half_width;
      variance(k) += 0.5 * ray.square * std::pow((1 - distance) / ray.half_width, 2);
    }
  }
  static double angle_of(double k) { return k * sector - std::numbers::pi / 2; }
  /// The vertex of a parabola through the largest F and its neighbours.
  double top() const {
    Index k = 0;
    const double highest = F.maxCoeff(&k), before = F((k + sectors - 1) % sectors),
                 after = F((k + 1) % sectors);
    const double bend = before - 2 * highest + after, shift = bend < 0 ? 0.5 * (before - after) / bend : 0;
    const double angle = angle_of(static_cast<double>(k) + shift);
    return angle > -std::numbers::pi / 2 ? angle : angle + std::numbers::pi;
  }
};

}  // namespace

DataWindows default_windows(const Grid& grid) {
  const DataWindow both = grid.periodic.both() ? DataWindow::none : DataWindow::hann;
  return {both, both};
}

SharedPower shared_power(const Field& d, DataWindows windows) {
  return {d, window_of(windows.x, d.rows()).square(), window_of(windows.y, d.cols()).square()};
}

const char* reason(NoError why) {
  // In the order of NoError.
  constexpr std::array words{"", "form", "leakage", "resolution", "holes", "steps", "size", "flat", "tip"};
  return words.at(static_cast<std::size_t>(why));
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

// ---- the angular spectrum ----

namespace {

// Of the narrowest, those of one direction count as one.
class PooledRays {
 public:
  void add(const Ray& ray) {
    if (!(ray.power > 0)) return;
    if (ray.half_width > narrowest) return wide_.push_back(ray);
    const auto s = std::lround(ray.angle / sector);
    Ray& all = narrow_[size((s + sectors) % sectors)];
    all = {static_cast<double>(s) * sector, narrowest, all.power + ray.power, all.square + ray.square};
  }
  std::vector<Ray> all() const {
    std::vector<Ray> out = wide_;
    std::ranges::copy_if(narrow_, std::back_inserter(out), [](const Ray& ray) { return ray.power > 0; });
    return out;
  }

 private:
  std::vector<Ray> wide_ = {}, narrow_ = std::vector<Ray>(size(sectors), {0, narrowest, 0});
};

// The rms change of the largest F's direction when the powers are drawn again, with their variance.
double error_of_top(const std::vector<Ray>& rays, double top, double overlap) {
  constexpr int draws = 64;
  WhiteNoise noise(1);
  std::vector<double> normal(rays.size());
  double square = 0;
  for (Index d = 0; d < draws; ++d) {
    noise.row(d, normal);
    AngularSpectrum drawn;
    for (std::size_t k = 0; k < rays.size(); ++k) {
      Ray ray = rays[k];
      const double spread = std::log1p(0.5 * overlap * ray.square / (ray.power * ray.power));
      ray.power *= std::exp(std::sqrt(spread) * normal[k] - 0.5 * spread);
      drawn.add(ray);
    }
    square += std::pow(std::remainder(drawn.top() - top, std::numbers::pi), 2) / draws;
  }
  return std::sqrt(square);
}

// The maximum, beside the largest, that stands out most above what lies between: in its errors, and where.
struct Maximum {
  double angle = NAN, errors = 0;
};
Maximum second_maximum(const AngularSpectrum& of, double overlap) {
  Index top = 0;
  const Eigen::ArrayXd& F = of.F;
  const double least = 0.01 * F.maxCoeff(&top);
  auto at = [&](Index k) { return (top + k + sectors) % sectors; };
  Maximum out;
  for (Index k = 1; k < sectors; ++k) {
    const Index here = at(k);
    if (!(F(here) > F(at(k - 1)) && F(here) >= F(at(k + 1)) && F(here) > least)) continue;
    Index before = here, after = here;  // lowest on the way to the largest
    for (Index j = 1; j < k; ++j)
      if (F(at(j)) < F(before)) before = at(j);
    for (Index j = k + 1; j < sectors; ++j)
      if (F(at(j)) < F(after)) after = at(j);
    const Index between = F(before) > F(after) ? before : after;
    auto relative_variance = [&](Index i) { return F(i) > 0 ? of.variance(i) / (F(i) * F(i)) : 0; };
    const double errors = std::log(F(here) / F(between)) /
                          std::sqrt(overlap * (relative_variance(here) + relative_variance(between)));
    if (errors > out.errors) out = {AngularSpectrum::angle_of(static_cast<double>(here)), errors};
  }
  return out;
}

}  // namespace

TextureDirection texture_direction(const LagField& psd, const Grid& grid, double overlap) {
  const WaveNumbers q(grid);
  PooledRays rays;
  AngularSpectrum all;
  q.for_each(psd, [&](double qx, double qy, double weight, double value) {
    const double length = std::hypot(qx, qy);
    if (length < 4 * q.step() * (1 - round_off) || length > q.last * (1 + round_off)) return;
    const Ray ray{std::atan2(qy, qx), std::max(narrowest, q.step() / length), weight * value};
    rays.add(ray), all.add(ray);
  });
  const double highest = all.F.maxCoeff();
  if (!(highest > 0)) return {};
  const double angle = all.top();
  TextureDirection out{angle, highest / all.F.mean(),
                       std::hypot(error_of_top(rays.all(), angle, overlap), sector)};
  constexpr double least_errors = 3.5;
  if (const Maximum next = second_maximum(all, overlap); next.errors > least_errors) out.other = next.angle;
  return out;
}

TextureDirection texture_direction(const Field& d, const Grid& grid, int threads) {
  const DataWindows windows = default_windows(grid);
  return texture_direction(power_spectrum(d, grid, windows, threads), grid,
                           shared_power(d, windows).overlap());
}

}  // namespace asperity
