/// How far an estimated autocorrelation may be from the true one, at all lags together.
///
/// The deviation of ρ, a field over the lags, is a sum Σ_k ξ_k m_k of modes m_k with independent ξ_k of
/// variance 1. Then
///     Var[ρ(h)] = Σ_k m_k(h)²,      Cov[ρ(h), ρ(g)] = Σ_k m_k(h) m_k(g),                              (1)
/// and a figure of the autocorrelation, as its texture aspect ratio, has the error and the bias of its values
/// for drawn ρ + Σ_k ξ_k m_k: however it depends on the lags, and though their errors are correlated.
///
/// The modes are long waves of the field (stats/uncertainty/lag_waves.hpp).
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/field.hpp"
#include "stats/spatial/lag_field.hpp"
#include "stats/uncertainty/interval.hpp"

namespace asperity {

class AcfDeviations {
 public:
  /// Modes over the same lags, and the degrees of freedom of Student's t that (1) is known to.
  AcfDeviations(std::vector<LagField> modes, double degrees);

  /// With every mode times factor(p, q).
  AcfDeviations scaled(const std::function<double(Index, Index)>& factor) const;

  Shape max_lag() const { return modes_.front().max_lag(); }
  /// The quantile of Student's t that is exceeded with the probability `tail`.
  double quantile(double tail) const;
  /// √(1) at all lags.
  LagField errors() const;
  /// The correlation of the deviations of lags.
  Eigen::MatrixXd correlation(const std::vector<Shape>& lags) const;

  /// A figure of ρ; none if this ρ has no such figure.
  using Figure = std::function<std::optional<double>(const LagField& rho)>;
  struct Law {
    double error, bias;  ///< NaN if a fifth of the drawn ρ has no such figure
  };
  /// Of a positive figure, relative to it.
  Law relative(const LagField& rho, const Figure& figure, int threads = 1) const;
  /// The error of an axis [rad], of period π; NaN also if no direction is preferred.
  double of_axis(const LagField& rho, const Figure& figure, int threads = 1) const;

 private:
  std::vector<std::optional<double>> drawn(const LagField& rho, const Figure& figure, int threads) const;

  std::vector<LagField> modes_;
  double degrees_;
};

}  // namespace asperity
