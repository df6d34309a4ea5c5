#include "stress/layers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "grid/error.hpp"
#include "grid/parallel.hpp"
#include "transform/convolution.hpp"

namespace asperity {
namespace {

using stress::Component;

constexpr Index width = PrunedTransform::width;
static_assert(width == LayerInfluence::width);

std::size_t size(Index n) { return static_cast<std::size_t>(n); }

Shape torus_of(const Grid& grid) { return grid.periodic ? grid.shape : padded_torus(grid.shape); }

void check(const Grid& grid, const Field& pressure, const Friction& friction, double poisson) {
  friction.check();
  if (!(poisson >= 0 && poisson <= 0.5))
    throw ParameterError("poisson", fmt::format("{} is not between 0 and 0.5", poisson));
  if (shape_of(pressure) != grid.shape) throw DataError("pressure", "its shape is not that of the grid");
  if (!pressure.isFinite().all()) throw DataError("pressure", "holds a value that is not a finite number");
}

// The factor s sin(a)/sin(sa), a = πk/P: (2) in one direction.
std::vector<double> ratios(Index s, Index modes, Index period) {
  std::vector<double> out(size(modes), 1.0);
  for (Index k = 1; s > 1 && k < modes; ++k) {
    const double a = std::numbers::pi * static_cast<double>(k) / static_cast<double>(period);
    out[size(k)] = static_cast<double>(s) * std::sin(a) / std::sin(static_cast<double>(s) * a);
  }
  return out;
}

// Cells between the loaded ones and where the torus would fold them onto the far end of the field.
Index room_beside(const Field& pressure, Shape torus) {
  auto room = [](const auto& loaded, Index half_period) {  // of one row or column of flags
    const Index n = loaded.size();
    Index first = 0, last = n - 1;
    while (first < n && !loaded(first)) ++first;
    while (last > first && !loaded(last)) --last;
    return half_period - std::max(n - first, last + 1);
  };
  const Eigen::Array<bool, Eigen::Dynamic, 1> rows = (pressure != 0).rowwise().any();
  const Eigen::Array<bool, 1, Eigen::Dynamic> columns = (pressure != 0).colwise().any();
  return std::min(room(rows, torus.nx / 2), room(columns, torus.ny / 2));
}

// -i a z.
Complex turn(double a, const Complex& z) { return {a * z.imag(), -a * z.real()}; }

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
      transform_(grid.shape, torus_of(grid)),
      pressure_spectrum_(size(transform_.blocks() * transform_.block_size())) {
  check(grid, pressure, friction, poisson);
  add_level(1);
  if (resolution == DepthResolution::adapted)
    for (Index s = 2; may_coarsen(s); s *= 2) add_level(s);
  HalfSpectrum half = transform_.half_spectrum();
  transform_.forward_rows(pressure_ / static_cast<double>(transform_.torus().cells()), half, threads);
  AlignedVector<Complex> work(size(transform_.block_size()));
  for (Index b = 0; b < transform_.blocks(); ++b)
    transform_.forward_block(half, b, pressure_spectrum_.data() + b * transform_.block_size(), work.data());
}

bool StressSolver::may_coarsen(Index s) const {
  const Shape torus = transform_.torus();
  return torus.nx % (2 * s) == 0 && torus.ny % (2 * s) == 0 &&
         std::min(grid_.shape.nx, grid_.shape.ny) / s >= 32 &&
         (grid_.periodic || room_beside(pressure_, torus) >= 8 * s);
}

void StressSolver::add_level(Index s) {
  const auto [px, py] = transform_.torus();
  const auto f = static_cast<double>(s);
  Level level{s, grid_, transform_.torus(), {px / 2 + 1, py / 2 + 1}, {}, {}};
  if (s > 1)
    level.modes = {px / (2 * s), py / (2 * s)};  // the highest mode, whose sign is not told, left out
  if (!grid_.periodic) {
    level.torus = {px / s, py / s};
    level.grid.dx *= f, level.grid.dy *= f;
    // What is cut off a spectrum spreads beyond the field: all lags of the torus count.
    if (s > 1) level.grid.shape = {level.torus.nx / 2 + 1, level.torus.ny / 2 + 1};
  }
  level.ratio_x = ratios(grid_.periodic ? 1 : s, level.modes.nx, px);
  level.ratio_y = ratios(grid_.periodic ? 1 : s, level.modes.ny, py);
  levels_.push_back(std::move(level));
}

// The coarsest that is deep enough.
std::size_t StressSolver::level_at(double z) const {
  const double cell = std::max(grid_.dx, grid_.dy);
  std::size_t level = 0;
  while (level + 1 < levels_.size() && z >= 8 * static_cast<double>(levels_[level + 1].s) * cell) ++level;
  return level;
}

StressSolver::Workspace::Workspace(const StressSolver& solver)
    : influences_(solver.levels_.size()),
      block_(size(solver.transform_.block_size())),
      work_(block_.size()),
      row_spectrum_(size(solver.transform_.blocks() * width)) {}

LayerInfluence& StressSolver::Workspace::influence(const StressSolver& solver, std::size_t level) {
  const Level& l = solver.levels_[level];
  if (!influences_[level])
    influences_[level] = make_layer_influence(l.grid, l.torus, solver.poisson_, acting(solver.weights_));
  return *influences_[level];
}

void StressSolver::layers(const std::vector<double>& depths, stress::Set asked,
                          const LayerRowSink& row) const {
  parallel_ranges(static_cast<Index>(depths.size()), threads_, [&](Index begin, Index end, int) {
    Workspace work(*this);
    for (Index l = begin; l < end; ++l)
      layer(depths[size(l)], asked, work, [&](Index i, const StressRow& values) { row(l, i, values); });
  });
}

void StressSolver::transform_layer(double z, stress::Set asked, Workspace& work) const {
  if (!(z >= 0 && std::isfinite(z)))
    throw ParameterError("depth", fmt::format("{} m is not a depth, 0 or more", z));
  const Level& level = levels_[level_at(z)];
  LayerInfluence& influence = work.influence(*this, level_at(z));
  influence.descend(z, asked);
  for (Component c : stress::components)
    if (asked[c] && work.half_[c].empty()) work.half_[c] = transform_.half_spectrum();
  work.filled_ = (level.modes.ny + width - 1) / width;
  for (Index b = 0; b < work.filled_; ++b)
    for (Component c : stress::components) {
      if (!asked[c]) continue;
      multiply(level, c, b, influence, work.block_.data());
      transform_.inverse_block(work.block_.data(), b, work.half_[c], work.work_.data());
    }
}

// product = (-i)^m (S + iT) p^, S and T of Column.
void StressSolver::multiply(const Level& level, Component c, Index b, LayerInfluence& influence,
                            Complex* product) const {
  std::array<LayerInfluence::Symbol, 3> symbols{};
  for (stress::Traction t : stress::tractions)
    if (weights_[t] != 0) symbols[t] = influence.symbol(t, c, b);
  for (Index q = 0; q < width; ++q) {
    const Complex* p = pressure_spectrum_.data() + b * transform_.block_size() + q * transform_.stride();
    Complex* out = product + q * transform_.stride();
    const Index ky = b * width + q;
    if (ky >= level.modes.ny)
      std::fill_n(out, transform_.torus().nx, Complex{});
    else
      multiply_column(level, c, Column(symbols, weights_, c, q), level.ratio_y[size(ky)], p, out);
  }
}

void StressSolver::multiply_column(const Level& level, Component c, const Column& column, double ratio_y,
                                   const Complex* p, Complex* out) const {
  const Index nx = transform_.torus().nx, modes = level.modes.nx;
  const bool turned = odd_in_x(c) != odd_in_y(c);
  const double ahead = odd_in_x(c) && odd_in_y(c) ? -ratio_y : ratio_y, back = odd_in_x(c) ? -ahead : ahead;
  auto each_mode = [&](auto response) {
    for (Index k = 0; k < modes; ++k) out[k] = response(k, 1, ahead * level.ratio_x[size(k)], p[k]);
    if (level.s > 1) std::fill(out + modes, out + nx - modes + 1, Complex{});
    for (Index k = std::max(nx - modes + 1, nx / 2 + 1); k < nx; ++k)
      out[k] = response(nx - k, -1, back * level.ratio_x[size(nx - k)], p[k]);
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

StressRow StressSolver::inverse_row(Index i, stress::Set asked, Workspace& work) const {
  StressRow values{};
  for (Component c : stress::components) {
    if (!asked[c]) continue;
    work.row_[c].resize(size(transform_.torus().ny + 2));
    transform_.inverse_row(work.half_[c], i, work.row_spectrum_.data(), work.row_[c].data(), work.filled_);
    values[c] = work.row_[c].data();
  }
  return values;
}

double accurate_depth(const Grid& grid) { return 2 * std::max(grid.dx, grid.dy); }

}  // namespace asperity
