/// The autocorrelation equations in three formulations, as systems for iterative methods.
///
/// A surface drawn as a moving average of unit white noise, z(i,j) = Σ kernel(k,l) η(i+k, j+l), has
/// the autocorrelation
///     R(p,q) = Σ_k Σ_l kernel(k,l) kernel(k+p, l+q).                                                    (1)
/// R is prescribed at |p| < n, |q| < m, and there are as many unknown coefficients as equations.
///
/// ZeroPhaseEquations. The kernel is even under point reflection, |k| < n, |l| < m, and so is R: a half plane
/// of unknowns and of lags (`oriented`); or both are even in either index: a quarter (`symmetric`). Its
/// spectrum α^ is real. On a torus of at least 3n - 2 points, where the lags below n do not wrap around, with
/// P the restriction to the part,
///     F(α) = P (α^)² - R,      J v = 2 P (α^ v^),      M v = ½ P (v^ / α^).                             (2)
/// With the weights w (how often a coefficient occurs) J is self-adjoint, ⟨J u, v⟩_w = ⟨u, J v⟩_w; while α^ >
/// 0 it is positive definite and Newton's method needs 4–6 steps. Where α^ ≤ 0, J turns singular on the way,
/// and mostly the cut target has no kernel at all: residual() says so, and Newton's iteration refuses such
/// iterates. The start is the root √max(R^, 0) under Fejér's window (1-k/n)(1-l/m).
///
/// PatirEquations. The kernel is a(k,l), 0 ≤ k < n, 0 ≤ l < m [1]. On a torus of 2n points, with the complex
/// spectrum,
///     F(a) = P |a^|² - R,      J v = 2 P Re(a^* v^),                                                    (3)
///     M v = P (a^ h^),  h = [v^/|a^|²]₊
/// where [·]₊ keeps lags ≥ 0 and half of lag (0,0): a Wilson step [2]. The start is a = R. The equations say
/// nothing of the lags (p,-q), which come out wrong by 0.07–0.27 σ²: no generator of isotropic surfaces.
///
/// Symbols   α, a  coefficients   R  target [σ²]   n, m  number of lags   J  Jacobian   M ≈ J⁻¹
/// Accuracy  round-off of the transforms, ε log2(Px Py).
/// Cost      a transform there and back a residual, product or preconditioning (transform/zero_phase.hpp), M
///           of (3) two.
///
/// [1] N. Patir, A numerical procedure for random generation of rough surfaces, Wear 47 (1978) 263-277.
/// [2] G. Wilson, Factorization of the covariance generating function of a pure moving average process,
///     SIAM J. Numer. Anal. 6 (1969) 1-7.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "acf/target.hpp"
#include "core/field.hpp"
#include "transform/zero_phase.hpp"

namespace asperity {

/// max |v|, infinity where a value is not finite.
inline double largest_absolute(std::span<const double> v) {
  double largest = 0;
  for (double x : v)
    largest = std::max(largest, std::isfinite(x) ? std::abs(x) : std::numeric_limits<double>::infinity());
  return largest;
}

/// Scales u to Σ w u² = variance.
inline void normalise(std::span<double> u, const std::vector<double>& w, double variance) {
  double sum = 0;
  for (std::size_t i = 0; i < u.size(); ++i) sum += w[i] * u[i] * u[i];
  for (double& x : u) x *= std::sqrt(variance / sum);
}

/// What the iterations ask of a formulation. Vectors hold one number an equation, or an unknown. J and M
/// belong to the iterate of the last linearize().
class Equations {
 public:
  virtual ~Equations() = default;
  Index count() const { return static_cast<Index>(target_.size()); }
  /// R at the lags of the equations.
  const std::vector<double>& target() const { return target_; }
  /// w: how often each coefficient occurs in the kernel, and each lag in the plane of lags.
  const std::vector<double>& multiplicity() const { return multiplicity_; }

  virtual std::vector<double> start() = 0;
  /// f = F(u); false where u lies outside of the domain in which J is regular.
  virtual bool residual(std::span<const double> u, std::span<double> f) = 0;
  virtual void linearize(std::span<const double> u) = 0;
  /// out = J v
  virtual void jacobian(std::span<const double> v, std::span<double> out) = 0;
  /// v = M v
  virtual void precondition(std::span<double> v) = 0;
  /// All coefficients as (1) applies them.
  virtual Field kernel(std::span<const double> u) const = 0;

  /// d = √w: with it the norm of an unknown, or of an equation, is that over the whole plane.
  std::vector<double> scale() const {
    std::vector<double> d;
    for (double w : multiplicity_) d.push_back(std::sqrt(w));
    return d;
  }

 protected:
  std::vector<double> target_, multiplicity_;
};

/// What can be said of a target from its spectrum, cut at the lags, before any iteration.
struct Feasibility {
  double least = 0;  ///< min/max of the spectrum: ≥ 0 is certainly the autocorrelation of some surface
  double negative_share = 0;  ///< Σ|S⁻| / Σ|S|: a hundredth is doubtful, a tenth is hopeless
  double windowed = 0;        ///< min/max under Fejér's window: < 0 beyond round-off, and no surface has it
};

/// Equations (2).
class ZeroPhaseEquations : public Equations {
 public:
  ZeroPhaseEquations(const Target& target, Shape lags, bool oriented);
  /// The least torus on which R does not wrap around into the lags prescribed.
  static Shape least_torus(Shape lags);

  std::vector<double> start() override;
  /// False where the spectrum is not positive.
  bool residual(std::span<const double> u, std::span<double> f) override;
  void linearize(std::span<const double> u) override;
  void jacobian(std::span<const double> v, std::span<double> out) override;
  void precondition(std::span<double> v) override;
  Field kernel(std::span<const double> u) const override { return transform_->whole(u); }

  Feasibility feasibility();

 private:
  std::unique_ptr<ZeroPhaseTransform> transform_;
  std::vector<double> window_;                ///< Fejér's
  AlignedVector<double> transfer_, inverse_;  ///< α^ and 1/α^ of the last linearisation, over Px Py
};

/// Equations (3). Vectors are n × m, row-major.
class PatirEquations : public Equations {
 public:
  PatirEquations(const Target& target, Shape lags);

  std::vector<double> start() override;
  bool residual(std::span<const double> u, std::span<double> f) override;
  void linearize(std::span<const double> u) override;
  void jacobian(std::span<const double> v, std::span<double> out) override;
  void precondition(std::span<double> v) override;
  Field kernel(std::span<const double> u) const override;

 private:
  Eigen::Map<Field> plane();             ///< field_
  void load(std::span<const double> u);  ///< into field_, zeros around it
  void forward();                        ///< field_ → spectrum_
  void backward();                       ///< spectrum_ → field_
  void keep_causal();                    ///< [·]₊ of field_
  void restrict_to(std::span<double> out, double scale);

  Shape lags_;
  RealTransform2D transform_;
  AlignedVector<double> field_;
  AlignedVector<Complex> spectrum_;
  std::vector<Complex> transfer_;  ///< a^ of the last linearisation
  std::vector<double> inverse_;    ///< 1/|a^|²
};

}  // namespace asperity
