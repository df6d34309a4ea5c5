#include "stress/layers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "grid/error.hpp"
#include "grid/parallel.hpp"

namespace asperity {
namespace {

using stress::Component;

constexpr Index width = PrunedTransform::width;
static_assert(width == LayerInfluence::width);

std::size_t size(Index n) { return static_cast<std::size_t>(n); }

void check(const Grid& grid, const Field& pressure, const Friction& friction, double poisson) {
  friction.check();
  if (!(poisson >= 0 && poisson <= 0.5))
    throw ParameterError("poisson", fmt::format("{} is not between 0 and 0.5", poisson));
  if (shape_of(pressure) != grid.shape) throw DataError("pressure", "its shape is not that of the grid");
  if (!pressure.isFinite().all()) throw DataError("pressure", "holds a value that is not a finite number");
}

// -i a z.
Complex turn(double a, const Complex& z) { return {a * z.imag(), -a * z.real()}; }

// exp(2πi ki/n) for every mode k.
AlignedVector<Complex> wave(Index n, Index i) {
  AlignedVector<Complex> out(size(n));
  for (Index k = 0; k < n; ++k)
    out[size(k)] =
        std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(k * i % n) / static_cast<double>(n));
  return out;
}

}  // namespace

// The symbols of a column ky: S of the pressure, and T = ±μx X ± μy Y of its friction, where X and Y stand a quarter
// turn from S for the one parity in which they differ. In -kx what is odd in x changes sign.
class StressSolver::Column {
 public:
  Column(const std::array<LayerInfluence::Symbol, 3>& symbols, const std::array<double, 3>& weights,
         Component c, Index q)
      : weights_{1, odd_in_x(c) ? weights[1] : -weights[1], odd_in_y(c) ? weights[2] : -weights[2]} {
    for (stress::Traction t : stress::tractions)
      if (symbols[t].pairs != nullptr)
        first_[t] = reinterpret_cast<const double*>(symbols[t].pairs + q / 2 * symbols[t].stride) + q % 2;
  }

  bool friction() const { return first_[stress::shear_x] != nullptr || first_[stress::shear_y] != nullptr; }
  double pressed(Index k) const { return first_[stress::normal][2 * k]; }
  /// side: 1 in kx, -1 in -kx.
  double sheared(Index k, int side) const {
    double sum = 0;
    if (first_[stress::shear_x]) sum += side * weights_[stress::shear_x] * first_[stress::shear_x][2 * k];
    if (first_[stress::shear_y]) sum += weights_[stress::shear_y] * first_[stress::shear_y][2 * k];
    return sum;
  }

 private:
  std::array<const double*, 3> first_{};
  std::array<double, 3> weights_;
};

StressSolver::StressSolver(const Grid& grid, const Field& pressure, double poisson, int threads,
                           DepthResolution resolution)
    : StressSolver(grid, pressure, Friction{}, poisson, threads, resolution) {}

StressSolver::StressSolver(const Grid& grid, const Field& pressure, const Friction& friction, double poisson,
                           int threads, DepthResolution resolution)
    : grid_(grid),
      pressure_(pressure),
      weights_(friction.weights()),
      poisson_(poisson),
      threads_(threads),
      levels_(1) {
  check(grid, pressure, friction, poisson);
  if (resolution == DepthResolution::full) return;
  for (Index s = 2; Resolution::possible(grid, s); s *= 2) levels_.emplace_back().s = s;
}

// The coarsest that is deep enough.
std::size_t StressSolver::level_at(double z) const {
  std::size_t level = 0;
  while (level + 1 < levels_.size() && z >= Resolution::least_depth(grid_, levels_[level + 1].s)) ++level;
  return level;
}

const Resolution& StressSolver::resolution(std::size_t level) const {
  Level& l = levels_[level];
  std::call_once(l.asked, [&] { l.made = std::make_unique<Resolution>(grid_, pressure_, l.s, threads_); });
  return *l.made;
}

