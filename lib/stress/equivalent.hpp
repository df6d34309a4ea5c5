/// What yield and fatigue are judged by: equivalent stresses, principal stresses and their directions.
///
/// A ductile material flows where the von Mises stress [1] reaches the yield stress, or Tresca's largest
/// shear stress [2] half of it; fatigue criteria are written in the octahedral shear stress [3], on the
/// planes equally inclined to the principal stresses:
///     σ_vM² = ½ [(σxx-σyy)² + (σyy-σzz)² + (σzz-σxx)²] + 3 (σxy² + σxz² + σyz²),                        (1)
///     τ_max = (σ1 - σ3) / 2,   τ_oct = ⅓ √[(σ1-σ2)² + (σ2-σ3)² + (σ3-σ1)²] = (√2/3) σ_vM.               (2)
///
/// Principal stresses are the eigenvalues of the tensor. With its mean m, the deviator s = σ - m and its size
/// ρ, ρ² = s:s/6, they are m + ρx for the three roots of
///     x³ - 3x = 2h,   h = det(s/ρ)/2,   -1 ≤ h ≤ 1.                                                   (3)
/// For h ≥ 0 the largest, otherwise the smallest root stands alone, at least √3 from the others, and is well
/// conditioned even where those coincide. Hence the order of the work [4]:
///     the lone root |x| ∈ [√3, 2] of (3) by three steps of Newton's method;
///     its direction v, the longest column of the adjugate of s/ρ - x, which is v vᵀ times at least 6;
///     the other two from the 2 × 2 tensor that is left in the plane across v, by a rotation.
/// No digits are lost at double roots, as they are when (3) is solved for all three.
///
/// A direction is an axis: it is given the sign with which the first of its components in z, x, y that
/// exceeds 1e-8 is positive, into the body. Where principal stresses coincide their directions are any that
/// are normal to each other and to the third.
///
/// Accuracy  principal stresses to 8 ε, the residual σv - λv to 16 ε of the largest component; a direction to
///           that over the distance to the next principal stress; directions normal to each other to 8 ε.
/// Cost      some 60 ns a point of a row, in vector arithmetic; an iterative solver takes seven times as
///           long, the closed form of all three roots, with its 1e-8, twice.
///
/// [1] R. von Mises, Nachr. Ges. Wiss. Göttingen, Math.-Phys. Kl. (1913) 582-592.
/// [2] H. Tresca, C. R. Acad. Sci. Paris 59 (1864) 754-758.
/// [3] A. Nadai, Theory of Flow and Fracture of Solids, McGraw-Hill 1950.
/// [4] D. Eberly, A robust eigensolver for 3 × 3 symmetric matrices, Geometric Tools 2014.
#pragma once

#include <cmath>
#include <numbers>
#include <span>

#include "core/field.hpp"
#include "stress/component.hpp"

namespace asperity {

struct PrincipalStress {
  std::array<double, 3> value{};                     ///< σ1 ≥ σ2 ≥ σ3, positive in tension
  std::array<std::array<double, 3>, 3> direction{};  ///< unit vectors (x, y, z) of each
};

PrincipalStress principal_stress(const stress::Tensor& s);

inline double von_mises(double sxx, double syy, double szz, double sxy, double sxz, double syz) {
  const double a = sxx - syy, b = syy - szz, c = szz - sxx;
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * (sxy * sxy + sxz * sxz + syz * syz));
}

inline double von_mises(const stress::Tensor& s) { return von_mises(s[0], s[1], s[2], s[3], s[4], s[5]); }

inline double max_shear_stress(const stress::Tensor& s) {
  const PrincipalStress p = principal_stress(s);
  return 0.5 * (p.value[0] - p.value[2]);
}

inline constexpr double octahedral_over_von_mises = std::numbers::sqrt2 / 3;

/// Along a row of which all components are known, to as many values.
void von_mises(const StressRow& s, std::span<double> out);
void max_shear_stress(const StressRow& s, std::span<double> out);
void octahedral_shear(const StressRow& s, std::span<double> out);
void largest_principal_stress(const StressRow& s, std::span<double> out);

/// A row of each output.
using RowOutputs = std::span<const std::span<double>>;

/// Likewise out[k], the k-th principal stress.
void principal_stress(const StressRow& s, RowOutputs out);
/// Likewise out[3k + i], component i of the direction of the k-th.
void principal_directions(const StressRow& s, RowOutputs out);

/// The von Mises stress (1) of a layer from one component after the other, to the same last bit: the sum of
/// the squared differences waits for three components, two of which are kept; that of the squared shears
/// takes the place of the second. Memory: two fields, where six components at once take six.
class MisesLayer {
 public:
  explicit MisesLayer(Shape layer);

  /// Row i of a component, all rows of which come in the order xx, yy, zz, xy, xz, yz.
  void add(stress::Component c, Index i, std::span<const double> values);
  /// When all have come, times a factor.
  void row(Index i, double factor, std::span<double> out) const;

 private:
  Field a_, b_;
};

}  // namespace asperity
