#include "stats/sample/quantiles.hpp"

#include <cmath>

#include <gsl/gsl_cdf.h>

namespace asperity {
namespace {

constexpr double least_of_student = 0.01, as_good_as_normal = 1e9, least_of_chi_squared = 1e-6;

}  // namespace

double student_quantile(double tail, double degrees) {
  if (!(tail > 0 && tail < 1 && degrees >= least_of_student)) return NAN;
  return degrees < as_good_as_normal ? gsl_cdf_tdist_Qinv(tail, degrees) : gsl_cdf_ugaussian_Qinv(tail);
}

StudentTails student_tails(double t, double degrees) {
  if (!(degrees >= least_of_student) || std::isnan(t)) return {NAN, NAN};
  if (degrees >= as_good_as_normal || std::isinf(t)) return {gsl_cdf_ugaussian_P(t), gsl_cdf_ugaussian_Q(t)};
  return {gsl_cdf_tdist_P(t, degrees), gsl_cdf_tdist_Q(t, degrees)};
}

double chi_squared_share(double tail, double degrees) {
  if (!(tail >= 0 && tail <= 1 && degrees >= least_of_chi_squared)) return NAN;
  if (degrees < 1e4) return gsl_cdf_chisq_Qinv(tail, degrees) / degrees;
  const double variance = 2 / (9 * degrees);
  return std::pow(1 - variance + gsl_cdf_ugaussian_Qinv(tail) * std::sqrt(variance), 3);
}

}  // namespace asperity
