/// Height parameters of a surface, by ISO 25178-2.
///
/// With heights d measured from the mean of all N points that are not missing,
///     Sa  = 1/N Σ |d|                    arithmetic mean height
///     Sq  = √(1/N Σ d²)                  root mean square height
///     Ssk = 1/N Σ d³ / Sq³               skewness
///     Sku = 1/N Σ d⁴ / Sq⁴               kurtosis, 3 for a Gaussian surface
///     Sp, Sv, Sz = Sp + Sv               highest peak, deepest valley, both ≥ 0, maximum height
/// population moments (divisor N) over the whole field. Ra and Rq of ISO 21920-2 are the same means over a
/// profile; Rp, Rv and Rz are means over sampling lengths.
///
/// Accuracy  Two passes about a shifted origin (stats/filter/form.hpp), by sums of row sums: a relative error
///           below ε (nx + ny) in Sa and Sq, independent of the offset.
/// Cost      two passes over the data. GSL's recurrences need a division per point and moment; a test
///           compares the results.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "core/field.hpp"

namespace asperity {

/// In the unit of the field; ssk and sku are pure numbers.
struct Moments {
  double mean = 0;
  double sa = 0, sq = 0;
  double ssk = 0, sku = 0;
  double sp = 0, sv = 0;

  double sz() const { return sp + sv; }
};

/// Throws DataError(variable, …) if all heights are the same, or if Sq is below 1e-77 or heights are above
/// 1e77, whose fourth powers a double cannot hold.
Moments moments(const Field& z, std::string_view variable = "heights");

// ---- heights at first sight ----

/// Heights at first sight: how high and how steep they are for their size, and how much of them is a tilt.
///
/// Of the measured points, with z above their mean and r what their mean plane leaves of it,
///     Sq² = mean z²,   s² = mean (Δz/Δx)² + mean (Δz/Δy)² between neighbours,   R² = 1 - mean r²/Sq².
/// Surfaces are low compared with their width: where Sq is above a tenth of the longer side, or s above 1,
/// heights or lengths seldom have the unit that they are taken to have.
///
/// Accuracy  R²: ε z_0²/Sq², z_0 being the first height above the mean.
/// Cost      one pass, some 3 ns a point.

/// Of a field whose rows come in order; NaN is missing.
class Proportions {
 public:
  explicit Proportions(const Grid& grid) : grid_(grid) {}
  Proportions(const Field& heights, const Grid& grid) : grid_(grid) { add(heights); }
  void add(const Eigen::Ref<const Field>& rows);

  double sq() const;
  double rms_slope() const;    ///< along an axis of one point 0
  double plane_share() const;  ///< R²; 0 where all is level
  /// Of the axes along which there are points.
  double longer_side() const {
    const auto [nx, ny] = grid_.shape;
    return nx == 1 ? grid_.size_y() : ny == 1 ? grid_.size_x() : std::max(grid_.size_x(), grid_.size_y());
  }

  /// Not of heights whose squares are beyond a double.
  bool implausible() const { return (too_high() || rms_slope() > 1) && std::isfinite(rms_slope()); }
  bool too_high() const { return sq() > 0.1 * longer_side(); }
  /// A plane makes up nine tenths and more of 16 heights and more.
  bool tilted() const { return count_ >= 16 && plane_share() > 0.9; }

 private:
  struct Steps {
    double squares = 0, count = 0;
    void add(double step);
    double slope(double spacing) const;  ///< mean square
  };
  double covariance(double product, double one, double other) const;

  Grid grid_;
  Index row_ = 0;
  double base_ = std::numeric_limits<double>::quiet_NaN();  ///< the first height
  std::vector<double> before_ = {};                         ///< the last row
  // Sums over the points, of 1, places from the middle and heights above base_, and of their products.
  double count_ = 0, x_ = 0, y_ = 0, z_ = 0, xx_ = 0, xy_ = 0, yy_ = 0, xz_ = 0, yz_ = 0, zz_ = 0;
  Steps along_x_ = {}, along_y_ = {};
};

}  // namespace asperity
