/// The correlation of a self-affine surface with a flat roll-off.
///
/// The isotropic power spectrum that contact mechanics of rough surfaces takes as its model [1, 2],
///     C(q) ∝ 1 for q < 1,   q^-2(1+H) for q > 1,                                                       (1)
/// lengths in units of the reciprocal roll-off wave number 1/q_r, has the correlation
///     ρ(r) = 2H/(1+H) [J₁(r)/r + ∫_1^∞ q^(-1-2H) J₀(qr) dq].                                          (2)
/// Small lags show the Hurst exponent, large ones the corner of (1) as a ripple around zero:
///     1 - ρ ≈ Γ(1-H) / ((1+H) Γ(1+H)) (r/2)^2H,   r ≪ 1, H < 1,                                       (3)
///     ρ ≈ 4H J₀(r)/r²,                             r ≫ 1.                                              (4)
///
/// Below r = 2 by the power series of (2), whose terms r^2H and r², of opposite poles at H = 1, are taken
/// together. Above 128 by parts,
///     ∫_r^∞ t^-μ J₀ dt = -r^-μ J₁ + (μ+1) r^(-μ-1) J₀ - (μ+1)² ∫_r^∞ t^(-μ-2) J₀ dt,                   (5)
/// with μ = 1 + 2H for t = qr. Between them from a table in r, filled from 128 downwards by Gauss-Legendre
/// quadrature of (5)'s integrand; I, the integral in (2), has the derivative I' = (2H I - J₀(r))/r.
///
/// Scope     0.01 ≤ H ≤ 1, any r; beyond r = 1e10, where |ρ| < 1e-24, zero.
/// Accuracy  1e-11.
/// Cost      60 ns a value below r = 2, 15 ns in the table, 500 ns above it; 5 ms for the table of 100 kB.
///
/// [1] B. N. J. Persson, O. Albohr, U. Tartaglino, A. I. Volokitin, E. Tosatti, On the nature of surface
///     roughness with application to contact mechanics, sealing, rubber friction and adhesion,
///     J. Phys.: Condens. Matter 17 (2005) R1-R62.
/// [2] T. D. B. Jacobs, T. Junge, L. Pastewka, Quantitative characterization of surface topography using
///     spectral analysis, Surf. Topogr.: Metrol. Prop. 5 (2017) 013001.
#pragma once

#include <array>

#include "acf/radial.hpp"

namespace asperity {

class SelfAffineCorrelation {
 public:
  explicit SelfAffineCorrelation(double hurst);
  double operator()(double r) const;

  /// An r from which on |ρ| ≤ t, 0 < t < 1: the least one, or above it by 0.02 at most;
  /// beyond 1e5 by a few ripples.
  double last_above(double t) const;

 private:
  static constexpr std::size_t terms = 12, parts = 8;

  double near(double r) const;
  double far(double r) const;
  double power_terms(double r) const;
  void prepare_series();
  void prepare_table();
  double envelope(double r) const;

  double H_;
  double pole_ = 0;                      // what stays of r^2H and r² where their poles have cancelled
  std::array<double, terms> even_{};     // of r², r⁴, … in [ ]
  std::array<double, parts> bessel0_{};  // of J₀/r², J₀/r⁴, …
  std::array<double, parts> bessel1_{};  // of J₁/r, J₁/r³, …
  QuinticTable table_;
};

}  // namespace asperity
