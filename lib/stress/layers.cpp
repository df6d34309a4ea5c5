#include "stress/layers.hpp"

#include <algorithm>

#include "core/calibration.hpp"

namespace asperity {

StressSolver::StressSolver(LoadedBody body, std::optional<Plane> section, int threads,
                           DepthResolution resolution)
    : body_(std::move(body)), section_(section), threads_(threads), levels_(1) {
  body_.check();
  if (resolution == DepthResolution::full) return;
  for (Index s = 2; Resolution::possible(body_.grid, s); s *= 2) levels_.emplace_back().s = s;
}

Shape StressSolver::shape() const {
  const Shape& whole = body_.grid.shape;
  return section_ ? Shape{1, section_->along_x ? whole.nx : whole.ny} : whole;
}

std::size_t StressSolver::level_at(double z) const {
  std::size_t level = 0;
  while (level + 1 < levels_.size() && z >= Resolution::least_depth(body_.grid, levels_[level + 1].s))
    ++level;
  return level;
}

const LayerPlan& StressSolver::plan(Level& level) const {
  std::call_once(level.asked, [&] {
    level.plan =
        section_ ? plan_section(body_, *section_, level.s, threads_) : plan_volume(body_, level.s, threads_);
  });
  return *level.plan;
}

void StressSolver::layer(double z, stress::Set asked, Workspace& work, const StressRowSink& row) const {
  check_depth(z);
  const std::size_t level = level_at(z);
  work.levels_.resize(levels_.size());
  std::unique_ptr<LayerWork>& at_level = work.levels_[level];
  if (!at_level) at_level = plan(levels_[level]).work();
  at_level->set_depth(z, asked);
  for (Index i = 0; i < shape().nx; ++i) row(i, at_level->row(i));
}

void StressSolver::layers(const std::vector<double>& depths, stress::Set asked, const LayerRowSink& row,
                          const LayersFinished& finished) const {
  std::vector<Workspace> work(static_cast<std::size_t>(std::max(threads_, 1)));
  auto compute = [&](Index l, int worker) {
    layer(depths[static_cast<std::size_t>(l)], asked, work[static_cast<std::size_t>(worker)],
          [&](Index i, const StressRow& values) { row(l, i, values); });
  };
  in_layers(static_cast<Index>(depths.size()), threads_, compute, finished);
}

double accurate_depth(const Grid& grid) {
  auto step = [](Index cells, double spacing, bool repeats) { return repeats && cells == 1 ? 0 : spacing; };
  return calibration::stress::accurate_cells * std::max(step(grid.shape.nx, grid.dx, grid.periodic.x),
                                                        step(grid.shape.ny, grid.dy, grid.periodic.y));
}

double shallow_error(double poisson, const Friction& friction) {
  using namespace calibration::stress;
  return std::max(edge_error, edge_error_compliant * (1 - 2 * poisson)) +
         edge_error_friction * friction.coefficient;
}

}  // namespace asperity
