#include "stats/moment_interval.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gsl/gsl_cdf.h>

#include "grid/error.hpp"

namespace asperity {
namespace {

// The quantile of χ²/ν that is exceeded with the probability of a tail. From 10⁴ degrees on by Wilson and Hilferty's cube
// root, which errs by 0.05 ν^{-3/2}; GSL's iteration goes astray, without an error, at some 10⁵.
double chi_squared_share(double tail, double degrees) {
  if (degrees < 1e4) return gsl_cdf_chisq_Qinv(tail, degrees) / degrees;
  const double variance = 2 / (9 * degrees);
  return std::pow(1 - variance + gsl_cdf_ugaussian_Qinv(tail) * std::sqrt(variance), 3);
}

// (2), (3).
Interval of_scale(double value, double degrees, double tail) {
  if (std::isinf(degrees)) return {value, value};
  return {value / std::sqrt(chi_squared_share(tail, degrees)),
          value / std::sqrt(chi_squared_share(1 - tail, degrees))};
}

Interval about(double value, double half_width) { return {value - half_width, value + half_width}; }

double tail_of(double level) {
  if (!(level > 0 && level < 1))
    throw ParameterError("confidence", "value " + std::to_string(level) + " is not between 0 and 1");
  return (1 - level) / 2;
}

// n of independent heights; NaN, if the formula has no positive value.
double skewness_error(double n) { return std::isinf(n) ? 0 : std::sqrt(6 * (n - 2) / ((n + 1) * (n + 3))); }
double kurtosis_error(double n) {
  if (std::isinf(n)) return 0;
  return n > 3 ? std::sqrt(24 * n * (n - 2) * (n - 3) / ((n + 1) * (n + 1) * (n + 3) * (n + 5))) : NAN;
}

// (1) to (3), of any errors.
MomentIntervals intervals_of_scale(const Moments& moments, const MomentErrors& error,
                                   const EffectiveSize& size, double tail) {
  const double patches = size.effective(2);
  const double left = std::sqrt(1 - std::min(size.sum(1) / size.points(), 0.9));
  const double t = patches > 2 ? gsl_cdf_tdist_Qinv(tail, std::min(patches - 1, size.degrees())) : NAN;
  auto degrees = [](double value, double error_of_it) { return 0.5 * std::pow(value / error_of_it, 2); };
  return {.mean = about(moments.mean, error.mean > 0 ? t * error.mean / left : 0),
          .sa = of_scale(moments.sa / left, degrees(moments.sa, error.sa), tail),
          .sq = of_scale(moments.sq / left, degrees(moments.sq, error.sq), tail),
          .ssk = {},
          .sku = {}};
}

}  // namespace

MomentIntervals confidence_intervals(const Moments& moments, const EffectiveSize& size, double level) {
  const double tail = tail_of(level), u = gsl_cdf_ugaussian_Qinv(tail);
  MomentIntervals out = intervals_of_scale(moments, standard_errors(moments, size), size, tail);
  out.ssk = about(moments.ssk, u * skewness_error(size.effective(3)));
  out.sku = about(moments.sku + 6 / size.effective(2), u * kurtosis_error(size.effective(4)));
  return out;
}

MomentIntervals confidence_intervals(const Moments& moments, const TranslationErrors& errors,
                                     const EffectiveSize& size, double level) {
  const double tail = tail_of(level), u = gsl_cdf_ugaussian_Qinv(tail);
  const MomentErrors error = errors.standard_errors(moments.sq);
  MomentIntervals out = intervals_of_scale(moments, error, size, tail);
  out.ssk = about(moments.ssk - errors.ssk_bias(), u * error.ssk);
  out.sku = about(moments.sku - errors.sku_bias(), u * error.sku);
  return out;
}

}  // namespace asperity
