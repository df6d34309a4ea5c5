/// Quantiles and probabilities of the distributions used for intervals, for any argument.
///
/// GSL's functions end the process if an argument is NaN or outside their range; these functions return NaN.
/// Degrees of freedom: from 10⁻⁶ for χ² and 0.01 for Student's t, which is the normal distribution from 10⁹
/// on.
#pragma once

namespace asperity {

/// The value that Student's t exceeds with the probability `tail`, 0 < tail < 1. Below one degree of freedom
/// it is NaN for far tails, where it overflows.
double student_quantile(double tail, double degrees);

/// P(T ≤ t), and P(T > t).
struct StudentTails {
  double below, above;
};
StudentTails student_tails(double t, double degrees);

/// The value that χ²/ν exceeds with the probability `tail`, 0 ≤ tail ≤ 1. From 10⁴ degrees on by Wilson and
/// Hilferty's cube root, with an error of 0.05 ν^{-3/2}; GSL's iteration fails silently from about 10⁵ on.
double chi_squared_share(double tail, double degrees);

}  // namespace asperity