StressSolver::Workspace::Level& StressSolver::prepared(Workspace& work, std::size_t level,
                                                       stress::Set asked) const {
  const Resolution& r = resolution(level);
  const PrunedTransform& t = r.transform();
  work.present_ = level;
  work.levels_.resize(levels_.size());
  Workspace::Level& w = work.levels_[level];
  if (!w.influence) {
    w.influence = make_layer_influence(r.cells(), t.torus(), poisson_, acting(weights_), r.taper());
    w.block.resize(size(t.block_size()));
    w.work.resize(size(t.block_size()));
    w.row_spectrum.resize(size(t.blocks() * width));
    w.stride = t.torus().ny + 2 * width;
  }
  for (Component c : stress::components) {
    if (!asked[c]) continue;
    if (w.half[c].empty()) w.half[c] = t.half_spectrum();
    if (r.s() > 1) w.points[c].resize(size(t.torus().nx * w.stride));
    work.row_[c].resize(std::max(work.row_[c].size(),
                                 size(std::max(t.torus().ny + 2, r.interpolation().padded(grid_.shape.ny)))));
  }
  work.across_.resize(std::max(work.across_.size(), size(w.stride)));
  return w;
}

void StressSolver::deal(const std::vector<double>& depths,
                        const std::function<void(Index layer, Workspace&)>& compute,
                        const LayersFinished& finished) const {
  const auto count = static_cast<Index>(depths.size());
  std::vector<Workspace> work(size(std::min<Index>(threads_, std::max<Index>(count, 1))));
  for (Index begin = 0; begin < count;) {
    const Index end = std::min(count, begin + static_cast<Index>(work.size()));
    parallel_ranges(end - begin, threads_, [&](Index from, Index to, int) {
      for (Index l = from; l < to; ++l) compute(begin + l, work[size(l)]);
    });
    if (finished) finished(begin, end);
    begin = end;
  }
}

void StressSolver::layers(const std::vector<double>& depths, stress::Set asked, const LayerRowSink& row,
                          const LayersFinished& finished) const {
  deal(
      depths,
      [&](Index l, Workspace& work) {
        layer(depths[size(l)], asked, work, [&](Index i, const StressRow& values) { row(l, i, values); });
      },
      finished);
}

void StressSolver::layer_rows(const std::vector<double>& depths, Index i, stress::Set asked,
                              const LayerRowSink& row, const LayersFinished& finished) const {
  deal(
      depths, [&](Index l, Workspace& work) { row(l, i, layer_row(depths[size(l)], i, asked, work)); },
      finished);
}

StressRow StressSolver::layer_row(double z, Index i, stress::Set asked, Workspace& work) const {
  transform_layer(z, asked, work, i);
  return row_of(i, asked, work);
}

void StressSolver::transform_layer(double z, stress::Set asked, Workspace& work, Index only) const {
  if (!(z >= 0 && std::isfinite(z)))
    throw ParameterError("depth", fmt::format("{} m is not a depth, 0 or more", z));
  const Resolution& r = resolution(level_at(z));
  Workspace::Level& w = prepared(work, level_at(z), asked);
  w.influence->descend(z, asked);
  if (only >= 0) w.wave = wave(r.transform().torus().nx, only);
  for (Index b = 0; b < r.transform().blocks(); ++b)
    for (Component c : stress::components) {
      if (!asked[c]) continue;
      multiply(r, c, b, *w.influence, w.block.data());
      if (only >= 0 && r.s() == 1)
        invert_row(r, only, w, b, w.half[c]);
      else
        r.transform().inverse_block(w.block.data(), b, w.half[c], w.work.data());
    }
  if (r.s() == 1) return;
  const Index first = only >= 0 ? only : 0, last = only >= 0 ? only : grid_.shape.nx - 1;
  invert_points(r, first / r.s(), last / r.s() + Interpolation::taps - 1, asked, w);
}

// Of a transform back in x the one value x_i: a sum over the modes.
void StressSolver::invert_row(const Resolution& r, Index i, const Workspace::Level& w, Index b,
                              HalfSpectrum& half) const {
  using Modes = Eigen::Map<const Eigen::ArrayXcd>;
  const PrunedTransform& t = r.transform();
  const Index nx = t.torus().nx;
  for (Index q = 0; q < width; ++q)
    half[size((b * t.field().nx + i) * width + q)] =
        (Modes(w.block.data() + q * t.stride(), nx) * Modes(w.wave.data(), nx)).sum();
}

