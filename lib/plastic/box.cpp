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

Extent with_margin(Extent e, Index before, Index after, Index cells, bool periodic) {
  const Index first = std::max<Index>(e.first - before, 0), end = std::min(e.end() + after, cells);
  return periodic ? Extent{0, cells} : Extent{first, end - first};
}

// Of a layer: the cells beyond the yield stress, row by row.
struct Scanned {
  std::vector<Extent> rows;
  bool any() const {
    return std::ranges::any_of(rows, [](Extent row) { return row.count > 0; });
  }
};

std::vector<Scanned> scanned(const LoadedBody& body, const std::vector<double>& depths, double yield,
                             int threads) {
  const auto [nx, ny] = body.grid.shape;
  std::vector<Scanned> out(depths.size(), Scanned{std::vector<Extent>(size(nx))});
  const StressSolver solver(body, threads, DepthResolution::adapted);
  solver.layers(depths, stress::all, [&, ny = ny](Index layer, Index i, const StressRow& row) {
    std::vector<double> values(size(ny));
    von_mises(row, values);
    const auto beyond = [&](double v) { return v > yield; };
    const auto first = std::ranges::find_if(values, beyond);
    if (first == values.end()) return;
    const auto last = std::find_if(values.rbegin(), values.rend(), beyond).base();
    out[size(layer)].rows[size(i)] = {first - values.begin(), last - first};
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

PlasticBox yielding_box(const Grid& grid, const Field& pressure, double poisson, double yield, Index layers,
                        int threads) {
  const double cell = std::min(grid.dx, grid.dy), deepest = std::max(grid.size_x(), grid.size_y());
  std::vector<double> depths;
  for (double z = first_scan * cell; z < deepest; z *= scan_ratio) depths.push_back(z);
  PlasticBox box;
  const auto [x, y] = extents(pressure, [](double p) { return p > 0; });
  box.x = x, box.y = y;
  const std::vector<Scanned> found = scanned({grid, pressure, poisson}, depths, yield, threads);
  double depth = 0;
  for (std::size_t l = 0; l < depths.size(); ++l) {
    if (!found[l].any()) continue;
    depth = depths[l];
    for (Index i = 0; i < grid.shape.nx; ++i)
      if (const Extent row = found[l].rows[size(i)]; row.count > 0)
        box.x = of_both(box.x, {i, 1}), box.y = of_both(box.y, row);
  }
  if (depth == 0) return box;
  const Index margin_x = least_margin + box.x.count / margin_part,
              margin_y = least_margin + box.y.count / margin_part;
  box.x = with_margin(box.x, margin_x, margin_x, grid.shape.nx, grid.periodic.x);
  box.y = with_margin(box.y, margin_y, margin_y, grid.shape.ny, grid.periodic.y);
  const double first = cell * (found.front().any() ? at_asperities : in_the_bulk);
  box.edges = graded_layers(deeper_box * std::max(depth, cell), first, layers);
  return box;
}

PlasticBox grown(const PlasticBox& box, const BoxSides& sides, const Grid& grid) {
  auto more = [](bool side, Extent e) { return side ? least_margin + e.count / margin_part : 0; };
  PlasticBox out = box;
  out.x =
      with_margin(box.x, more(sides.west, box.x), more(sides.east, box.x), grid.shape.nx, grid.periodic.x);
  out.y =
      with_margin(box.y, more(sides.south, box.y), more(sides.north, box.y), grid.shape.ny, grid.periodic.y);
  if (!sides.bottom) return out;
  const double depth = box.edges.back(), last = depth - box.edges[box.edges.size() - 2],
               step = std::max(last, (deeper_box - 1) * depth / static_cast<double>(more_layers));
  while (out.edges.back() < deeper_box * depth * (1 - 1e-9)) out.edges.push_back(out.edges.back() + step);
  return out;
}

}  // namespace asperity
