#include "stats/uncertainty/moment_interval.hpp"

#include <algorithm>
#include <cmath>

#include <gsl/gsl_cdf.h>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/sample/quantiles.hpp"

namespace asperity {
namespace {

// The variance of ln S_1 of an estimated correlation is 0.13 at most, down to 41 independent heights.
constexpr double least_degrees = 15;

// (2), (3) of an estimate, of which `left` is left by the field's own mean.
Interval of_scale(double estimate, double left, double degrees, double tail) {
  const double value = estimate / left;
  if (std::isinf(degrees)) return Interval::of(estimate, estimate, value);
  return Interval::of(estimate, std::min(estimate, value / std::sqrt(chi_squared_share(tail, degrees))),
                      value / std::sqrt(chi_squared_share(1 - tail, degrees)));
}

// (4), (5): of an estimate that is low by as much as `lost`.
Interval about_unbiased(double estimate, double lost, double half_width) {
  return Interval::of(estimate, estimate + lost - half_width, estimate + lost + half_width);
}

double outside(double level) {
  if (!(level > 0 && level < 1))
    throw ParameterError("confidence", "'" + shortest(level) + "' is not a number between 0 and 1");
  return (1 - level) / 2;
}

// (6), by the second orders of correlated and of independent heights.
double left_of(double second_order, double independent) {
  return std::max((1 - independent) / std::max(1 - second_order, 0.5), 0.75);
}

// (8).
double second_order_of_sku(double s1, double s2, double s3, double s4) {
  const double loop = std::pow(s2, 1.2) * std::pow(s4, 0.8);
  return 20 * s2 + 4 * s1 - (3 * s2 * s2 + 4 * s1 * s3 + 32 * loop) / s4;
}

// (4), (7); NaN, if the formula has no positive value.
double skewness_error(const EffectiveSampleSize& size) {
  const double n = size.effective(3);
  if (std::isinf(n)) return 0;
  const double s1 = size.mean_power(1), s2 = size.mean_power(2), s3 = size.mean_power(3);
  const double loop = std::pow(s2, 1.45) * std::pow(s3, 0.55);
  const double second_order = 12 * s2 + 3 * s1 - (3 * s1 * s2 + 18 * loop) / s3;
  return std::sqrt(6 * (n - 2) / ((n + 1) * (n + 3)) * left_of(second_order, -6 / n));
}

// (5).
double kurtosis_error(const EffectiveSampleSize& size) {
  const double n = size.effective(4);
  if (std::isinf(n)) return 0;
  if (!(n > 3)) return NAN;
  const double independent = 24 * n * (n - 2) * (n - 3) / ((n + 1) * (n + 1) * (n + 3) * (n + 5));
  return std::sqrt(independent * left_of(second_order_of_sku(size.mean_power(1), size.mean_power(2),
                                                             size.mean_power(3), size.mean_power(4)),
                                         -15 / n));
}

// (1) to (3), of any errors.
MomentIntervals intervals_of_scale(const Moments& moments, const MomentErrors& error,
                                   const EffectiveSampleSize& size, double tail) {
  const double patches = size.effective(2);
  const double left = std::sqrt(1 - size.taken_by_form());
  const double t =
      patches > 2 ? student_quantile(tail, std::min(patches - 1, std::max(size.degrees(), least_degrees)))
                  : NAN;
  const double of_taken = std::isinf(size.degrees()) ? 0 : 0.15 * size.taken_by_form();
  auto degrees = [of_taken](double value, double error_of_it) {
    return 0.5 / (std::pow(error_of_it / value, 2) + of_taken * of_taken);
  };
  return {.mean = Interval::about(moments.mean, error.mean > 0 ? t * error.mean / left : 0),
          .sa = of_scale(moments.sa, left, degrees(moments.sa, error.sa), tail),
          .sq = of_scale(moments.sq, left, degrees(moments.sq, error.sq), tail),
          .ssk = {},
          .sku = {}};
}

}  // namespace

MomentIntervals confidence_intervals(const Moments& moments, const EffectiveSampleSize& size, double level) {
  const double tail = outside(level), u = gsl_cdf_ugaussian_Qinv(tail);
  MomentIntervals out = intervals_of_scale(moments, standard_errors(moments, size), size, tail);
  out.ssk = Interval::about(moments.ssk, u * skewness_error(size));
  out.sku = about_unbiased(moments.sku, 6 / size.effective(2), u * kurtosis_error(size));
  return out;
}

MomentIntervals confidence_intervals(const Moments& moments, const TranslationErrors& errors,
                                     const EffectiveSampleSize& size, double level) {
  const double tail = outside(level), u = gsl_cdf_ugaussian_Qinv(tail);
  const MomentErrors error = errors.standard_errors(moments.sq);
  MomentIntervals out = intervals_of_scale(moments, error, size, tail);
  out.ssk = about_unbiased(moments.ssk, -errors.ssk_bias(), u * error.ssk);
  out.sku = about_unbiased(moments.sku, -errors.sku_bias(), u * error.sku);
  return out;
}

}  // namespace asperity
