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

// The largest value of a layer, in x and y between the cell centres.
struct Peak {
  double value = 0, x = 0, y = 0;
};

// The vertex of the quadratic through the nine values about the largest, with the mixed difference of the
// corners; without it, where the nine have no such vertex. Across a free edge nothing changes.
Peak peak_of(const Field& f, const Grid& grid) {
  Index i, j;
  const double top = f.maxCoeff(&i, &j);
  const Index nx = grid.shape.nx, ny = grid.shape.ny;
  const Index dx = grid.periodic.x || (i > 0 && i + 1 < nx), dy = grid.periodic.y || (j > 0 && j + 1 < ny);
  auto at = [&](Index p, Index q) { return f((i + p * dx + nx) % nx, (j + q * dy + ny) % ny); };
  const double fx = 0.5 * (at(1, 0) - at(-1, 0)), fy = 0.5 * (at(0, 1) - at(0, -1)),
               fxx = at(1, 0) - 2 * top + at(-1, 0), fyy = at(0, 1) - 2 * top + at(0, -1),
               fxy = 0.25 * (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)), det = fxx * fyy - fxy * fxy;
  double u = (fxy * fy - fyy * fx) / det, v = (fxy * fx - fxx * fy) / det;
  if (!(det > 0 && std::abs(u) <= 1 && std::abs(v) <= 1))
    u = fxx < 0 ? -fx / fxx : 0, v = fyy < 0 ? -fy / fyy : 0;
  return {top + 0.5 * (fx * u + fy * v), grid.x(i) + u * grid.dx, grid.y(j) + v * grid.dy};
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

struct Top {
  double vertex = 0, value = 0;
};

// A maximum of the scan: a < b < c in ln z whose middle is the highest, and a sample beside them, if any.
struct Bracket {
  Sample a, b, c;
  std::optional<Sample> d = {};

  double before() const { return b.log_depth - a.log_depth; }
  double behind() const { return c.log_depth - b.log_depth; }
  void narrow(const Sample& next);
  Top top() const;
};

void Bracket::narrow(const Sample& next) {
  const bool deeper = next.log_depth > b.log_depth, higher = next.peak.value > b.peak.value;
  Sample& end = deeper == higher ? a : c;
  d = end;
  end = higher ? b : next;
  if (higher) b = next;
}

// The maximum of f(u) = f(b) + s u + t u² + k u (u+l)(u-r) through the samples, u = ln z from b on; with
// k = 0 without a fourth one, or if the cubic has no maximum in the bracket.
Top Bracket::top() const {
  const double l = before(), r = behind(), fb = b.peak.value, left = (fb - a.peak.value) / l,
               right = (c.peak.value - fb) / r, t = (right - left) / (l + r), s = left + t * l;
  auto of = [&](double u, double k) { return u * (s + u * t + k * (u + l) * (u - r)); };
  auto vertex = [&](double k) {  // where s - k l r + 2 (t + k (l-r)) u + 3k u² falls through 0
    const double slope = s - k * l * r, bend = t + k * (l - r);
    return slope / (std::sqrt(bend * bend - 3 * k * slope) - bend);
  };
  if (d) {
    const double u = d->log_depth - b.log_depth,
                 k = (d->peak.value - fb - of(u, 0)) / (u * (u + l) * (u - r)), v = vertex(k);
    if (v > -l && v < r) return {b.log_depth + v, fb + of(v, k)};
  }
  if (!(t < 0)) return {b.log_depth, fb};
  return {b.log_depth + vertex(0), fb + of(vertex(0), 0)};
}

// Where to look next: at the vertex, or where that is b, beside b on the longer side.
double next_depth(const Bracket& in, double vertex) {
  const double b = in.b.log_depth;
  if (std::abs(vertex - b) >= close) return vertex;
  return in.behind() > in.before() ? b + beside : b - beside;
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

  // The maximum within a bracket by successive cubics, the last one unprobed. A vertex is off by the product
  // of the sides times m'''/6m'', of a parabola, or less: hence the test.
  Sample refine(Bracket in, Buffers& buffers) {
    Top top = in.top();
    for (int step = 0; step < most_steps; ++step) {
      if (in.before() * in.behind() < narrow && std::abs(top.vertex - in.b.log_depth) < beside) break;
      in.narrow(at(next_depth(in, top.vertex), buffers));
      top = in.top();
    }
    return {top.vertex, {top.value, in.b.peak.x, in.b.peak.y}};
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
    const Bracket in{s[k - 1], s[k], s[k + 1]};
    const double rise = in.top().value - s[k].peak.value;
    if (s[k].peak.value + 2 * rise < best.peak.value) continue;
    best = std::max(best, search.refine(in, buffers), lower);
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
