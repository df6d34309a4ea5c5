/// How far an estimated autocorrelation may be from the true one, at all lags together.
///
/// The deviation of ρ, a field over the lags, is a sum Σ_k ξ_k m_k of K modes m_k with independent ξ_k of
/// variance 1. Then
///     Var[ρ(h)] = Σ_k m_k(h)²,      Cov[ρ(h), ρ(g)] = Σ_k m_k(h) m_k(g),                              (1)
/// and a figure F of the autocorrelation, as its texture aspect ratio, has the variance and the bias
///     Var[F] = Σ_k [(F(ρ + u m_k) - F(ρ - u m_k))/(2u)]²,                                             (2)
///     1/(2u²) Σ_k [F(ρ + u m_k) - 2F(ρ) + F(ρ - u m_k)],                                              (3)
/// however it depends on the lags, and though their errors are correlated; (3) also where F has a kink, as
/// the least of many lengths has (an unscented transform). The step u is the quantile that 95 % intervals
/// end at, 2.5 at most: a length changes by its mean slope up to there. With u = 1, where noise makes a
/// shoulder of ρ, a tail of huge errors raised their rms: for ratios at 10 % it was 1.0 to 2.0 of the true
/// error, and is 0.9 to 1.3 (150 fields of each of eleven textures, N_eff 290 to 1230). On four patches of
/// three lengths, where the quantile is 6, a length does not fall any more long before, and its slope up to
/// there would be a half of what it is.
///
/// Where ρ ± u m_k does not fall to the level of a length, that length is beyond the lags, and a ratio with
/// it zero or infinite: its interval is open on that side.
///
/// Two figures x that are zero on average, such as the anisotropy of an isotropic field, have the covariance
/// C of (2), and xᵀ C⁻¹ x = T² is exceeded by chance with the probability
///     (1 + T²/ν)^-ν/2,                                                                                (4)
/// that of T²/2 by F(2, ν), ν the degrees of freedom that the scale of (1) is known to.
///
/// The modes are long waves of the field (stats/uncertainty/lag_waves.hpp), turned among themselves so that
/// they are orthogonal over the lags: (2) then does not depend on where the period of a field is cut, which
/// turns sines into cosines.
///
/// Accuracy  of ratios (Str, gamma, those at 1/e and 10 %) stated over true error and coverage of the 95 %
///           intervals, the least and the most of eleven textures, where half of the fields or more have an
///           error (validation/error_coverage): 0.91 to 1.33, 88 to 97 % at N_eff 290 to 1230;
///           0.94 to 1.58, 86 to 100 % at 33 to 140; 0.98 to 1.79, 79 to 100 % at 8 to 35.
///
/// S. J. Julier, J. K. Uhlmann, Unscented filtering and nonlinear estimation, Proc. IEEE 92 (2004) 401-422.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/field.hpp"
#include "stats/spatial/pairs.hpp"
#include "stats/uncertainty/interval.hpp"

namespace asperity {

/// Figures of ρ, and of ρ ± u m_k, a row a mode.
class FigureDeviations {
 public:
  struct Law {
    double error = NAN, bias = NAN;     ///< NaN if ρ, or a mode on both sides, has no such figure
    bool falls = false, rises = false;  ///< no end below, above: a mode leads to 0, to infinity, or nowhere
  };
  double operator()(Index i) const { return here_(i); }
  /// Of the logarithm of a positive figure.
  Law relative(Index i) const;
  /// The error of an axis [rad], of period π; NaN also if it may be any.
  double of_axis(Index i) const;
  /// The chance that figures i and i + 1, if they are zero but for (1) and the variance `beside` of each, are
  /// as far from zero as they are. 1 where that is not known.
  double chance_of_pair(Index i, double beside) const;
  /// The quantile of Student's t that is exceeded with the probability `tail`.
  double quantile(double tail) const;

 private:
  friend class AcfDeviations;
  struct Sides {
    Eigen::ArrayXXd above = {}, below = {};
  };
  // (2), of differences by `apart`; of one side where the figure is missing on the other side.
  template <class Difference>
  Eigen::ArrayXd differences(Index i, const Difference& apart) const;

  double degrees_ = 1, step_ = 1;
  Eigen::ArrayXd here_ = {};
  Sides near_ = {}, end_ = {};  // at u, and where 95 % intervals end
};

class AcfDeviations {
 public:
  /// Modes over the same lags, and the degrees of freedom of Student's t that (1) is known to.
  AcfDeviations(std::vector<LagField> modes, double degrees);

  /// With one more mode.
  AcfDeviations with(LagField mode) const {
    AcfDeviations out = *this;
    out.modes_.push_back(std::move(mode));
    return out;
  }
  /// With every mode times factor(p, q).
  AcfDeviations scaled(const std::function<double(Index, Index)>& factor) const;

  Shape max_lag() const { return modes_.front().max_lag(); }
  /// The quantile of Student's t that is exceeded with the probability `tail`.
  double quantile(double tail) const;
  /// √(1) at all lags.
  LagField errors() const;

  /// Figures of ρ: NaN where this ρ has no such figure, infinite for a length beyond the lags, and 0 or
  /// infinite for a ratio with one.
  using Figures = std::function<Eigen::ArrayXd(const LagField& rho)>;
  FigureDeviations of(const LagField& rho, const Figures& figures, int threads = 1) const;
  /// The errors of the logarithms of several positive figures; not finite where one is zero or infinite.
  Eigen::ArrayXd relative_errors(const LagField& rho, const Figures& figures, int threads = 1) const;

 private:
  std::vector<Field> principal_modes() const;
  using Sides = FigureDeviations::Sides;
  static Sides displaced(const LagField& rho, const std::vector<Field>& modes, double step,
                         const Figures& figures, int threads);

  std::vector<LagField> modes_;
  double degrees_;
};

}  // namespace asperity
