#include "stress/layers.hpp"

#include <algorithm>
#include <condition_variable>

#include "core/error.hpp"
#include "core/parallel.hpp"

namespace asperity {
namespace {

// Cells of constant pressure near the surface: tests/stress/surface.cpp, a Hertz contact.
constexpr double accurate_cells = 2;      // depth from which stresses are accurate
constexpr double step_error = 0.09;       // of the largest pressure, above that depth
constexpr double compliant_error = 0.11;  // times 1 - 2ν, if that is more
constexpr double sliding_error = 0.26;    // times μ, in addition

void check_plane(const Plane& plane, Shape cells) {
  const Index planes = plane.along_x ? cells.ny : cells.nx;
  check_parameter(
      plane.index >= 0 && plane.index < planes, "section",
      "plane " + std::to_string(plane.index) + " must lie in 0 ... " + std::to_string(planes - 1));
}

// compute(layer, worker), where worker < threads tells the threads apart.
using ComputeLayer = std::function<void(Index layer, int worker)>;

struct LayerQueue {
  const Index count, window;  // layers, and how many may be ahead of those handed over
  const ComputeLayer& compute;
  const LayersFinished& finished;
  std::vector<bool> complete = std::vector<bool>(static_cast<std::size_t>(count));
  Index next = 0, handed_over = 0;
  bool failed = false;
  std::mutex mutex = {};
  std::condition_variable changed = {};

  void run(int worker) {
    try {
      take_part(worker);
    } catch (...) {
      const std::lock_guard lock(mutex);
      next = count, failed = true;
      changed.notify_all();
      throw;
    }
  }

  void take_part(int worker) {
    const bool caller = worker == 0;
    auto over = [&] { return caller ? handed_over == count : next == count; };
    for (std::unique_lock lock(mutex);; changed.notify_all()) {
      changed.wait(lock, [&] { return failed || ready() || (caller && due()) || over(); });
      if (failed || over()) return;
      if (caller && due()) {
        hand_over(lock);
        continue;
      }
      const Index layer = next++;
      lock.unlock();
      compute(layer, worker);
      lock.lock();
      complete[static_cast<std::size_t>(layer)] = true;
    }
  }

  void hand_over(std::unique_lock<std::mutex>& lock) {
    const Index begin = handed_over;
    Index end = begin;
    while (end < count && complete[static_cast<std::size_t>(end)]) ++end;
    lock.unlock();
    if (finished) finished(begin, end);
    lock.lock();
    handed_over = end;
  }

