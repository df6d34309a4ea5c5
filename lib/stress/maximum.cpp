#include "stress/maximum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "core/calibration.hpp"
#include "core/error.hpp"
#include "core/extent.hpp"
#include "core/parallel.hpp"
#include "stress/equivalent.hpp"

namespace asperity {
namespace {

using namespace calibration::stress;

struct Parabola {
  double vertex = 0, value = 0;
};

// Through (a, fa), (b, fb), (c, fc), where fb is the largest; a point at b when they are level.
Parabola parabola(double a, double fa, double b, double fb, double c, double fc) {
  const double left = (fb - fa) / (b - a), right = (fc - fb) / (c - b), bend = (right - left) / (c - a);
  if (!(bend < 0)) return {b, fb};
  const double slope = left + bend * (b - a), step = -0.5 * slope / bend;
  return {b + step, fb + 0.5 * slope * step};
}

// The largest value of a layer, in x and y between the cell centres.
struct Peak {
  double value = 0, x = 0, y = 0;
};

// About the k-th value, the largest of `line`. Beyond an end are those of the next period, if there is one.
template <class Line>
Parabola peak_along(const Line& line, Index k, bool periodic) {
  const Index n = line.size();
  if (!periodic && (k == 0 || k + 1 == n)) return {0, line(k)};
  return parabola(-1, line((k + n - 1) % n), 0, line(k), 1, line((k + 1) % n));
}

Peak peak_of(const Field& f, const Grid& grid) {
  Index i, j;
  const double top = f.maxCoeff(&i, &j);
  const Parabola x = peak_along(f.col(j), i, grid.periodic.x), y = peak_along(f.row(i), j, grid.periodic.y);
  return {top + (x.value - top) + (y.value - top), grid.x(i) + x.vertex * grid.dx,
          grid.y(j) + y.vertex * grid.dy};
}

// A layer looked at: its depth as ln z, -∞ at the surface, and its peak.
struct Sample {
  double log_depth = 0;
  Peak peak;
};

// Half the longer side of the rectangle around the loaded cells.
double loaded_radius(const LoadedBody& body) {
  const auto [x, y] = extents(
      body.pressure, [](double p) { return p != 0; }, body.grid.periodic);
  return 0.5 *
         std::max(static_cast<double>(x.count) * body.grid.dx, static_cast<double>(y.count) * body.grid.dy);
}

std::vector<double> scan_depths(const LoadedBody& body, double below) {
  const double shallowest = std::max(scan_shallowest * std::min(body.grid.dx, body.grid.dy), below),
               first = std::log(shallowest), step = std::log(scan_ratio),
               deepest = std::log(loaded_radius(body));
  std::vector<double> log_depths;
  for (int k = 0; k < 3 || log_depths.back() < deepest; ++k) log_depths.push_back(first + k * step);
  return log_depths;
}

Parabola through(const Sample& a, const Sample& b, const Sample& c) {
  return parabola(a.log_depth, a.peak.value, b.log_depth, b.peak.value, c.log_depth, c.peak.value);
}

// Where to look next in a bracket about b: at the vertex, or where that is b, beside b on the longer side.
double next_depth(const Sample& a, const Sample& b, const Sample& c, double vertex) {
  if (std::abs(vertex - b.log_depth) >= close) return vertex;
  return c.log_depth - b.log_depth > b.log_depth - a.log_depth ? b.log_depth + beside : b.log_depth - beside;
}

bool lower(const Sample& a, const Sample& b) { return a.peak.value < b.peak.value; }

class Search {
 public:
  // Of one thread.
  struct Buffers {
    StressSolver::Workspace work;
    Field values;
  };
  using OnLayer = std::function<void(const StressProbe&)>;

  Search(const StressSolver& solver, Criterion of, const OnLayer& on_layer, Index expected)
      : solver_(solver), of_(of), on_layer_(on_layer), expected_(expected) {}

  Peak peak_at(double depth, Buffers& buffers) {
    Field& values = buffers.values;
    values.resize(solver_.shape().nx, solver_.shape().ny);
    solver_.layer(depth, stress::all, buffers.work, [&](Index i, const StressRow& row) {
      equivalent_stress(of_, row, {values.row(i).data(), row[0].size()});
    });
    const Peak peak = peak_of(values, solver_.body().grid);
    const std::scoped_lock lock(mutex_);
    ++layers_;
    if (on_layer_) on_layer_({layers_, std::max(layers_, expected_), depth, peak.value});
    return peak;
  }

  Sample at(double log_depth, Buffers& buffers) { return {log_depth, peak_at(std::exp(log_depth), buffers)}; }

