#include "stress/layers.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/poisson.hpp"
#include "stress/response.hpp"

namespace asperity {
namespace {

using stress::Component;

constexpr Index width = PrunedTransform::width;
static_assert(width == LayerInfluence::width);

std::size_t size(Index n) { return static_cast<std::size_t>(n); }

// Of the largest: squares of its stresses, also deep below it, are numbers that doubles hold.
constexpr double least_pressure = 1e-100, greatest_pressure = 1e100;

// From one of eight rows to the next.
Index apart(Index ny) { return (ny + width - 1) / width * width; }

}  // namespace

void check_load(const Grid& grid, const Field& pressure, const Friction& friction, double poisson) {
  friction.check();
  check_poisson(poisson);
  if (shape_of(pressure) != grid.shape) throw DataError("pressure", "its shape is not that of the grid");
  if (pressure.size() == 0) throw DataError("pressure", "it has no cells");
  if (!(grid.dx > 0 && grid.dy > 0 && grid.size_x() <= farthest && grid.size_y() <= farthest))
    throw DataError("pressure", fmt::format("its cells of {} m x {} m are no cells", grid.dx, grid.dy));
  if (!pressure.isFinite().all()) throw DataError("pressure", "holds a value that is not a finite number");
  const double largest = pressure.abs().maxCoeff();
  if (largest != 0 && !(largest >= least_pressure && largest <= greatest_pressure))
    throw DataError("pressure", fmt::format("{} Pa is its largest value: must lie in {:g} ... {:g} Pa",
                                            largest, least_pressure, greatest_pressure));
  if (!(friction.coefficient * largest <= greatest_pressure))
    throw ParameterError("friction", fmt::format("{} of {} Pa is a traction above {:g} Pa",
                                                 friction.coefficient, largest, greatest_pressure));
}

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
      levels_(grid, resolution) {
  check_load(grid, pressure, friction, poisson);
}

const Resolution& StressSolver::resolution(std::size_t level) const {
  return levels_.get(
      level, [&](Index s) { return std::make_unique<const Resolution>(grid_, pressure_, s, threads_); });
}

StressSolver::Workspace::Level& StressSolver::prepared(Workspace& work, std::size_t level,
                                                       stress::Set asked) const {
  const Resolution& r = resolution(level);
  const PrunedTransform& t = r.transform();
  work.present_ = level;
  work.levels_.resize(levels_.count());
  Workspace::Level& w = work.levels_[level];
  if (!w.influence) {
    w.influence = make_layer_influence(r.cells(), t.torus(), poisson_, acting(weights_), r.taper());
    w.block.resize(size(t.block_size()));
    w.work.resize(size(t.block_size()));
    w.rows = t.row_work();
    w.stride = t.torus().ny + 2 * width;
  }
  const Index row =
      r.s() == 1 ? RowTransform::rows * apart(grid_.shape.ny) : r.interpolation().padded(grid_.shape.ny);
  for (Component c : stress::components) {
    if (!asked[c]) continue;
    if (w.half[c].empty()) w.half[c] = t.half_spectrum();
    if (r.s() > 1) w.points[c].resize(size(t.torus().nx * w.stride));
    work.rows_[c].resize(std::max(work.rows_[c].size(), size(row)));
  }
  work.across_.resize(std::max(work.across_.size(), size(w.stride)));
  return w;
}

void StressSolver::layers(const std::vector<double>& depths, stress::Set asked, const LayerRowSink& row,
                          const LayersFinished& finished) const {
  auto compute = [&](Index l, Workspace& work) {
    layer(depths[size(l)], asked, work, [&](Index i, const StressRow& values) { row(l, i, values); });
  };
  in_layers<Workspace>(static_cast<Index>(depths.size()), threads_, compute, finished);
}

void StressSolver::transform_layer(double z, stress::Set asked, Workspace& work) const {
  check_depth(z);
  const std::size_t level = levels_.at(z);
  const Resolution& r = resolution(level);
  const PrunedTransform& t = r.transform();
  Workspace::Level& w = prepared(work, level, asked);
  w.influence->descend(z, asked);
  for (Index b = 0; b < t.blocks(); ++b)
    for (Component c : stress::components) {
      if (!asked[c]) continue;
      respond(*w.influence, weights_, c, b, t, r.pressure(b), w.block.data());
      t.inverse_block(w.block.data(), b, w.half[c], w.work.data());
    }
  if (r.s() > 1) invert_points(r, asked, w);
}

// The rows of a coarse layer around the cells, from `before` ahead of the first, each with what stands before and
// behind it on the torus.
void StressSolver::invert_points(const Resolution& r, stress::Set asked, Workspace::Level& w) const {
  constexpr Index before = Interpolation::before;
  const auto [px, py] = r.transform().torus();
  const Index end = std::min((grid_.shape.nx - 1) / r.s() + Interpolation::taps, px) - before;
  for (Component c : stress::components) {
    if (!asked[c]) continue;
    auto invert = [&, py = py](Index first, Index count, double* to) {
      r.transform().inverse_group(w.half[c], first, count, py, to + before, w.stride, w.rows);
      for (double* row = to; row < to + count * w.stride; row += w.stride) {
        std::copy_n(row + py, before, row);
        for (Index j = py + before; j < w.stride; ++j) row[j] = row[j - py];
      }
    };
    invert(px - before, before, w.points[c].data());
    for (Index i = 0; i < end; i += RowTransform::rows)
      invert(i, std::min(RowTransform::rows, end - i), w.points[c].data() + (before + i) * w.stride);
  }
}

StressRow StressSolver::row_of(Index i, stress::Set asked, Workspace& work) const {
  const Resolution& r = resolution(work.present_);
  Workspace::Level& w = work.levels_[work.present_];
  const auto [nx, ny] = grid_.shape;
  const Index in_group = r.s() == 1 ? i % RowTransform::rows : 0;
  StressRow values{};
  for (Component c : stress::components) {
    if (!asked[c]) continue;
    double* rows = work.rows_[c].data();
    if (r.s() > 1)
      interpolate_row(r, i, w.points[c].data(), w.stride, work.across_.data(), rows);
    else if (in_group == 0)
      r.transform().inverse_group(w.half[c], i, std::min(RowTransform::rows, nx - i), ny, rows, apart(ny),
                                  w.rows);
    values[c] = rows + in_group * apart(ny);
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

void check_depth(double z) {
  if (!(z >= 0 && z <= farthest))
    throw ParameterError("depth", fmt::format("{} m is not a depth, 0 ... {:g} m", z, farthest));
}

double accurate_depth(const Grid& grid) {
  auto step = [&](Index cells, double spacing) { return grid.periodic && cells == 1 ? 0 : spacing; };
  return 2 * std::max(step(grid.shape.nx, grid.dx), step(grid.shape.ny, grid.dy));
}

double shallow_error(double poisson, const Friction& friction) {
  return std::max(0.09, 0.11 * (1 - 2 * poisson)) + 0.26 * friction.coefficient;
}

}  // namespace asperity