  bool ready() const { return next < count && next < handed_over + window; }
  bool due() const { return handed_over < count && complete[static_cast<std::size_t>(handed_over)]; }
};

// Computes each layer < count. finished() is called from the calling thread; where there is one, no layer
// `threads` or more beyond the last that it knows is begun, so that as many buffers will do.
void in_layers(Index count, int threads, const ComputeLayer& compute, const LayersFinished& finished) {
  const Index workers = std::clamp<Index>(threads, 1, std::max<Index>(count, 1));
  LayerQueue queue{count, finished ? workers : count, compute, finished};
  parallel_ranges(workers, static_cast<int>(workers), [&](Index, Index, int worker) { queue.run(worker); });
}

}  // namespace

StressSolver::StressSolver(LoadedBody body, std::optional<Plane> section, int threads,
                           DepthResolution resolution)
    : body_(std::move(body)), section_(section), threads_(std::max(threads, 1)), levels_(1) {
  body_.check();
  if (section_) check_plane(*section_, body_.grid.shape);
  if (resolution == DepthResolution::full) return;
  for (Index s = 2; Resolution::possible(body_.grid, s); s *= 2) levels_.emplace_back().s = s;
}

Shape StressSolver::shape() const {
  const Shape& whole = body_.grid.shape;
  return section_ ? Shape{1, section_->along_x ? whole.nx : whole.ny} : whole;
}

Extent StressSolver::rows() const {
  return section_ ? Extent{0, body_.ranks->rank() == 0 ? 1 : 0} : body_.rows().own();
}

std::size_t StressSolver::level_at(double z) const {
  std::size_t level = 0;
  while (level + 1 < levels_.size() && z >= Resolution::least_depth(body_.grid, levels_[level + 1].s))
    ++level;
  return level;
}

std::shared_ptr<const LayerPlan> StressSolver::plan(Level& level) const {
  const std::scoped_lock lock(level.mutex);
  if (!level.plan)
    level.plan =
        section_ ? plan_section(body_, *section_, level.s, threads_) : plan_volume(body_, level.s, threads_);
  return level.plan;
}

void StressSolver::layer(double z, stress::Set asked, Workspace& work, const StressRowSink& row,
                         const BehindRows& behind) const {
  check_depth(z);
  const std::size_t level = level_at(z);
  work.levels_.resize(levels_.size());
  Workspace::Level& own = work.levels_[level];
  if (!own.work) {
    own.plan = plan(levels_[level]);
    own.work = own.plan->work(work.threads_);
  }
  own.work->layer(z, asked, added_ ? with_added(z, asked, row) : row, behind);
}

StressRowSink StressSolver::with_added(double z, stress::Set asked, const StressRowSink& row) const {
  std::array<Field, 6> more;
  for (stress::Component c : stress::components) {
    if (!asked[c]) continue;
    more[c] = added_->layer(z, c);
    if (!section_) continue;
    const Field line = section_->along_x ? Field(more[c].col(section_->index).transpose())
                                         : Field(more[c].row(section_->index));
    more[c] = line;
  }
  return [asked, row, more = std::move(more)](Index i, const StressRow& stress) {
    std::array<std::vector<double>, 6> sums;
    StressRow out{};
    for (stress::Component c : stress::components) {
      if (!asked[c]) continue;
      const auto line = more[c].row(i);
      sums[c].resize(stress[c].size());
      std::ranges::transform(stress[c], line, sums[c].begin(), std::plus<>());
      out[c] = sums[c];
    }
    row(i, out);
  };
}

// Sections are short; the sum over images (stress/images.hpp) is one thread's work.
bool StressSolver::together() const {
  return threads_ <= 1 || body_.ranks->count() > 1 ||
         (!section_ && !body_.grid.periodic.one() && by_component());
}

bool StressSolver::by_component() const { return shape().cells() >= shared_layer; }

void StressSolver::release(const std::vector<double>& depths, Index next, Workspace& work) const {
  std::vector<bool> needed(levels_.size());
  for (std::size_t l = size(next); l < depths.size(); ++l) needed[level_at(depths[l])] = true;
  for (std::size_t level = 0; level < work.levels_.size(); ++level) {
    if (needed[level] || !work.levels_[level].work) continue;
    work.levels_[level] = {};
    const std::scoped_lock lock(levels_[level].mutex);
    levels_[level].plan.reset();
  }
}

void StressSolver::each_layer(const std::vector<double>& depths, const LayerJob& job,
                              const LayersFinished& finished) const {
  const auto count = static_cast<Index>(depths.size());
  if (!together()) {
    std::vector<Workspace> work(size(threads_));
    in_layers(
        count, threads_, [&](Index l, int worker) { job(l, work[size(worker)]); }, finished);
    return;
  }
  Workspace work(threads_);
  for (Index l = 0; l < count; ++l) {
    job(l, work);
    if (l + 1 < count) release(depths, l + 1, work);
    if (finished) finished(l, l + 1);
  }
}

void StressSolver::layers(const std::vector<double>& depths, stress::Set asked, const LayerRowSink& row,
                          const LayersFinished& finished) const {
  each_layer(
      depths,
      [&](Index l, Workspace& work) {
        layer(depths[size(l)], asked, work, [&](Index i, const StressRow& values) { row(l, i, values); });
      },
      finished);
}

double accurate_depth(const Grid& grid) {
  auto step = [](Index cells, double spacing, bool repeats) { return repeats && cells == 1 ? 0 : spacing; };
  return accurate_cells * std::max(step(grid.shape.nx, grid.dx, grid.periodic.x),
                                   step(grid.shape.ny, grid.dy, grid.periodic.y));
}

double shallow_error(double poisson, const Friction& friction) {
  return std::max(step_error, compliant_error * (1 - 2 * poisson)) + sliding_error * friction.coefficient;
}

}  // namespace asperity
