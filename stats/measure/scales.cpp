#include "stats/measure/scales.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include "stats/filter/missing.hpp"
#include "stats/spectrum/power_excess.hpp"
#include "stats/spectrum/resolution.hpp"

namespace asperity {
namespace {

constexpr double least_step_share = 0.01;

// The field with its rows along an axis.
struct Lines {
  Field z;
  Grid grid;
  FieldExtent extent = {};

  Lines(const Surface& surface, Axis1D axis) : z(surface.heights), grid(surface.grid) {
    if (axis == Axis1D::x) return;
    z = surface.heights.transpose();
    grid = {{grid.shape.ny, grid.shape.nx}, grid.dy, grid.dx, {grid.periodic.y, grid.periodic.x}};
  }
  Index points() const { return grid.shape.nx; }
  auto row(Index i) const { return z.row(i % points()); }
  // For a stencil of `reach` points more.
  Field field_of(Index reach) const { return {grid.periodic.x ? points() : points() - reach, z.cols()}; }
  Field slopes(Index s) const {
    Field out = field_of(s);
    for (Index i = 0; i < out.rows(); ++i)
      out.row(i) = (row(i + s) - row(i)) / (static_cast<double>(s) * grid.dx);
    return out;
  }
  Field curvatures(Index s) const {
    Field out = field_of(2 * s);
    for (Index i = 0; i < out.rows(); ++i)
      out.row(i) = (row(i) - 2 * row(i + s) + row(i + 2 * s)) / std::pow(static_cast<double>(s) * grid.dx, 2);
    return out;
  }
  // Above the lines through patches of s points.
  Field above_lines(Index s) const {
    const Eigen::ArrayXd t = Eigen::ArrayXd::LinSpaced(s, -0.5, 0.5) * static_cast<double>(s - 1);
    Field out = z.topRows(points() / s * s);
    for (Index i = 0; i < out.rows(); i += s) {
      auto patch = out.middleRows(i, s);
      const Eigen::ArrayXXd tilt = (patch.colwise() * t).colwise().sum() / t.square().sum(),
                            level = patch.colwise().mean();
      for (Index k = 0; k < s; ++k) patch.row(k) -= level + t(k) * tilt;
    }
    return out;
  }
};

// (2) to (4) at one scale, and what white noise of variance 1 adds to its square.
struct LocalScale {
  const char* quantity;
  int order;
  Index points;  // of l, in spacings
  Field values;
  double of_noise, of_round_off;
};

class Distances {
 public:
  Distances(const Sample& sample, Axis1D axis)
      : sample_(sample), axis_(axis), lines_(sample.surface(), axis) {
    if (!sample.size().gives_errors()) return;
    lines_.extent = sample.extent();
    if (axis == Axis1D::y) lines_.extent.elongation = 1 / lines_.extent.elongation;
  }

  void add(std::vector<ScalePoint>& out) const {
    const Index half = lines_.points() / 2;
    const double h = lines_.grid.dx;
    for (Index s = 4; s <= half; s *= 2)
      out.push_back(point({"patch_height", 0, s, lines_.above_lines(s), 1 - 2 / static_cast<double>(s), 1}));
    for (Index s = 1; s <= half; s *= 2) {
      const double l = static_cast<double>(s) * h;
      out.push_back(point({"distance_slope", 1, s, lines_.slopes(s), 2 / (l * l), 1 / l}));
    }
    for (Index s = 1; 2 * s <= half; s *= 2) {
      const double l = static_cast<double>(s) * h;
      out.push_back(
          point({"distance_curvature", 2, 2 * s, lines_.curvatures(s), 6 / std::pow(l, 4), 4 / (l * l)}));
    }
  }

