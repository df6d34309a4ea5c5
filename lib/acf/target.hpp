/// Target autocorrelations: what a surface is asked to look like.
///
/// A target is the autocorrelation R(λx, λy) = E[z(x,y) z(x+λx, y+λy)] divided by R(0,0) = σ², at lags
/// counted in samples. The solver only samples it, so that any callable will do: a model below, a table, a rotated
/// model.
///
/// The exponential model has the elliptic contours of a surface with a lay,
///     R(λx, λy) = σ² exp(ln(level) √((λx/λx*)² + (λy/λy*)²)),                                           (1)
/// and falls to `level` at the lengths λx*, λy*. Its decay lengths, where it is 1/e, are λ*/ln(1/level); its
/// ellipticity is γ = λx*/λy*.
///
/// Symbols   λx, λy    lags [samples]           λx*, λy*  lengths at `level` [samples]
///
/// D. J. Whitehouse, J. F. Archard, The properties of random surfaces of significance in their contact,
/// Proc. R. Soc. Lond. A 316 (1970) 97-121; N. Patir, Wear 47 (1978) 263-277 for (1) in two dimensions.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>

#include "grid/error.hpp"
#include "grid/field.hpp"

namespace asperity {

/// What a solver samples.
struct Target {
  /// R(p, q)/R(0,0) at p samples in x and q in y; even under point reflection, R(-p,-q) = R(p,q).
  std::function<double(double p, double q)> correlation;
  bool oriented = false;                   ///< R(p,-q) ≠ R(p,q) at some lags
  std::optional<Shape> known = {};         ///< of a table: nothing is known at |p| ≥ nx or |q| ≥ ny
  std::function<Shape(double)> reach = {};  ///< reach(t): the least n × m with |R| ≤ t where |p| ≥ n or |q| ≥ m

  Target() = default;
  template <class Correlation>
    requires(std::is_invocable_r_v<double, Correlation, double, double> &&
             !std::is_same_v<std::remove_cvref_t<Correlation>, Target>)
  Target(Correlation f) : correlation(std::move(f)) {}  // NOLINT: a callable is a target

  double operator()(double p, double q) const { return correlation(p, q); }
  explicit operator bool() const { return static_cast<bool>(correlation); }
};

/// The exponential autocorrelation (1).
struct ExponentialTarget {
  double length_x = 1;  ///< lag at which R has fallen to `level` in x [samples], > 0
  double length_y = 1;  ///< the same in y
  double level = 0.1;   ///< between 0 and 1; 1/e makes the lengths decay lengths

  void check() const {
    if (!(level > 0 && level < 1))
      throw ParameterError("level", std::to_string(level) + " does not lie between 0 and 1");
    for (double length : {length_x, length_y})
      if (!(length > 0 && std::isfinite(length)))
        throw ParameterError("length", std::to_string(length) + " samples: must be positive and finite");
  }
  double operator()(double p, double q) const {
    return std::exp(std::log(level) * std::hypot(p / length_x, q / length_y));
  }
  double decay_length_x() const { return length_x / -std::log(level); }
  double decay_length_y() const { return length_y / -std::log(level); }

  /// Lags that cover so many decay lengths each way. Six leave an error below 1e-3 over all lags, 11.5 below
  /// 1e-6.
  Shape lags(double decay_lengths = 6) const {
    auto cover = [&](double decay) {
      return std::max<Index>(1, static_cast<Index>(std::ceil(decay_lengths * decay)));
    };
    return {cover(decay_length_x()), cover(decay_length_y())};
  }
};

}  // namespace asperity
