#include "plastic/box.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"
#include "stress/equivalent.hpp"
#include "stress/layers.hpp"

namespace asperity {
namespace {

constexpr double scan_ratio = 1.25, first_scan = 0.5;      // depths of the scan, the first one in cells
constexpr Index least_margin = 4, margin_part = 8;         // cells, and a part of the window
constexpr double at_asperities = 0.25, in_the_bulk = 0.5;  // thickness of the first layer [cells]
constexpr Index more_layers = 3;                           // for a quarter of the depth, at least

Extent of_both(Extent a, Extent b) {
  if (a.count == 0 || b.count == 0) return a.count == 0 ? b : a;
  const Index first = std::min(a.first, b.first);
  return {first, std::max(a.end(), b.end()) - first};
}

// With more cells before and after it, all of a periodic axis.
Extent widened(Extent e, bool before, bool after, Index cells, bool periodic) {
  if (periodic) return {0, cells};
  const Index margin = least_margin + e.count / margin_part,
              first = std::max<Index>(e.first - (before ? margin : 0), 0),
              end = std::min(e.end() + (after ? margin : 0), cells);
  return {first, end - first};
}

// Of each layer, row by row: the cells beyond the yield stress.
using YieldingRows = std::vector<std::vector<Extent>>;

YieldingRows yielding_rows(const LoadedBody& body, const std::vector<double>& depths, double yield,
                           int threads) {
  const auto [nx, ny] = body.grid.shape;
  YieldingRows out(depths.size(), std::vector<Extent>(size(nx)));
  const StressSolver solver(body, threads, DepthResolution::adapted);
  solver.layers(depths, stress::all, [&, ny = ny](Index layer, Index i, const StressRow& row) {
    std::vector<double> values(size(ny));
    von_mises(row, values);
    const auto beyond = [&](double v) { return v > yield; };
    const auto first = std::ranges::find_if(values, beyond);
    if (first == values.end()) return;
    const auto last = std::find_if(values.rbegin(), values.rend(), beyond).base();
    out[size(layer)][size(i)] = {first - values.begin(), last - first};
  });
  return out;
}

}  // namespace

std::vector<double> graded_layers(double depth, double first, Index layers) {
  const auto n = static_cast<double>(layers);
  std::vector<double> out{0};
  double ratio = 1;
  if (first * n < depth) {
    double low = 1, high = 1e3;
    for (int step = 0; step < 100; ++step) {
      ratio = std::sqrt(low * high);
      (first * (std::pow(ratio, n) - 1) / (ratio - 1) < depth ? low : high) = ratio;
    }
  }
  for (Index k = 1; k <= layers; ++k) {
    const auto part = static_cast<double>(k);
    out.push_back(depth * (ratio == 1 ? part / n : (std::pow(ratio, part) - 1) / (std::pow(ratio, n) - 1)));
  }
  return out;
}

void FlowReach::add(Extent in_x, Extent in_y, Index to_layer) {
  x = of_both(x, in_x);
  y = of_both(y, in_y);
  layers = std::max(layers, to_layer);
}

PlasticBox yielding_box(const Grid& grid, const Field& pressure, double poisson, double yield, Index layers,
                        int threads) {
  const double cell = std::min(grid.dx, grid.dy), deepest = std::max(grid.size_x(), grid.size_y());
  std::vector<double> depths;
  for (double z = first_scan * cell; z < deepest; z *= scan_ratio) depths.push_back(z);
  const auto [x, y] = extents(pressure, [](double p) { return p > 0; });
  FlowReach reach{x, y};
  const YieldingRows found = yielding_rows({grid, pressure, poisson}, depths, yield, threads);
  for (Index l = 0; l < std::ssize(found); ++l)
    for (Index i = 0; i < grid.shape.nx; ++i)
      if (const Extent row = found[size(l)][size(i)]; row.count > 0) reach.add({i, 1}, row, l + 1);
  if (reach.layers == 0) return {reach.x, reach.y, {}};
  const bool at_surface = std::ranges::any_of(found.front(), [](Extent row) { return row.count > 0; });
  const double depth = deeper_box * std::max(depths[size(reach.layers - 1)], cell);
  return {widened(reach.x, true, true, grid.shape.nx, grid.periodic.x),
          widened(reach.y, true, true, grid.shape.ny, grid.periodic.y),
          graded_layers(depth, cell * (at_surface ? at_asperities : in_the_bulk), layers)};
}

PlasticBox grown(const PlasticBox& box, const FlowReach& reached, const Grid& grid) {
  auto more = [](Extent e, Extent of, Index cells, bool periodic) {
    if (of.count == 0) return e;
    const bool at_end = of.first + of.count >= e.first + e.count;
    return widened(e, of.first <= e.first, at_end, cells, periodic);
  };
  PlasticBox out{more(box.x, reached.x, grid.shape.nx, grid.periodic.x),
                 more(box.y, reached.y, grid.shape.ny, grid.periodic.y), box.edges};
  if (reached.layers < box.layers()) return out;
  const double depth = box.edges.back(), last = depth - box.edges[box.edges.size() - 2],
               step = std::max(last, (deeper_box - 1) * depth / static_cast<double>(more_layers));
  while (out.edges.back() < deeper_box * depth * (1 - 1e-9)) out.edges.push_back(out.edges.back() + step);
  return out;
}

}  // namespace asperity
