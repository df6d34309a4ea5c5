/// Patches of contact: cells in contact that share sides, and whether they span the domain.
///
/// Two cells in contact belong to one patch where they share a side (4-connected: cells that meet at a corner
/// alone touch in a point). Along a periodic axis cells at opposite edges share a side too. A patch
/// percolates along an axis
///     free      if it has cells at both ends of the domain,                                  (1)
///     periodic  if it is connected with its own image one or more periods away.              (2)
/// For (2) each cell holds its offset, in periods, from the root of its patch. Two cells of one patch that
/// meet again with another offset have gone around the domain [1].
///
/// Patches are numbered from 1 by falling size; of equal ones, that whose first cell comes first in memory.
///
/// Cost      one pass of union-find by size with halving of paths, one to number them. 32 bytes a cell.
///
/// [1] J. Machta, Y. S. Choi, A. Lucke, T. Schweizer, L. V. Chayes, Invaded cluster algorithm for Potts
///     models, Phys. Rev. E 54 (1996) 1332-1345.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/field.hpp"

namespace asperity {

struct Patches {
  std::vector<std::int32_t> label;  ///< of each cell; 0: not in contact
  std::vector<Index> cells;         ///< of patch 1, 2, …; falls
  bool percolates_x = false, percolates_y = false;

  Index count() const { return static_cast<Index>(cells.size()); }
  Index largest() const { return cells.empty() ? 0 : cells.front(); }  ///< cells of the largest patch
};

/// The patches of the cells whose state is not 0, in the order of a Field.
Patches find_patches(const Grid& grid, std::span<const std::int8_t> state);

}  // namespace asperity