// product = (-i)^m (S + iT) p^, S and T of Column.
void StressSolver::multiply(const Resolution& r, Component c, Index b, LayerInfluence& influence,
                            Complex* product) const {
  std::array<LayerInfluence::Symbol, 3> symbols{};
  for (stress::Traction t : stress::tractions)
    if (weights_[t] != 0) symbols[t] = influence.symbol(t, c, b);
  const Index nx = r.transform().torus().nx, stride = r.transform().stride();
  for (Index q = 0; q < width; ++q)
    multiply_column(nx, c, Column(symbols, weights_, c, q), r.pressure(b) + q * stride, product + q * stride);
}

void StressSolver::multiply_column(Index nx, Component c, const Column& column, const Complex* p,
                                   Complex* out) const {
  const bool turned = odd_in_x(c) != odd_in_y(c);
  const double ahead = odd_in_x(c) && odd_in_y(c) ? -1 : 1, back = odd_in_x(c) ? -ahead : ahead;
  auto each_mode = [&](auto response) {
    for (Index k = 0; k <= nx / 2; ++k) out[k] = response(k, 1, ahead, p[k]);
    for (Index k = nx / 2 + 1; k < nx; ++k) out[k] = response(nx - k, -1, back, p[k]);
  };
  auto S = [&](Index k, double factor) { return factor * column.pressed(k); };
  auto T = [&](Index k, int side, double factor) { return factor * column.sheared(k, side); };
  if (!column.friction() && !turned)
    each_mode([&](Index k, int, double f, const Complex& z) { return S(k, f) * z; });
  else if (!column.friction())
    each_mode([&](Index k, int, double f, const Complex& z) { return turn(S(k, f), z); });
  else if (!turned)
    each_mode(
        [&](Index k, int side, double f, const Complex& z) { return S(k, f) * z - turn(T(k, side, f), z); });
  else
    each_mode(
        [&](Index k, int side, double f, const Complex& z) { return turn(S(k, f), z) + T(k, side, f) * z; });
}

// The rows of a coarse layer, each with what stands before and behind it on the torus.
void StressSolver::invert_points(const Resolution& r, Index first, Index last, stress::Set asked,
                                 Workspace::Level& w) const {
  const auto [px, py] = r.transform().torus();
  for (Component c : stress::components) {
    if (!asked[c]) continue;
    for (Index m = first; m <= std::min(last, first + px - 1); ++m) {
      double* row = w.points[c].data() + m % px * w.stride;
      const Index i = (m + px - Interpolation::before) % px;
      r.transform().inverse_row(w.half[c], i, w.row_spectrum.data(), row);
      std::rotate(row, row + py - Interpolation::before, row + py);
      for (Index j = py; j < w.stride; ++j) row[j] = row[j - py];
    }
  }
}

StressRow StressSolver::row_of(Index i, stress::Set asked, Workspace& work) const {
  const Resolution& r = resolution(work.present_);
  Workspace::Level& w = work.levels_[work.present_];
  StressRow values{};
  for (Component c : stress::components) {
    if (!asked[c]) continue;
    if (r.s() == 1)
      r.transform().inverse_row(w.half[c], i, w.row_spectrum.data(), work.row_[c].data());
    else
      interpolate_row(r, i, w.points[c].data(), w.stride, work.across_.data(), work.row_[c].data());
    values[c] = work.row_[c].data();
  }
  return values;
}

void StressSolver::interpolate_row(const Resolution& r, Index i, const double* points, Index stride,
                                   double* across, double* row) const {
  const double* weights = r.interpolation().weights(i % r.s());
  const Index px = r.transform().torus().nx, m = i / r.s();
  const Index samples = std::min((grid_.shape.ny - 1) / r.s() + 2 * Interpolation::taps, stride);
  using Points = Eigen::Map<const Eigen::ArrayXd>;
  auto row_at = [&](Index t) { return Points(points + (m + t) % px * stride, samples); };
  static_assert(Interpolation::taps == 8);
  Eigen::Map<Eigen::ArrayXd>(across, samples) =
      weights[0] * row_at(0) + weights[1] * row_at(1) + weights[2] * row_at(2) + weights[3] * row_at(3) +
      weights[4] * row_at(4) + weights[5] * row_at(5) + weights[6] * row_at(6) + weights[7] * row_at(7);
  r.interpolation().refine(across, grid_.shape.ny, row);
}

double accurate_depth(const Grid& grid) { return 2 * std::max(grid.dx, grid.dy); }

}  // namespace asperity
