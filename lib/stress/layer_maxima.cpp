#include <algorithm>
#include <cmath>
#include <limits>

#include "stress/layers.hpp"
#include "stress/search.hpp"

namespace asperity {
namespace {

constexpr double same = 1e-9;                                  // of a value: neighbours of a plateau
constexpr double scan_margin = 0.03, principal_margin = 0.15;  // of the largest: starts below are left
constexpr double wide_margin = 0.1;                            // added times (spacing / depth)² at most 1

}  // namespace

bool at_centres(const Grid& grid, double z) { return z < 0.5 * accurate_depth(grid); }

LayerPeak peak_of_nine(const Nine& f) {
  const double top = f[1][1], fx = 0.5 * (f[2][1] - f[0][1]), fy = 0.5 * (f[1][2] - f[1][0]),
               fxx = f[2][1] - 2 * top + f[0][1], fyy = f[1][2] - 2 * top + f[1][0],
               fxy = 0.25 * (f[2][2] - f[2][0] - f[0][2] + f[0][0]), det = fxx * fyy - fxy * fxy;
  const double u = (fxy * fy - fyy * fx) / det, v = (fxy * fx - fxx * fy) / det;
  if (!(det > 0 && std::abs(u) <= 1 && std::abs(v) <= 1)) return peak_of_cross(f);
  return {top + 0.5 * (fx * u + fy * v), u, v};
}

LayerPeak peak_of_cross(const Nine& f) {
  const double fx = 0.5 * (f[2][1] - f[0][1]), fy = 0.5 * (f[1][2] - f[1][0]),
               fxx = f[2][1] - 2 * f[1][1] + f[0][1], fyy = f[1][2] - 2 * f[1][1] + f[1][0],
               u = fxx < 0 ? -fx / fxx : 0, v = fyy < 0 ? -fy / fyy : 0;
  return {f[1][1] + 0.5 * (fx * u + fy * v), u, v};
}

double least_start(Criterion of, const Grid& cells, double z, double top) {
  const double apart = at_centres(cells, z) ? 0 : std::min(1.0, std::max(cells.dx, cells.dy) / z),
               margin = (of == Criterion::principal ? principal_margin : scan_margin) +
                        wide_margin * apart * apart;
  return top - margin * std::abs(top);
}

WiderCells wider_cells(const LoadedBody& body, Index sx, Index sy) {
  const Grid& g = body.grid;
  WiderCells out{{g, {}, body.poisson, body.friction}};
  Grid& w = out.body.grid;
  w.shape = {(g.shape.nx + sx - 1) / sx, (g.shape.ny + sy - 1) / sy};
  w.dx *= static_cast<double>(sx), w.dy *= static_cast<double>(sy);
  out.shift_x = 0.5 * (w.size_x() - g.size_x()), out.shift_y = 0.5 * (w.size_y() - g.size_y());
  Field& p = out.body.pressure;
  p = Field::Zero(w.shape.nx, w.shape.ny);
  const double share = 1 / static_cast<double>(sx * sy);
  for (Index i = 0; i < g.shape.nx; ++i)
    for (Index j = 0; j < w.shape.ny; ++j)
      p(i / sx, j) += share * body.pressure.row(i).segment(j * sy, std::min(sy, g.shape.ny - j * sy)).sum();
  return out;
}

void add_maxima(const Field& f, const Grid& grid, Index i0, Index i1, Index j0, Index j1, double least,
                double z, std::vector<LayerMaximum>& out) {
  const Index nx = f.rows(), ny = f.cols();
  for (Index i = i0; i < i1; ++i)
    for (Index j = j0; j < j1; ++j) {
      const double top = f(i, j);
      if (!(top >= least)) continue;
      Nine nine;
      bool highest = true;
      for (int p = -1; p <= 1 && highest; ++p)
        for (int q = -1; q <= 1; ++q) {
          const bool outside = (!grid.periodic.x && (i + p < 0 || i + p >= nx)) ||
                               (!grid.periodic.y && (j + q < 0 || j + q >= ny));
          const double v =
              outside ? -std::numeric_limits<double>::infinity() : f(wrapped(i + p, nx), wrapped(j + q, ny));
          nine[size(p + 1)][size(q + 1)] = v;
          const bool earlier = p < 0 || (p == 0 && q < 0);
          const double level = std::isfinite(v) ? same * std::abs(v) : 0;
          // Of a plateau the first cell.
          if ((p != 0 || q != 0) && (earlier ? !(top > v + level) : v > top + level)) {
            highest = false;
            break;
          }
        }
      if (!highest) continue;
      for (auto& row : nine)
        if (!std::isfinite(row[0]) || !std::isfinite(row[2])) row[0] = row[2] = row[1];
      if (!std::isfinite(nine[0][1]) || !std::isfinite(nine[2][1])) nine[0] = nine[2] = nine[1];
      // Across a free edge nothing changes; above one cell nothing is read between the centres.
      const LayerPeak peak = at_centres(grid, z) ? LayerPeak{top, 0, 0} : peak_of_cross(nine);
      out.push_back({peak.value, grid.x(i) + peak.u * grid.dx, grid.y(j) + peak.v * grid.dy, z, grid.dx,
                     grid.dy, i, j});
    }
}

LayerMaximum largest_of(const Field& own, const Grid& grid, const Slabs& rows, double z) {
  struct Place {
    double value;
    Index i, j;
  };
  std::vector<Place> tops;
  if (own.size() > 0) {
    Place& top = tops.emplace_back();
    top.value = own.maxCoeff(&top.i, &top.j);
    top.i += rows.own().first;
  }
  tops = gathered(rows.ranks(), tops);
  const auto [value, i, j] = *std::ranges::max_element(tops, {}, &Place::value);
  const Index nx = grid.shape.nx, ny = grid.shape.ny;
  const Index dx = grid.periodic.x || (i > 0 && i + 1 < nx), dy = grid.periodic.y || (j > 0 && j + 1 < ny);
  const Field beside = rows_of(own, rows, {(i - dx + nx) % nx, i, (i + dx) % nx});
  Nine nine;
  for (int p = -1; p <= 1; ++p)
    for (int q = -1; q <= 1; ++q) nine[size(p + 1)][size(q + 1)] = beside(p + 1, (j + q * dy + ny) % ny);
  const LayerPeak peak = peak_of_nine(nine);
  const double x = grid.x(i) + peak.u * grid.dx, y = grid.y(j) + peak.v * grid.dy;
  return {peak.value, x, y, z, grid.dx, grid.dy, i, j};
}

}  // namespace asperity
