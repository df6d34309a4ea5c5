/// Tables of the distribution of a field that only a part of the cells has (tools/cli/counted_cells.hpp).
#pragma once

#include "tools/cli/counted_cells.hpp"
#include "tools/cli/table.hpp"

namespace asperity::cli {

/// So many bins from 0 to `largest`. Columns: the variable, count, standard_error, share of all cells,
/// density and density_error.
Table histogram_of(const CountedCells& part, int bins, double largest);
/// Columns: share, the variable, standard_error.
Table quantiles_of(const CountedCells& part, int rows, int threads);

}  // namespace asperity::cli
