/// Standard errors of shares of a part of a field, such as its cells in contact, whatever its distribution.
///
/// The field is cut into B blocks. Block b holds n_b counted cells, and c_b of these have a property.
/// Blocks longer than the correlation are independent of each other, and the share f = Σ c_b / n of the n
/// counted cells has the variance of a ratio [1]
///     Var[f] = B/(B-1) Σ (c_b - f n_b)² / n².                                                 (1)
/// (1) knows no Gaussian and allows for a number of counted cells that changes from surface to surface. It is
/// too small for blocks as short as the correlation: the rectangle that holds the counted cells is cut into
/// 8 × 8 and into 4 × 4 blocks, and the larger error counts. With the share f(q) of the cells below q, the
/// quantile of share s has the error of Woodruff [2],
///     [q(s + e) - q(s - e)]/2,   e² = Var[f(q)].                                              (2)
///
/// Accuracy  the error itself is known to 12 %, and is some 7 % high where cells are independent. 95 %
///           intervals of 300 fields cover 96 % at correlations of 1/40 of the side, 93 % at 1/16, 90 % at
///           1/8.
/// Scope     correlation lengths below an eighth of the side; ten blocks or more with counted cells.
/// Cost      one pass for either division.
///
/// [1] W. G. Cochran, Sampling Techniques, 3rd ed., Wiley (1977), section 6.4, over clusters.
/// [2] R. S. Woodruff, Confidence intervals for medians and other position measures,
///     J. Am. Stat. Assoc. 47 (1952) 635-646.
#pragma once

#include <vector>

#include "core/field.hpp"

namespace asperity {

/// NaN where fewer than ten blocks hold counted cells.
struct ShareErrors {
  std::vector<double> within;  ///< of the share between two edges; the first is below the first edge
  std::vector<double> below;   ///< of the share below each edge
};

/// Of the values that are not NaN. Edges increase; a value at an edge lies above it.
ShareErrors share_errors(const Field& z, const std::vector<double>& edges);

}  // namespace asperity
