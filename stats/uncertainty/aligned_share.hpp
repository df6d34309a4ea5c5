/// What the alignment of scan lines (stats/filter/row_alignment.hpp) has taken of the surface itself.
///
/// A line of n points, of a surface of variance σ² and correlation ρ along it, has a mean
///     Var[mean] = σ² ρ̄,     ρ̄ = 1/n Σ_{|p|<n} (1 - |p|/n) ρ(p) ≈ 1/L ∫ρ dx,                           (1)
/// though no offset: so much is gone with the offsets, and of a polynomial of degree k on average
/// σ² (k+1)/n Σ v B ρ, near (k+1) σ² ρ̄ (v, B: stats/uncertainty/form_modes.hpp). ρ is estimated from the
/// aligned lines, above a form of degree 2 and about their own means: it is lower there by what the lines
/// lost, b B of the variance that is left, so that
///     b = M/n Σ v B ρ_a / (1 - M/n Σ v B²),     M = k + 1,                                            (2)
/// over the lags up to the first at which ρ_a is not above zero, at most half a line. What (1) or (3)
/// of row_alignment.hpp took besides the means is what the means of the aligned lines are now,
///     taken² = b σ_a² + mean of their squares about their mean,                                       (3)
/// but no more than went altogether, as of lines that an instrument has aligned before; and all of that
/// where lines of fewer than ten points, or of one height, tell no correlation. Of several alignments, each
/// takes its share s of what the former have left: 1 - Π (1 - s²) of Sq².
///
/// Symbols   σ_a  rms height of the aligned lines above that form, about their means [m]
///           L    length of a line [m]
/// Scope     Waves along whole lines (a grating along them, a lay) are lost, and not seen. Of terraces and
///           islands median and median_difference may take less than (3), which then is a bound: their lines
///           keep means of their own.
/// Accuracy  Six maps of 256 × 256 points, white, exp(-r²/ℓ²) with ℓ = 5 and 20 points, with offsets, tilt
///           and bow, the mean of each line: √ρ̄ is 0.063, 0.186, 0.372 of Sq, 0.062, 0.179, 0.283 are taken
///           and 0.063, 0.184, 0.354 estimated. Within a fifth for each method, and a self-affine surface:
///           192 points, a correlation length of 6 and 10 (tests/stats/row_alignment.cpp). Waves longer than
///           a line remain unseen.
/// Cost      a form, and a correlation along the lines.
///
/// J. S. Bendat, A. G. Piersol, Random data, 4th ed., Wiley (2010), ch. 8: (1).
#pragma once

#include "stats/filter/row_alignment.hpp"

namespace asperity {

struct TakenByAlignment {
  double rms = 0;    ///< (3) [m]
  bool all = false;  ///< as much as went altogether, less than (3)
  double share = 0;  ///< of the rms height that the surface had without offsets, √(σ_a² + taken²)
};

/// Of a map that is aligned `how`; `jumps`: (5) of row_alignment.hpp.
TakenByAlignment taken_by_alignment(const AlignedRows& aligned, const Grid& grid, const RowAlignment& how,
                                    int threads = 1);

}  // namespace asperity