  // probe(k, buffers) for each k < count, on all threads.
  template <class Probe>
  void each(std::size_t count, const Probe& probe) {
    parallel_ranges(static_cast<Index>(count), solver_.threads(), [&](Index begin, Index end, int) {
      Buffers buffers;
      for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
        probe(k, buffers);
    });
  }

  // The maximum within a bracket a < b < c whose middle is the highest: successive parabolas, the last one
  // unprobed. A vertex is off by the product of the sides times m'''/6m'': hence the test.
  Sample refine(Sample a, Sample b, Sample c, Buffers& buffers) {
    Parabola top = through(a, b, c);
    for (int step = 0; step < most_steps; ++step) {
      const double sides = (b.log_depth - a.log_depth) * (c.log_depth - b.log_depth);
      if (sides < narrow && std::abs(top.vertex - b.log_depth) < beside) break;
      const Sample next = at(next_depth(a, b, c, top.vertex), buffers);
      const bool deeper = next.log_depth > b.log_depth, higher = lower(b, next);
      (deeper == higher ? a : c) = higher ? b : next;
      if (higher) b = next;
      top = through(a, b, c);
    }
    return {top.vertex, {top.value, b.peak.x, b.peak.y}};
  }

  Index layers() const { return layers_; }

 private:
  const StressSolver& solver_;
  const Criterion of_;
  const OnLayer& on_layer_;
  Index layers_ = 0;
  const Index expected_;
  std::mutex mutex_;
};

// Of the samples of a scan; from the surface on, or where `below` lies above them, it is looked at too.
Sample highest(Search& search, const std::vector<Sample>& s, const std::optional<Sample>& start) {
  Search::Buffers buffers;
  Sample best = *std::ranges::max_element(s, lower);
  if (start) best = std::max(best, *start, lower);
  for (std::size_t k = 1; k + 1 < s.size(); ++k) {
    if (lower(s[k], s[k - 1]) || lower(s[k], s[k + 1])) continue;
    const double rise = through(s[k - 1], s[k], s[k + 1]).value - s[k].peak.value;
    if (s[k].peak.value + 2 * rise < best.peak.value) continue;
    best = std::max(best, search.refine(s[k - 1], s[k], s[k + 1], buffers), lower);
  }
  return best;
}

}  // namespace

void equivalent_stress(Criterion of, const StressRow& stress, std::span<double> out) {
  switch (of) {
    case Criterion::von_mises:
      return von_mises(stress, out);
    case Criterion::max_shear:
      return max_shear_stress(stress, out);
    case Criterion::principal:
      return largest_principal_stress(stress, out);
  }
}

void StressSearch::check() const {
  if (!(below >= 0 && below <= deepest))
    throw ParameterError("below", fmt::format("{} m is not a depth, 0 ... {:g} m", below, deepest));
}

StressMaximum maximum_stress(const StressSolver& solver, const StressSearch& wanted,
                             const std::function<void(const StressProbe&)>& on_layer) {
  wanted.check();
  if ((solver.body().pressure == 0).all()) return {};
  const std::vector<double> log_depths = scan_depths(solver.body(), wanted.below);
  const bool above_scan = !(std::log(wanted.below) >= log_depths[0]);
  Search search(solver, wanted.of, on_layer,
                static_cast<Index>(log_depths.size()) + above_scan + usual_steps);
  std::vector<Sample> samples(log_depths.size());
  search.each(samples.size(),
              [&](std::size_t k, Search::Buffers& b) { samples[k] = search.at(log_depths[k], b); });
  std::optional<Sample> start;
  Search::Buffers buffers;
  if (above_scan) start = search.at(std::log(wanted.below), buffers);
  const Sample best = highest(search, samples, start);
  const bool at_start = best.log_depth == std::log(wanted.below);
  const double depth = at_start ? wanted.below : std::exp(best.log_depth);
  return {best.peak.value, best.peak.x, best.peak.y, depth, search.layers()};
}

std::vector<StressMaximum> maximum_by_depth(const StressSolver& solver, Criterion of,
                                            const std::vector<double>& depths,
                                            const std::function<void(const StressProbe&)>& on_layer) {
  std::vector<StressMaximum> out(depths.size());
  Search search(solver, of, on_layer, static_cast<Index>(depths.size()));
  search.each(depths.size(), [&](std::size_t k, Search::Buffers& buffers) {
    const Peak peak = search.peak_at(depths[k], buffers);
    out[k] = {peak.value, peak.x, peak.y, depths[k], 1};
  });
  return out;
}

}  // namespace asperity
