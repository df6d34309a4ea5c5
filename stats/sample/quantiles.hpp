/// Quantiles and probabilities of the distributions that intervals rest on, for any argument.
///
/// GSL's own functions end the process where an argument is no number or beyond what they can do; here such a
/// value is NaN. Degrees of freedom: from 10⁻⁶ for χ² and 0.01 for Student's t, the normal distribution from
/// 10⁹ on.
#pragma once

namespace asperity {

/// What Student's t of so many degrees of freedom exceeds with the probability `tail`, 0 < tail < 1. Below
/// one degree far tails reach beyond all numbers, and are NaN too.
double student_quantile(double tail, double degrees);

/// P(T ≤ t), and P(T > t).
struct StudentTails {
  double below, above;
};
StudentTails student_tails(double t, double degrees);

/// What χ²/ν exceeds with the probability `tail`, 0 ≤ tail ≤ 1. From 10⁴ degrees on by Wilson and Hilferty's
/// cube root, which errs by 0.05 ν^{-3/2}; GSL's iteration goes astray, without an error, at some 10⁵.
double chi_squared_share(double tail, double degrees);

}  // namespace asperity
