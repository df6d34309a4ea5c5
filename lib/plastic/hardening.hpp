/// The yield stress of a metal as it flows, and how much it flows under a stress beyond it.
///
/// Von Mises' condition with isotropic hardening: the von Mises stress never exceeds
///     perfect   σ_f = σ_Y        linear   σ_f = σ_Y + H ε̄        Swift [1]   σ_f = B (C + ε̄)ⁿ,      (1)
/// ε̄ being the equivalent plastic strain so far. Prandtl and Reuss' rule, that the strain grows along the
/// deviator, gives by radial return [2] from a trial stress q > σ_f(ε̄), elastic of shear modulus μ, the
/// increment
///     q - 3μ γ = σ_f(ε̄ + γ),                                                                          (2)
/// in closed form, of Swift's law by Newton's method from above, where (2) is convex.
///
/// Symbols   σ_f flow stress [Pa]   σ_Y yield stress [Pa]   H hardening modulus [Pa]   B strength [Pa] C
///           offset   n exponent, 0 to 1   ε̄ equivalent plastic strain   γ its increment   μ shear modulus
///           [Pa]
/// Scope     small strains, no Bauschinger effect: under repeated loads shakedown, but no ratcheting.
/// Accuracy  round-off.
///
/// [1] H. W. Swift, Plastic instability under plane stress, J. Mech. Phys. Solids 1 (1952) 1-18.
/// [2] M. L. Wilkins, Calculation of elastic-plastic flow, Methods Comput. Phys. 3 (1964) 211-263.
#pragma once

#include <limits>

namespace asperity {

struct Hardening {
  double yield =
      std::numeric_limits<double>::infinity();    ///< σ_Y [Pa]; infinite: elastic; of Swift's law B Cⁿ
  double modulus = 0;                             ///< H [Pa]
  double strength = 0, offset = 0, exponent = 0;  ///< B [Pa], C, n of Swift's law; B = 0: it is linear

  /// Of B, C and n.
  static Hardening swift(double strength, double offset, double exponent);
  /// Throws ParameterError("yield") unless σ_Y > 0, ("hardening") unless H ≥ 0, B > 0, C > 0, 0 < n ≤ 1.
  void check() const;
  bool flows() const { return yield < std::numeric_limits<double>::infinity(); }
  bool operator==(const Hardening&) const = default;

  /// σ_f of (1) [Pa].
  double flow_stress(double strain) const;
  /// γ of (2), 0 where the trial stress [Pa] does not exceed σ_f.
  double flow(double trial, double strain, double shear_modulus) const;
};

}  // namespace asperity
