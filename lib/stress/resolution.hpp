/// Cells s times as long and wide for the layers that are deep enough.
///
/// In a layer at depth z a mode fades as exp(-qz), so that beyond z = 5 s Δ, Δ the longer side of a cell,
/// nothing is left of the modes beyond π/sΔ. Such a layer is computed on points s cells apart: from the
/// influence of a wide cell, sΔx × sΔy, and from the pressure's lower modes, each times
///     ratio = s sin(a/s) / sin(a),   a = k/2,                                                            (1)
/// in x and in y, k in radians a wide cell, which turns wide cells into the narrow ones. From the points the
/// layer's values at all cells are interpolated (transform/interpolation.hpp).
///
/// A kernel that ends at the last lag of the grid has all modes. On the coarse torus it is therefore whole
/// for the lags that are needed and then falls to 0 smoothly, over the `taper` lags more that the torus has
/// room for, as the integral of exp(β√(1-u²)), |u| < 1.
///
/// Accuracy  2e-6 of the largest pressure; below a rough periodic one 1e-8.
/// Cost      32 layers of 128 × 128 cells down to 51 of them half, 64 of 512 × 512 a fifth of those in full.
#pragma once

#include <span>

#include "stress/load.hpp"
#include "transform/interpolation.hpp"
#include "transform/pruned.hpp"

namespace asperity {

/// Columns ky in a block of a spectrum.
inline constexpr Index block_columns = PrunedTransform::width;

struct Resolution {
  /// s = 1: the cells as they are. Of several ranks each has its share of the spectrum's blocks.
  Resolution(const LoadedBody& body, Index s, int threads);

  /// From which depth on, and whether at all, cells s times as large will do [m].
  static double least_depth(const Grid& grid, Index s);
  static bool possible(const Grid& grid, Index s);
  static constexpr Index least_cells = 16;  ///< wide ones, along each side of the grid

  /// Block b of the spectrum of the pressure, prepared for a product with the influence of `cells`.
  const Complex* pressure(Index b) const {
    return spectrum.data() + (b - transform.own_blocks().first) * transform.block_size();
  }
  /// Samples of a row, with room for their neighbours on the torus at both ends.
  Index row_length() const { return transform.torus().ny + 2 * PrunedTransform::width; }
  /// Fills that room; the samples begin at Interpolation::before.
  void wrap(std::span<double> row) const;

  Index s;
  PrunedTransform transform;
  Grid cells;  ///< of the influence: as many as there are lags not zero
  std::array<std::vector<double>, 2>
      taper;  ///< what the kernel is multiplied with at each lag, in x and in y
  Interpolation interpolation;
  AlignedVector<Complex> spectrum;  ///< of the pressure
};

}  // namespace asperity
