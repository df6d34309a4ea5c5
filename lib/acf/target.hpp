/// Target autocorrelations: what a surface is asked to look like.
///
/// A target is the autocorrelation R(λx, λy) = E[z(x,y) z(x+λx, y+λy)] divided by R(0,0) = σ², at lags
/// counted in samples. The solver only samples it, so that any callable will do.
///
/// Every model of `EllipticTarget` is a radial correlation ρ(r), ρ(0) = 1, on the ellipses of a surface with
/// a lay,
///     R(p,q)/σ² = ρ(r* √((x'/λx*)² + (y'/λy*)²)),   ρ(r*) = level, r* the least,                       (1)
///     x' = x cos θ + y sin θ,   y' = y cos θ - x sin θ,   x = p Δx,   y = q Δy:
///     exponential           exp(-r)
///     gaussian              exp(-r²)
///     stretched exponential exp(-r^β), 0 < β ≤ 2
///     Matérn                acf/radial.hpp, 0.01 ≤ ν ≤ 100
///     self-affine           acf/radial.hpp, 0.01 ≤ H ≤ 1
///     exponential-cosine    (1) with exp(-r), times cos(2πx'/wavelength): a machined lay across x'.
/// All are positive definite in the plane, the last as a product of two that are. With s the length of a wave
/// number in reciprocals of the lengths over r*, their spectra are proportional to
///     exponential  (1 + s²)^-3/2       Matérn       (1 + s²)^-(1+ν)
///     gaussian     exp(-s²/4)          self-affine  1 for s ≤ 1, s^-2(1+H) beyond                       (2)
/// and that of the exponential-cosine is half the exponential's at q ± 2π/wavelength along x'. The stretched
/// exponential has none in closed form.
///
/// A new model is a word and a value of Model, and a case in each `switch` of target.cpp: the compiler
/// refuses one that is forgotten.
///
/// Symbols   λx, λy    lags                     λx*, λy*  lengths at `level`
///           Δx, Δy    spacing                  θ         angle from x towards y [rad]
/// Accuracy  1e-11 of ρ in the tabulated models, round-off in the others.
/// Cost      3 to 5 ns a lag of the exponential and the Gaussian, 15 to 60 ns of the others; the self-affine
///           beyond r = 128, where |ρ| < 2e-5, 500 ns.
///
/// D. J. Whitehouse, J. F. Archard, The properties of random surfaces of significance in their contact, Proc.
/// R. Soc. Lond. A 316 (1970) 97-121; N. Patir, Wear 47 (1978) 263-277 for the exponential in two dimensions.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>

#include "core/enum_words.hpp"
#include "core/field.hpp"

namespace asperity {

/// What a solver samples, row by row.
struct Target {
  /// R(p, q)/R(0,0) at p samples in x and q = first_q, first_q + 1, … in y; even under point reflection,
  /// R(-p,-q) = R(p,q). A value does not depend on the row that it is sampled with.
  using Row = std::function<void(double p, double first_q, std::span<double> out)>;
  Row row;
  bool oriented = false;                    ///< R(p,-q) ≠ R(p,q) at some lags
  std::optional<Shape> known = {};          ///< of a table: nothing is known at |p| ≥ nx or |q| ≥ ny
  std::shared_ptr<const Field> table = {};  ///< its half plane, R/R(0,0)
  std::function<Shape(double)> reach = {};  ///< the least n × m with |R| ≤ t where |p| ≥ n or |q| ≥ m

  Target() = default;
  template <class Correlation>
  requires(std::is_invocable_r_v<double, Correlation, double, double> &&
           !std::is_same_v<std::remove_cvref_t<Correlation>, Target>) Target(Correlation f)
      : row([f = std::move(f)](double p, double q, std::span<double> out) {  // NOLINT: a callable is a target
          for (double& r : out) r = f(p, q++);
        }) {}

  double operator()(double p, double q) const {
    double r = 0;
    row(p, q, {&r, 1});
    return r;
  }
  explicit operator bool() const { return static_cast<bool>(row); }
};

enum class Model { exponential, gaussian, matern, stretched_exponential, self_affine, exponential_cosine };
constexpr EnumWords<6> enum_words(Model) {
  return {"exponential", "gaussian", "matern", "stretched-exponential", "self-affine", "exponential-cosine"};
}

/// The models (1). Lengths, spacing and wavelength share one unit, whichever.
struct EllipticTarget {
  Model model = Model::exponential;
  double length_x = 1;  ///< lag at which ρ, or its envelope, has fallen to `level` along x', 1e-100 … 1e100
  double length_y = 1;    ///< the same along y'
  double level = 0.1;     ///< between 0 and 1
  double angle = 0;       ///< of x' from x towards y [rad]
  double spacing_x = 1;   ///< of the samples, 1e-100 … 1e100
  double spacing_y = 1;   ///< the same in y
  double smoothness = 1;  ///< ν of matern, 0.01 … 100
  double exponent = 1;    ///< β of stretched_exponential, 0 < β ≤ 2
  double hurst = 0.8;     ///< H of self_affine, 0.01 … 1
  double wavelength = 1;  ///< of exponential_cosine along x', 1e-100 … 1e100

  /// Throws ParameterError of the member's name; "length" and "spacing" stand for both.
  void check() const;
  /// r* of (1), as target() checks it: a length over it is the unit in which the model's ρ(r) is written,
  /// 1/q_r of a self-affine surface.
  double level_radius() const;
  /// (2) at s², of the exponential-cosine that of its envelope; NaN where there is no closed form.
  double spectrum(double squared) const;
  bool has_spectrum() const;
  /// Checks, and throws ParameterError("length-level") too when ρ passes the level nearer to 0 than r =
  /// 1e-300.
  ///
  /// reach(t) is the box around the ellipse on which ρ, or its envelope, is t for the last time, in lags to
  /// 1e-12 of them and 2^30 at most. An angle within 1e-12 of a multiple of 90° is taken as that, and
  /// then R(p,-q) = R(p,q) to the last bit; equal lengths of a radial model need no angle.
  Target target() const;
};

/// What one model has for itself. Tools have options of these names, datasets attributes with kernel_ before
/// them.
struct ShapeParameter {
  const char* name;
  Model model;  ///< that has it
  double EllipticTarget::*value;
  bool is_length = false;
};
inline constexpr ShapeParameter shape_parameters[] = {
    {"smoothness", Model::matern, &EllipticTarget::smoothness},
    {"exponent", Model::stretched_exponential, &EllipticTarget::exponent},
    {"hurst", Model::self_affine, &EllipticTarget::hurst},
    {"wavelength", Model::exponential_cosine, &EllipticTarget::wavelength, true}};

}  // namespace asperity
