/// The form of a surface and its removal: the F-operation of ISO 25178-2.
///
/// Heights are measured from the polynomial of total degree d in x and y that fits them best in least
/// squares,
///     z(i,j) ≈ Σ_{a+b≤d} c_ab P_a(i) P_b(j),   c_ab = Σ_ij P_a(i) P_b(j) z(i,j),                      (1)
/// with P_0, P_1, … orthonormal over the indices (Gram's polynomials). On a full grid their products are
/// orthonormal too, and (1) is an exact projection. Degree 0 is the mean, 1 the mean plane, 2 removes a
/// spherical cap. Along an axis of n points the degree is at most n-1. If heights are missing, the sums run
/// over the measured points,
///     Σ_{a'b'} G_{ab,a'b'} c_a'b' = Σ P_a P_b z,                                                      (2)
///     G_{ab,a'b'} = Σ P_a(i) P_b(j) P_a'(i) P_b'(j) over the measured points,                         (3)
/// the unit matrix less the sum over the missing points. Missing points stay missing.
///
/// Accuracy  z(0,0) is subtracted first, an exact operation where heights vary by less than a factor of two:
///           roughness of 1 nm on an offset of 1 m keeps all its digits. (1) is applied once more to the
///           remaining heights: within ε √(nx ny) of the form's rms. (2) is solved three times; points for
///           which a pivot of (3) is below 1e-10 of the largest are refused.
/// Cost      degree 0: two passes over the data; else two of 4 (d+1) products a point; with missing heights
///           three, (d+1)² more a point and (d+1)⁴/4 a row.
///
/// J. P. Gram, J. reine angew. Math. 94 (1883) 41-73.
#pragma once

#include <Eigen/Core>

#include "core/field.hpp"
#include "stats/filter/axis_products.hpp"
#include "stats/filter/missing.hpp"

namespace asperity {

inline constexpr int largest_form_degree = 20;

/// P_0, P_1, … up to the degree, or n - 1, over n points: a column each.
Eigen::MatrixXd gram_polynomials(Index n, int degree);
/// The products P_a P_b with a + b ≤ degree.
AxisProducts polynomials(Shape field, int degree);

/// A mean as the sum of a height of the field and a small difference, which has more digits than one double.
struct Mean {
  double base = 0, above = 0;

  double value() const { return base + above; }
};
/// Throws DataError("heights", …) when every point is missing.
Mean mean_above_base(const Field& z);
inline double mean(const Field& z) { return mean_above_base(z).value(); }

/// The heights above (1), or (2), in their place. Throws ParameterError("remove-form") unless 0 ≤ degree ≤ 20
/// and if the measured points do not determine the form, DataError as mean_above_base.
Field remove_form(Field heights, int degree = 0);

}  // namespace asperity
