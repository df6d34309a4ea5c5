/// Random fields like a measured one: of its shape, its missing points, its heights and its correlation.
///
/// A twin has the correlation ρ of the field (stats/uncertainty/random_fields.hpp). A known ρ is taken as it
/// is. An estimate r(p,q) has the form's share put back and its noise at long lags suppressed,
///     ρ = (r + b B)/(1 + b) · exp(-u²/2),   u = (p/hx)² + (q/hy)²,                                      (1)
/// b, B as in stats/uncertainty/effective_size.hpp. The noise that passes a wide window g raises S_2 = Σ v ρ²
/// by the factor 1 + Σ g²/N; a narrow one loses what it cuts off. The ratio of hx to hy is that of lags |p|
/// and |q| that hold three quarters of Σ ρ² over the significant lags, p_75 and q_75; their size is such that
/// both changes cancel,
///     S_2(h) = S_2(w)/(1 + Σ g_w²/N),   w = 2c p_75,   c = 4 (N_eff/218)^{1/4},                         (2)
/// by an estimate with the wide window w, whose loss is small. S_1 of an estimate stays low, by a tenth to a
/// half on exponential fields.
///
/// The noise of an estimate hides the shortest waves of a smooth surface, and with them its slopes and
/// curvatures. Short-wave twins have the correlation of the field times Hann's window, which leaks no long
/// waves into short ones, times exp(-u/2) with 1.5 p_75 and 1.5 q_75, or hx and hy of (2) if heights are not
/// Gaussian, less the part that Hann's takes: a smoothed spectrum, which is never negative.
///
/// If heights are not Gaussian, known or evident from Ssk and Sku, those of a twin are translated
/// (marginal/translation.hpp): by the known distribution, else by that of the measured heights.
///
/// Symbols   r, ρ  correlations      N_eff = N/S_2      p, q  lags [samples]
///
/// B. Efron, R. J. Tibshirani, An Introduction to the Bootstrap, Chapman & Hall 1993, 6.5.
#pragma once

#include <cstdint>
#include <optional>

#include "stats/measure/sample.hpp"
#include "stats/uncertainty/random_fields.hpp"

namespace asperity {

enum class TwinWaves { all, short_ones };

class TwinFields {
 public:
  /// Of a sample that is whole; for short waves, one without missing points. A known correlation has all.
  explicit TwinFields(const Sample& sample, TwinWaves waves = TwinWaves::all, std::uint64_t seed = 1);

  /// Twin k, the same in any order and on any thread; variance 1 before its mean or form is removed.
  Field heights(Index k) const;
  const LagField& correlation() const { return correlation_; }  ///< of the heights
  bool gaussian() const { return !translation_; }

 private:
  Field missing_;  ///< NaN where a point is missing, else 0; empty if none is
  LagField correlation_;
  std::optional<Translation> translation_;
  RandomFields fields_;
};

}  // namespace asperity
