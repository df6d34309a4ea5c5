/// Grids of half as many cells along each side, and how far a figure moves from one to the next. Fields on
/// the coarser grid are means of 2 × 2 cells; an odd last line is left out.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/field.hpp"
#include "core/parallel.hpp"

namespace asperity {

inline Shape halved(Shape s) { return {s.nx / 2, s.ny / 2}; }

/// Of an even number of cells: the same domain.
inline Grid halved(const Grid& grid) { return {halved(grid.shape), 2 * grid.dx, 2 * grid.dy, grid.periodic}; }

inline Field halved(const Field& fine, int threads = 1) {
  Field coarse(fine.rows() / 2, fine.cols() / 2);
  parallel_ranges(coarse.rows(), threads, [&](Index begin, Index end, int) {
    for (Index i = begin; i < end; ++i)
      for (Index j = 0; j < coarse.cols(); ++j) {
        const auto four = fine.block<2, 2>(2 * i, 2 * j);
        coarse(i, j) = (four(0, 0) + four(0, 1) + four(1, 0) + four(1, 1)) / 4;
      }
  });
  return coarse;
}

/// max(|v(n) - v(n/2)|, s |v(n/2) - v(n/4)|) of a figure on n, n/2 and n/4 cells a side. The first difference
/// alone is near zero by accident in a few per cent of scenes (validation/contact_grid_error).
inline double grid_change(double fine, double half, double quarter, double s = 0.25) {
  return std::max(std::abs(fine - half), s * std::abs(half - quarter));
}

}  // namespace asperity
