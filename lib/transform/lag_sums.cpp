#include "transform/lag_sums.hpp"

#include <algorithm>
#include <utility>

#include "core/memory.hpp"
#include "core/parallel.hpp"

namespace asperity {
namespace {

// Padded by the longest lag: nothing wraps onto a requested lag.
Shape torus_for(const Grid& grid, Shape max_lag) {
  if (grid.periodic.both()) return grid.shape;
  return {fast_length(grid.shape.nx + max_lag.nx), fast_length(grid.shape.ny + max_lag.ny)};
}

// put() brings a field into the half spectrum.
template <class Put>
Field sums_of(const Put& put, const Grid& grid, Shape max_lag, int threads) {
  constexpr Index group = RowTransform::rows;
  const PrunedTransform transform(grid.shape, torus_for(grid, max_lag));
  HalfSpectrum half = transform.half_spectrum();
  put(transform, half);
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

}  // namespace

Field lag_sums(const Field& f, const Grid& grid, Shape max_lag, int threads) {
  return sums_of(
      [&](const PrunedTransform& transform, HalfSpectrum& half) { transform.forward_rows(f, half, threads); },
      grid, max_lag, threads);
}

Field lag_sums_of_rows(const RowSource& f, const Grid& grid, Shape max_lag, int threads) {
  return sums_of([&](const PrunedTransform& transform,
                     HalfSpectrum& half) { transform.forward_each_row(f, half, threads); },
                 grid, max_lag, threads);
}

}  // namespace asperity