 private:
  ScalePoint point(const LocalScale& at) const {
    ScalePoint out{at.quantity, at.order, axis_, static_cast<double>(at.points) * lines_.grid.dx};
    const ValidSum squares = sum_of_valid(at.values.square());
    if (!(squares.count > 0)) return out.no_error = NoError::holes, out;
    const double square = squares.sum / squares.count;
    out.estimate.value = std::sqrt(square);
    out.no_error = why_none(at, square);
    if (out.no_error == NoError::flat) out.estimate.value = 0;
    if (out.no_error != NoError::none) return out;
    const LocalMeans means = mean_square(at.values);
    constexpr double points_a_wave = 10;
    if (!(squares.count > points_a_wave * static_cast<double>(means.waves())))
      return out.no_error = NoError::size, out;
    const WaveError error = means.error([](const Eigen::VectorXd& m) { return m(0); });
    constexpr double round_off = 1e-12;
    if (!(error.error > round_off * square)) return out.no_error = NoError::flat, out;
    out.estimate.standard_error = error.error / (2 * out.estimate.value);
    out.estimate.interval = Interval::of_ratio(out.estimate.value, error.half_width() / (2 * square));
    return out;
  }
  NoError why_none(const LocalScale& at, double square) const {
    const Surface& surface = sample_.surface();
    const Index n = lines_.points();
    if (std::sqrt(square) <= at.of_round_off * sample_.round_off()) return NoError::flat;
    if (surface.degree > 0 && at.points * (2 + 2 * ((surface.degree + 1) / 2)) > n) return NoError::form;
    if (surface.step * surface.step / 12 * at.of_noise > least_step_share * square) return NoError::steps;
    if (!sample_.size().gives_errors() || 8 * at.points > n) return NoError::size;
    return NoError::none;
  }
  LocalMeans mean_square(const Field& values) const {
    Grid part = lines_.grid;
    const auto whole = static_cast<double>(part.shape.nx);
    part.shape.nx = values.rows();
    part.periodic.x = part.periodic.x && values.rows() == lines_.points();
    FieldExtent extent = lines_.extent;
    extent.elongation *= static_cast<double>(part.shape.nx) / whole;
    LocalSums sums(part, 1);
    sums.add_rows(part.shape.nx, sample_.threads(), [&](Index i, LocalSums::Values& row) {
      row.col(1) = values.row(i).square().transpose().matrix();
    });
    return sums.means(extent);
  }

  const Sample& sample_;
  Axis1D axis_;
  Lines lines_;
};

// ---- bands of the spectrum ----

// λ = 2^(o+1) Δ of wave number k of n: n/2^(o+2) < k ≤ n/2^(o+1); none of the mean.
Index octave(Index k, Index n) {
  Index o = -1;
  for (Index m = 2 * k; k > 0 && m <= n; m *= 2) ++o;
  return o;
}

class Bands {
 public:
  Bands(const Sample& sample, Axis1D axis, DataWindow window)
      : sample_(sample),
        axis_(axis),
        n_(axis == Axis1D::x ? sample.grid().shape.nx : sample.grid().shape.ny),
        spacing_(axis == Axis1D::x ? sample.grid().dx : sample.grid().dy),
        psd_(power_spectrum(sample.surface().heights, sample.grid(), windows_along(axis, window),
                            sample.threads())),
        shared_(shared_power(sample.surface().heights, windows_along(axis, window))),
        points_(profile_spectrum(sample, axis, window)) {
    if (sample.amplitudes_may_vary())
      excess_ = profile_excess(sample.surface().heights, sample.grid(), axis, psd_, shared_, sample.extent(),
                               sample.threads());
  }

  void add(std::vector<ScalePoint>& out) const {
    constexpr std::array quantities{"band_height", "band_slope", "band_curvature"};
    for (int d = 0; d < 3; ++d) {
      const std::vector<SpectrumPoint> squares = mean_squares(d);
      for (std::size_t o = 0; o < squares.size(); ++o)
        out.push_back(point(quantities[static_cast<std::size_t>(d)], d, static_cast<Index>(o), squares[o]));
    }
  }

