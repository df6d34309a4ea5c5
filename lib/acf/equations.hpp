/// The autocorrelation equations in two formulations, as systems for Newton's method.
///
/// A surface drawn as a moving average of unit white noise, z(i,j) = Σ kernel(k,l) η(i+k, j+l), has
/// the autocorrelation
///     R(p,q) = Σ_k Σ_l kernel(k,l) kernel(k+p, l+q).                                                    (1)
/// R is prescribed at the n·m lags 0 ≤ p < n, 0 ≤ q < m; n·m coefficients are unknown.
///
/// SymmetricEquations. The kernel is even in both indices, kernel(±k,±l) = α(k,l) with |k| < n, |l| < m, and
/// therefore R is even too: what holds at (p,q) holds at (p,-q). On a torus of at least 3n - 2 points, where
/// the lags below n do not wrap around, with P the restriction to the quadrant and ^ the (real) spectrum of
/// the even extension,
///     F(α) = P (α^)² - R,      J v = 2 P (α^ v^),      M v = ½ P (v^ / α^).                             (2)
/// With the weights w (1, 2 or 4: how often a coefficient occurs) J is symmetric, ⟨J u, v⟩_w = ⟨u, J v⟩_w;
/// while α^ > 0 it is positive definite and Newton's method needs 4–6 steps. Where α^ ≤ 0, J turns singular
/// on the way, and mostly the target cut at n × m lags is no autocorrelation at all: `guard` refuses such
/// iterates. The start is the zero-phase root √max(R^, 0) under Fejér's window (1-k/n)(1-l/m).
///
/// PatirEquations. The kernel is a(k,l), 0 ≤ k < n, 0 ≤ l < m [1]. On a torus of 2n points, with the complex
/// spectrum,
///     F(a) = P |a^|² - R,      J v = 2 P Re(a^* v^),      M v = P (a^ h^),  h = [v^/|a^|²]₊             (3)
/// where [·]₊ keeps lags ≥ 0 and half of lag (0,0): a Wilson step [2]. The start is a = R. The equations say
/// nothing of the lags (p,-q), which come out wrong by 0.07–0.27 σ²: no generator of isotropic surfaces.
///
/// Symbols   α, a  coefficients   R  target [σ²]   n, m  number of lags   J  Jacobian   M ≈ J⁻¹
/// Accuracy  round-off of the transforms, ε log2(Px Py).
/// Cost      two even (2) or real (3) transforms a residual, product or preconditioning; M of (3) four.
///
/// [1] N. Patir, A numerical procedure for random generation of rough surfaces, Wear 47 (1978) 263-277.
/// [2] G. Wilson, Factorization of the covariance generating function of a pure moving average process,
///     SIAM J. Numer. Anal. 6 (1969) 1-7.
#pragma once

#include <span>
#include <vector>

#include "acf/newton_krylov.hpp"
#include "grid/field.hpp"
#include "transform/plan.hpp"

namespace asperity {

/// Equations (2). Vectors are n × m, row-major.
class SymmetricEquations {
 public:
  /// `target` is R on the lags 0 ≤ p < n, 0 ≤ q < m; R(0,0) > 0.
  explicit SymmetricEquations(const Field& target);

  /// Refuse iterates whose spectrum is not positive.
  bool guard = true;

  std::vector<double> start();
  /// F(u); false when the guard refuses u.
  bool residual(std::span<const double> u, std::span<double> f);
  void linearize(std::span<const double> u);
  void jacobian(std::span<const double> v, std::span<double> out);
  void precondition(std::span<double> v);

  /// How often each coefficient occurs in the kernel: 1, 2 or 4.
  const std::vector<double>& multiplicity() const { return multiplicity_; }
  /// min R^ / max R^ of the target cut at the lags: negative when the cut is doubtful, ≥ 0 when it is
  /// certainly sound.
  double feasibility();
  NonlinearSystem system();
  /// All (2n-1) × (2m-1) coefficients.
  Field kernel(std::span<const double> u) const;

 private:
  void spectrum(std::span<const double> u);  ///< into quarter_
  void restrict_to(std::span<double> out, double scale);

  Field target_;
  EvenTransform2D transform_;
  AlignedVector<double> quarter_;         ///< work space
  std::vector<double> symbol_, inverse_;  ///< α^ and 1/α^ of the last linearisation
  std::vector<double> multiplicity_;
};

/// Equations (3). Vectors are n × m, row-major.
class PatirEquations {
 public:
  explicit PatirEquations(const Field& target);

  std::vector<double> start() const;
  void residual(std::span<const double> u, std::span<double> f);
  void linearize(std::span<const double> u);
  void jacobian(std::span<const double> v, std::span<double> out);
  void precondition(std::span<double> v);

  NonlinearSystem system();
  Field kernel(std::span<const double> u) const;

 private:
  void load(std::span<const double> u);       ///< into field_, zeros around it
  void load_even(std::span<const double> v);  ///< v at (p,q) and at (-p,-q)
  void forward();                             ///< field_ → spectrum_
  void backward();                            ///< spectrum_ → field_
  void keep_causal();                         ///< [·]₊ of field_
  void restrict_to(std::span<double> out, double scale) const;

  Field target_;
  RealTransform2D transform_;
  AlignedVector<double> field_;
  AlignedVector<Complex> spectrum_;
  std::vector<Complex> symbol_;  ///< a^ of the last linearisation
  std::vector<double> inverse_;  ///< 1/|a^|²
};

}  // namespace asperity
