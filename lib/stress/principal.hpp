/// Principal stresses and their directions: the eigenvalues and eigenvectors of the stress tensor.
///
/// With the mean stress m, the deviator s = σ - m and its size ρ, ρ² = s:s/6, the principal stresses are m + ρx for
/// the three roots of
///     x³ - 3x = 2h,   h = det(s/ρ)/2,   -1 ≤ h ≤ 1.                                                   (1)
/// For h ≥ 0 the largest, otherwise the smallest root stands alone, at least √3 from the others, and is well
/// conditioned even where those coincide. Hence the order of the work [1]:
///     the lone root |x| ∈ [√3, 2] of (1) by three steps of Newton's method;
///     its direction v, the longest column of the adjugate of s/ρ - x, which is v vᵀ times at least 6;
///     the other two from the 2 × 2 tensor that is left in the plane across v, by a rotation.
/// No digits are lost at double roots, as they are when (1) is solved for all three.
///
/// A direction is an axis and has no sign: it is given the one with which the first of its components in z, x, y that
/// exceeds 1e-8 is positive, so that it points into the body. Where principal stresses coincide, to rounding, their
/// directions are any that are normal to each other and to the third.
///
/// Accuracy  principal stresses to 8 ε, the residual σv - λv to 16 ε of the largest component; a direction to that
///           over the distance to the next principal stress; directions normal to each other to 8 ε.
/// Cost      some 60 ns a point of a row, less without the directions, all in vector arithmetic; an iterative solver
///           takes seven times as long, the closed form of all three roots, with its 1e-8, twice.
///
/// [1] D. Eberly, A robust eigensolver for 3 × 3 symmetric matrices, Geometric Tools 2014.
#pragma once

#include "core/field.hpp"
#include "stress/layers.hpp"

namespace asperity {

struct PrincipalStress {
  std::array<double, 3> value{};                     ///< σ1 ≥ σ2 ≥ σ3, positive in tension
  std::array<std::array<double, 3>, 3> direction{};  ///< unit vectors (x, y, z) of each
};

PrincipalStress principal_stress(const stress::Tensor& s);

/// The tensor at point j of a row of which all components are known.
inline stress::Tensor tensor_of(const StressRow& s, Index j) {
  return {s[0][j], s[1][j], s[2][j], s[3][j], s[4][j], s[5][j]};
}

/// Along a row of `count` points: out[k] is the k-th principal stress.
void principal_stress(const StressRow& s, Index count, double* const* out);
/// Likewise out[3k + i] component i of the direction of the k-th.
void principal_directions(const StressRow& s, Index count, double* const* out);

}  // namespace asperity
