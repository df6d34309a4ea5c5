#include "stress/maximum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/extent.hpp"
#include "core/parallel.hpp"
#include "stress/equivalent.hpp"
#include "stress/search.hpp"

namespace asperity {
namespace {

// Of an estimate: maxima below are left.
constexpr double estimate_margin = 0.01, estimate_margin_of_waves = 0.05;
constexpr double recurrence = 1e-9;  // of the value: round-off of a layer is 1e-13
constexpr double same_place = 0.25;  // of the depth: maxima of two layers that are one

// Half the longer side of the rectangle around the loaded cells.
double loaded_radius(const LoadedBody& body) {
  const auto [x, y] = extents(
      body.pressure, [](double p) { return p != 0; }, body.grid.periodic);
  return 0.5 *
         std::max(static_cast<double>(x.count) * body.grid.dx, static_cast<double>(y.count) * body.grid.dy);
}

// Depths of the scan, each √2 times the last.
std::vector<double> scan_depths(const LoadedBody& body, double below) {
  const double shallowest = StressSearch::shallowest * std::min(body.grid.dx, body.grid.dy),
               deepest = loaded_radius(body);
  std::vector<double> depths;
  if (below < shallowest) depths.push_back(below);
  for (int k = 0; k < 3 || depths.back() < deepest; ++k)
    depths.push_back(std::max(shallowest, below) * std::pow(scan_ratio, k));
  return depths;
}

// How many cells, a power of two, make up the widest that will do at this depth.
Index width_at(double z, double spacing, Index n, bool periodic) {
  Index s = 1;
  while (2.0 * static_cast<double>(s) * spacing * wide_cell_depth <= z &&
         n >= 2 * s * Resolution::least_cells && !(periodic && n % (2 * s) != 0))
    s *= 2;
  return s;
}

using OnLayer = std::function<void(const StressProbe&)>;

class Search {
 public:
  Search(const StressSolver& solver, const StressSearch& wanted, const OnLayer& on_layer)
      : solver_(solver),
        body_(solver.body()),
        wanted_(wanted),
        on_layer_(on_layer),
        depths_(scan_depths(body_, wanted.below)) {}

  StressMaximum run() {
    const Grid& grid = body_.grid;
    const auto deep = ShallowSearch::possible(grid)
                          ? std::ranges::lower_bound(depths_, ShallowSearch::deepest(grid))
                          : depths_.begin();
    for (auto k = static_cast<std::size_t>(deep - depths_.begin()); k < depths_.size();) k = whole_layers(k);
    shallow_layers({depths_.begin(), deep});
    return refined();
  }

 private:
  double known() const {
    double top = -std::numeric_limits<double>::infinity();
    for (const LayerMaximum& m : starts_) top = std::max(top, m.value);
    return top;
  }
  bool at_centres(const LayerMaximum& m) const { return asperity::at_centres(body_.grid, m.z); }
  double start(const LayerMaximum& m, double top) const {
    Grid cells = body_.grid;
    cells.dx = m.dx, cells.dy = m.dy;
    return least_start(wanted_.of, cells, m.z, top);
  }

  void report(double depth, double value) {
    const auto expected = static_cast<Index>(depths_.size());
    ++layers_;
    if (on_layer_) on_layer_({layers_, std::max(layers_, expected), depth, value});
  }

  // From layer k on those of the same cells, and where they end.
  std::size_t whole_layers(std::size_t k) {
    const Grid& g = body_.grid;
    auto widths = [&](double z) {
      return std::pair{width_at(z, g.dx, g.shape.nx, g.periodic.x),
                       width_at(z, g.dy, g.shape.ny, g.periodic.y)};
    };
    const auto own = widths(depths_[k]);
    std::size_t end = k + 1;
    while (end < depths_.size() && widths(depths_[end]) == own) ++end;
    const WiderCells wider = wider_cells(body_, own.first, own.second);
    const StressSolver solver(wider.body, solver_.threads());
    std::vector<std::vector<LayerMaximum>> found(end - k);
    parallel_ranges(static_cast<Index>(end - k), solver.threads(), [&](Index from, Index to, int) {
      StressSolver::Workspace work;
      for (Index l = from; l < to; ++l) found[size(l)] = maxima_at(solver, depths_[k + size(l)], work);
    });
    for (auto& layer : found)
      for (LayerMaximum& m : layer) {
        m.x += wider.shift_x, m.y += wider.shift_y;
        starts_.push_back(m);
      }
    return end;
  }

  std::vector<LayerMaximum> maxima_at(const StressSolver& solver, double z, StressSolver::Workspace& work) {
    const auto [nx, ny] = solver.shape();
    Field values(nx, ny);
    solver.layer(z, stress::all, work, [&](Index i, const StressRow& row) {
      equivalent_stress(wanted_.of, row, {values.row(i).data(), row[0].size()});
    });
    const double top = values.maxCoeff();
    std::vector<LayerMaximum> out;
    const Grid& cells = solver.body().grid;
    add_maxima(values, cells, 0, nx, 0, ny, least_start(wanted_.of, cells, z, top), z, out);
    if (out.empty()) out.push_back(largest_of(values, cells, Slabs(nx), z));  // all level
    const std::scoped_lock lock(mutex_);
    report(z, top);
    return out;
  }

  void shallow_layers(const std::vector<double>& depths) {
    if (depths.empty()) return;
    const auto found = ShallowSearch::maxima(body_, wanted_.of, depths, known(), solver_.threads());
    for (double z : depths) {
      double top = 0;
      for (const LayerMaximum& m : found)
        if (m.z == z) top = std::max(top, m.value);
      report(z, top);
    }
    starts_.insert(starts_.end(), found.begin(), found.end());
  }

