/// Does the grid resolve a surface? What halving the cells adds to its slope tells, without a solution.
///
/// On means of 2 × 2 and of 4 × 4 points, with s² the mean square slope between neighbours,
///     γ = (s²(n) - s²(n/2)) / (s²(n/2) - s²(n/4)).                                               (1)
/// Where finer points show little that is new, s² converges and γ is small: γ → ¼ for smooth surfaces, and
/// 2^(2-2H) for a self-affine one without a short-wave cut-off. From γ = 1 on the slope grows without end:
/// the contact of such a surface depends on its grid for ever. Seen: shortest wave of 16 cells 0 to 0.3,
/// 8 cells 0.3 to 0.4, 4 cells 0.5 to 0.8, 3 cells 0.9 to 1.4, 2 cells 1.4 to 1.6; Gaussian ACF 0.3 to 0.5,
/// Matérn with ν = 2 0.6, exponential 3.9 to 4.7, self-affine with H = 0.8 2.1.
///
/// A form of degree 2 is removed first, but from a surface that is periodic along both axes; an odd last line
/// is left out.
///
/// Cost      a few passes; the form is two of its own.
#pragma once

#include <string_view>

#include "core/field.hpp"

namespace asperity {

/// Whether a contact on this grid is one of the surface.
enum class Resolved { yes, doubtful, no };

struct SlopeGrowth {
  double gamma = 0;  ///< (1); NaN below 16 points a side
  /// yes below 0.8 and where γ is not known, no from 1 on.
  Resolved resolved() const;
};

/// Of heights without missing points [m]. 0 where the slope does not change: a plane, a constant.
SlopeGrowth slope_growth(Field heights, const Grid& grid, int threads = 1);

}  // namespace asperity
