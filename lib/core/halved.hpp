/// Grids of half as many cells along each side; fields there are means of 2 × 2 cells. An odd last line is
/// left out.
#pragma once

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

}  // namespace asperity
