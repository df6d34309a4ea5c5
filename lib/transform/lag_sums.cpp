#include "transform/lag_sums.hpp"

#include "core/large_field.hpp"
#include "core/parallel.hpp"
#include "transform/pruned.hpp"

namespace asperity {
namespace {

// Room for the longest lag beside the field: nothing wraps onto a lag requested.
Shape torus_for(const Grid& grid, Shape max_lag) {
  if (grid.periodic.both()) return grid.shape;
  return {fast_length(grid.shape.nx + max_lag.nx), fast_length(grid.shape.ny + max_lag.ny)};
}

}  // namespace

Field lag_sums(const Field& f, const Grid& grid, Shape max_lag, int threads) {
  constexpr Index group = RowTransform::rows;
  const PrunedTransform transform(grid.shape, torus_for(grid, max_lag));
  HalfSpectrum half = transform.half_spectrum();
  transform.forward_rows(f, half, threads);
  transform.filter(half, threads, [&](Index, Complex* block) {
    for (Index k = 0; k < transform.block_size(); ++k) block[k] = std::norm(block[k]);
  });
  const Index period = transform.torus().ny, rows = max_lag.nx + 1;
  Field sums = large_field({rows, 2 * max_lag.ny + 1});
  parallel_ranges((rows + group - 1) / group, threads, [&](Index begin, Index end, int) {
    Field lags(group, period);
    RowTransform::Work work = transform.row_work();
    for (Index first = begin * group; first < std::min(end * group, rows); first += group) {
      const Index count = std::min(group, rows - first);
      transform.inverse_group(half, first, count, period, lags.data(), period, work);
      // Negative lags stand at the end of a row.
      sums.block(first, max_lag.ny, count, max_lag.ny + 1) = lags.topLeftCorner(count, max_lag.ny + 1);
      sums.block(first, 0, count, max_lag.ny) = lags.topRightCorner(count, max_lag.ny);
    }
  });
  sums /= static_cast<double>(transform.torus().cells());
  return sums;
}

}  // namespace asperity
