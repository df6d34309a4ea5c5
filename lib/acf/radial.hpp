/// Radial correlations that are tabulated: Matérn's, and that of a self-affine surface with a flat roll-off.
/// Both are interpolated from a function and its first two derivatives at equal steps.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace asperity {

/// A function on equal steps h as the quintic that takes its value and its first two derivatives at both ends
/// of each step. The error is h⁶ max|f⁽⁶⁾|/46080. Outside the nodes the first and the last quintic go on.
class QuinticTable {
 public:
  using Node = std::array<double, 3>;  ///< f, f', f''

  QuinticTable() = default;
  QuinticTable(double first, double step, const std::vector<Node>& nodes);

  double operator()(double x) const {
    const double u = (x - first_) / step_;
    const double last = static_cast<double>(pieces_.size() - 1);
    const double piece = u < 0 ? 0 : u < last ? static_cast<double>(static_cast<std::size_t>(u)) : last;
    const double t = u - piece;
    const Coefficients& c = pieces_[static_cast<std::size_t>(piece)];
    return c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5]))));
  }

 private:
  using Coefficients = std::array<double, 6>;
  double first_ = 0, step_ = 1;
  std::vector<Coefficients> pieces_;
};

/// The least r at which ρ, falling from ρ(0) = 1, is t; 0 when that is below 1e-300. Needs ρ to fall without
/// a turn until it has passed t, and to stay below t for a tenth of that radius.
double falls_to(const std::function<double(double)>& correlation, double t);

/// The Matérn correlation.
///
///     ρ(r) = 2^(1-ν)/Γ(ν) r^ν K_ν(r),    with the power spectrum ∝ (1 + q²)^-(1+ν) in the plane.       (1)
///
/// ν = ½ is the exponential, ν → ∞ the Gaussian of length 2√ν. The profiles are ⌈ν⌉-1 times differentiable,
/// and a surface with ν < 1 is a fractal of Hurst exponent ν at small lags,
///     1 - ρ ≈ Γ(1-ν)/Γ(1+ν) (r/2)^2ν,    r ≪ 1,                                                       (2)
/// so that (1) is the self-affine model with a smooth roll-off, ABC or K-correlation in optics [2].
///
/// ln ρ is tabulated in ln r, where its derivatives are ratios of Bessel functions: with u = d ln ρ/d ln r,
///     u = -r K_(ν-1)/K_ν,    du/d ln r = 2νu + r² - u².                                                (3)
///
/// Scope     0.01 ≤ ν ≤ 100. Below r = 1e-8 the power law of small lags, beyond r = 1000 (ρ < 1e-300) zero.
/// Accuracy  2e-11 relative to ρ, 1e-12 of ρ(0).
/// Cost      50 ns a value, 0.6 ms for the table of 40 kB.
///
/// [1] M. L. Stein, Interpolation of spatial data, Springer (1999), §2.7.
/// [2] J. M. Elson, J. M. Bennett, Calculation of the power spectral density from surface profile data,
///     Appl. Opt. 34 (1995) 201-208; E. L. Church, P. Z. Takacs, The optimal estimation of finish
///     parameters, Proc. SPIE 1530 (1991) 71-85.
class MaternCorrelation {
 public:
  explicit MaternCorrelation(double smoothness);
  double operator()(double r) const;

 private:
  double exponent_, coefficient_;  // ρ = 1 - coefficient r^exponent below the table
  QuinticTable logarithm_;         // of ρ, in ln r
};

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