  // Whether the layer above or below has a higher maximum at the same place.
  bool on_a_slope(const LayerMaximum& m) const {
    const std::size_t k = layer_of(m.z);
    const Grid& g = body_.grid;
    auto apart = [](double a, double b, double length, bool periodic) {
      return periodic ? std::abs(std::remainder(a - b, length)) : std::abs(a - b);
    };
    return std::ranges::any_of(starts_, [&](const LayerMaximum& other) {
      const std::size_t l = layer_of(other.z);
      const bool less = at_centres(other) && !at_centres(m);  // of what it is the largest
      if (!(other.value > m.value) || (l + 1 != k && l != k + 1) || less) return false;
      auto near = [&](double one, double two) {
        return at_centres(m) ? 0.5 * one : std::max(one, two) + same_place * m.z;
      };
      return apart(m.x, other.x, g.size_x(), g.periodic.x) <= near(m.dx, other.dx) &&
             apart(m.y, other.y, g.size_y(), g.periodic.y) <= near(m.dy, other.dy);
    });
  }

  std::size_t layer_of(double z) const {
    return static_cast<std::size_t>(std::ranges::find(depths_, z) - depths_.begin());
  }

  // Whether both are the same maximum of a pattern that recurs: alike but for round-off.
  static bool recurs(const LayerMaximum& m, const LayerMaximum& before) {
    const double alike = recurrence * std::abs(before.value);
    return m.z == before.z && std::abs(m.value - before.value) <= alike &&
           std::abs(m.rise - before.rise) <= alike;
  }

  // Those that may lead above the others' values in the field, sorted by what they may reach.
  std::vector<PeakFinder::Estimate> looked_at(const PeakFinder& finder) {
    std::ranges::stable_sort(starts_, std::ranges::greater{}, &LayerMaximum::value);
    double top = -std::numeric_limits<double>::infinity();
    std::vector<PeakFinder::Estimate> out;
    const LayerMaximum* before = nullptr;
    for (const LayerMaximum& m : starts_) {
      if (m.value + 2 * m.rise < start(m, top) || (before && recurs(m, *before)) || on_a_slope(m)) continue;
      before = &m;
      out.push_back(finder.estimate({m.value, m.x, m.y, m.z}));
      top = std::max(top, out.back().at.value);
    }
    std::ranges::stable_sort(out, std::ranges::greater{}, &PeakFinder::Estimate::reaches);
    return out;
  }

  StressMaximum refined() {
    const PeakFinder finder(body_, wanted_.of, wanted_.below, solver_.threads());
    StressPlace best{-std::numeric_limits<double>::infinity(), 0, 0, 0};
    const double margin = body_.grid.periodic.both() ? estimate_margin_of_waves : estimate_margin;
    for (const auto& [from, reaches] : looked_at(finder)) {
      if (reaches + margin * std::abs(reaches) < best.value) break;
      if (const StressPlace top = finder.find(from, best.value); top.value > best.value) best = top;
    }
    const Grid& g = body_.grid;
    auto inside = [](double place, double length, bool periodic) {
      return periodic ? std::remainder(place, length) : place;
    };
    return {best.value, inside(best.x, g.size_x(), g.periodic.x), inside(best.y, g.size_y(), g.periodic.y),
            best.z, layers_};
  }

  const StressSolver& solver_;
  const LoadedBody& body_;
  const StressSearch wanted_;
  const OnLayer& on_layer_;
  const std::vector<double> depths_;
  std::vector<LayerMaximum> starts_;
  Index layers_ = 0;
  std::mutex mutex_;
};

void check_whole(const StressSolver& solver) {
  if (!(solver.shape() == solver.body().grid.shape))
    throw ParameterError("section", "the largest stress is one of whole layers");
}

}  // namespace

double equivalent_stress(Criterion of, const stress::Tensor& s) {
  if (of == Criterion::von_mises) return von_mises(s);
  if (of == Criterion::max_shear) return max_shear_stress(s);
  return principal_stress(s).value[0];
}

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
  check_whole(solver);
  if ((solver.body().pressure == 0).all()) return {};
  return Search(solver, wanted, on_layer).run();
}

std::vector<StressMaximum> maximum_by_depth(const StressSolver& solver, Criterion of,
                                            const std::vector<double>& depths,
                                            const std::function<void(const StressProbe&)>& on_layer) {
  check_whole(solver);
  const LoadedBody& body = solver.body();
  std::vector<StressMaximum> out(depths.size());
  std::vector<Field> values(size(solver.threads()));
  Index done = 0;
  solver.each_layer(
      depths,
      [&](Index l, StressSolver::Workspace& work) {
        Field& layer = values[size(l) % values.size()];
        const Extent own = solver.rows();
        layer.resize(own.count, solver.shape().ny);
        solver.layer(depths[size(l)], stress::all, work, [&](Index i, const StressRow& row) {
          equivalent_stress(of, row, {layer.row(i - own.first).data(), row[0].size()});
        });
        const LayerMaximum peak = largest_of(layer, body.grid, body.rows(), depths[size(l)]);
        out[size(l)] = {peak.value, peak.x, peak.y, depths[size(l)], 1};
      },
      [&](Index begin, Index end) {
        for (Index l = begin; l < end; ++l)
          if (on_layer)
            on_layer({++done, static_cast<Index>(depths.size()), depths[size(l)], out[size(l)].value});
      });
  return out;
}

}  // namespace asperity