 private:
  double factor(Index k, int order) const {
    return std::pow(2 * std::numbers::pi * static_cast<double>(k) / (static_cast<double>(n_) * spacing_),
                    2 * order);
  }
  // The square of (1) as a density, an octave each.
  std::vector<SpectrumPoint> mean_squares(int order) const {
    const bool x = axis_ == Axis1D::x;
    const LagField powers = LagField::of(
        psd_.max_lag(), [&](Index p, Index q) { return factor(x ? p : std::abs(q), order) * psd_(p, q); });
    const double area = sample_.grid().size_x() * sample_.grid().size_y();
    std::vector<SpectrumPoint> out;
    for (const MeanPower& band : shared_.means(
             powers, octave(1, n_) + 1, [&](Index p, Index q) { return octave(x ? p : std::abs(q), n_); }))
      out.push_back({.wave_number = std::numbers::pi / spacing_ / std::exp2(out.size()) / std::numbers::sqrt2,
                     .density = band.count / area * band.mean,
                     .standard_error = band.count / area * std::sqrt(band.variance),
                     .degrees = band.degrees,
                     .count = band.count});
    add_excess(out, excess_);
    for (std::size_t o = 0; o < out.size(); ++o) judge(out[o], static_cast<Index>(o), order);
    return out;
  }
  // By the wave numbers that it holds.
  void judge(SpectrumPoint& band, Index number, int order) const {
    double power = 0, spread = 0, leaked = 0, noise = 0;
    for (Index k = 1; k < std::ssize(points_); ++k) {
      if (octave(k, n_) != number) continue;
      const SpectrumPoint& of = points_[static_cast<std::size_t>(k)];
      const double own = factor(k, order) * of.density;
      power += own, spread += own * std::exp(of.bias), noise += factor(k, order);
      if (of.no_error == NoError::leakage) leaked += own;
      if (of.no_error == NoError::form) band.no_error = NoError::form;
    }
    band.bias = power > 0 ? std::log(spread / power) : 0;
    const double step = sample_.surface().step,
                 rounding = step * step / 12 * 2 * noise / static_cast<double>(n_);
    if (band.no_error == NoError::form) return;
    if (!(band.density > 0))
      band.no_error = NoError::flat;
    else if (leaked > 0.1 * power)
      band.no_error = NoError::leakage;
    else if (rounding > least_step_share * band.density)
      band.no_error = NoError::steps;
    else if (hidden_by(band.bias, band))
      band.no_error = has_missing(sample_.surface().heights) ? NoError::holes : NoError::resolution;
  }
  ScalePoint point(const char* quantity, int order, Index number, const SpectrumPoint& square) const {
    ScalePoint out{
        quantity,       order, axis_, spacing_ * std::exp2(number + 1), {std::sqrt(square.density)},
        square.no_error};
    if (out.no_error != NoError::none) return out;
    const Interval ends = square.interval();
    out.estimate.standard_error = square.standard_error / (2 * out.estimate.value);
    out.estimate.interval = Interval::of(out.estimate.value, std::sqrt(ends.low), std::sqrt(ends.high));
    return out;
  }

  const Sample& sample_;
  Axis1D axis_;
  Index n_;
  double spacing_;
  LagField psd_;
  SharedPower shared_;
  std::vector<SpectrumPoint> points_;
  PowerExcess excess_ = {};
};

// Whether a tip follows all second differences over 2s points.
bool follows(const Lines& lines, Index s, double tip_radius) {
  return !(lines.curvatures(s) < -0.5 / tip_radius).any();
}

// The first s that it follows, if that is monotonic; 0: all, one more than there are: none.
Index first_followed(const Lines& lines, double tip_radius) {
  const Index most = lines.points() / 4;
  Index below = 0, from = 1;
  while (from <= most && !follows(lines, from, tip_radius)) below = from, from *= 2;
  from = std::min(from, most + 1);
  while (from - below > 1) {
    const Index middle = (below + from) / 2;
    (follows(lines, middle, tip_radius) ? from : below) = middle;
  }
  return below > 0 ? from : 0;
}

}  // namespace

std::vector<ScalePoint> by_scale(const Sample& sample, DataWindows windows) {
  std::vector<ScalePoint> out;
  for (const auto& [axis, n, window] : {std::tuple{Axis1D::x, sample.grid().shape.nx, windows.x},
                                        {Axis1D::y, sample.grid().shape.ny, windows.y}}) {
    if (n < 4) continue;
    Bands(sample, axis, window).add(out);
    Distances(sample, axis).add(out);
  }
  return out;
}

double first_reliable_scale(const Surface& surface, double tip_radius) {
  double out = 0;
  for (const Axis1D axis : {Axis1D::x, Axis1D::y}) {
    const Lines lines(surface, axis);
    out = std::max(out, 2 * static_cast<double>(first_followed(lines, tip_radius)) * lines.grid.dx);
  }
  return out;
}

}  // namespace asperity
