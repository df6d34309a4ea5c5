#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "marginal/johnson.hpp"
#include "marginal/johnson_moments.hpp"
#include "math/bracketed_root.hpp"

namespace asperity {

namespace {

using Family = Johnson::Family;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double least_delta = 1.0 / 64;
constexpr double same = 1e-12;       // distances from the normal and from S_L that are none
constexpr double tolerance = 1e-14;  // of a moment, relative to its size or to 1

double size(double moment) { return std::max(1.0, std::abs(moment)); }

// The outer unknown x, in which K runs linearly from the normal, x = 1/(2δ²), to the edge, x = 1-δ.
double inverse_delta_squared(double x) { return x * (2 - x) / ((1 - x) * (1 - x)); }
double outer_unknown(double v) { return v / (std::sqrt(1 + v) * (1 + std::sqrt(1 + v))); }

// 1/δ² of S_L: w + 1 = 2 cosh(θ/3) solves (1) with Sk = 2 sinh(θ/2).
double lognormal_v(double skewness) {
  const double root = std::sinh(std::asinh(skewness / 2) / 3);
  return std::log1p(4 * root * root);
}

// 1/δ² of the symmetric S_U, where K = (w⁴ + 2w² + 3)/2.
double symmetric_v(double kurtosis) {
  const double excess = kurtosis - 3;
  return std::log1p(2 * excess / (2 + std::sqrt(4 + 2 * excess))) / 2;
}

// Unit slope, no offset, positive skewness. A difference, because -γ of a symmetric one would print as -0.
Johnson plain(Family family, double gamma, double delta) {
  return {family, family == Family::unbounded ? 0 - gamma : gamma, delta, 1, 1, 0};
}

HeightMoments moments_of(const Johnson& j) {
  if (j.family == Family::bounded) return johnson_moments(j);
  if (j.family == Family::unbounded) return unbounded_moments(j.gamma, j.delta);
  return lognormal_moments(1 / (j.delta * j.delta));
}

// γ for which a distribution of this δ has the skewness; infinite where even S_L, the most skewed, has none
// larger.
double gamma_for(Family family, double delta, double skewness) {
  if (skewness == 0) return 0;
  if (lognormal_moments(1 / (delta * delta)).skewness <= skewness) return infinity;
  auto excess = [&](double gamma) { return moments_of(plain(family, gamma, delta)).skewness - skewness; };
  CurvePoint low{0, -skewness}, high{std::max(1.0, delta), 0};
  while ((high.f = excess(high.x)) < 0) {
    if (high.x > 80 * std::max(1.0, delta)) return infinity;
    low = high;
    high.x *= 2;
  }
  return bracketed_root(excess, low, high, tolerance * size(skewness));
}

Johnson with_skewness(Family family, double v, double skewness) {
  const double delta = 1 / std::sqrt(v), gamma = gamma_for(family, delta, skewness);
  return std::isinf(gamma) ? plain(Family::lognormal, 0, delta) : plain(family, gamma, delta);
}

double kurtosis_at(Family family, double v, double skewness) {
  return moments_of(with_skewness(family, v, skewness)).kurtosis;
}

// Between S_L and where the other end of the family has passed the kurtosis.
Johnson fitted(Family family, double skewness, double kurtosis) {
  auto excess = [&](double x) { return kurtosis_at(family, inverse_delta_squared(x), skewness) - kurtosis; };
  const double v = lognormal_v(skewness);
  const CurvePoint line{outer_unknown(v), lognormal_moments(v).kurtosis - kurtosis};
  const double last =
      outer_unknown(family == Family::bounded ? 1 / (least_delta * least_delta) : symmetric_v(kurtosis));
  const double x = bracketed_root(excess, line, {last, excess(last)}, tolerance * kurtosis);
  return with_skewness(family, inverse_delta_squared(x), skewness);
}

Johnson of_positive_skewness(double skewness, double kurtosis) {
  if (skewness <= same && std::abs(kurtosis - 3) <= same * kurtosis) return {};
  const double v = lognormal_v(skewness), line = lognormal_moments(v).kurtosis;
  if (std::abs(kurtosis - line) <= same * kurtosis) return plain(Family::lognormal, 0, 1 / std::sqrt(v));
  return fitted(kurtosis > line ? Family::unbounded : Family::bounded, skewness, kurtosis);
}

// Mean 0 and variance 1 by slope and offset.
Johnson standardised(Johnson j) {
  if (j.family == Family::normal) return j;
  const HeightMoments m = moments_of(j);
  j.slope = 1 / std::sqrt(m.variance);
  j.offset = m.mean * j.slope;
  return j;
}

Johnson mirrored(Johnson j) {
  j.sign = -1;
  j.gamma = 0 - j.gamma;
  return j;
}

std::string text(double value) {
  char number[32];
  std::snprintf(number, sizeof number, "%.7g", value);
  return number;
}

void check_skewness(double skewness) {
  if (!(std::abs(skewness) <= largest_skewness))
    throw ParameterError("skewness", text(skewness) + ": must lie in " + text(-largest_skewness) + " ... " +
                                         text(largest_skewness));
}

void check_kurtosis(double skewness, double kurtosis) {
  const double least = least_kurtosis(skewness);
  if (kurtosis >= least && kurtosis <= largest_kurtosis) return;
  std::string message = text(kurtosis) + ": must lie in " + text(least) + " ... " + text(largest_kurtosis) +
                        " at skewness " + text(skewness);
  if (kurtosis < least)
    message += " (no heights have less than skewness^2 + 1 = " + text(skewness * skewness + 1) +
               ", where they are two-valued)";
  throw ParameterError("kurtosis", message);
}

}  // namespace

double least_kurtosis(double skewness) {
  check_skewness(skewness);
  return kurtosis_at(Family::bounded, 1 / (least_delta * least_delta), std::abs(skewness));
}

Johnson johnson_with(double skewness, double kurtosis) {
  check_kurtosis(skewness, kurtosis);
  const Johnson j = standardised(of_positive_skewness(std::abs(skewness), kurtosis));
  return skewness < 0 ? mirrored(j) : j;
}

}  // namespace asperity
