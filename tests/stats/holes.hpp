/// Fields with missing points, and sums over what is there, one by one.
#pragma once

#include "fields.hpp"

namespace asperity::test {

inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A hole of a fifth of the field that reaches its edge, and a share of single points; the first point is
/// missing too.
inline Field with_holes(Field z, double share, unsigned seed) {
  z.block(z.rows() / 3, 0, z.rows() / 3, z.cols() / 2).setConstant(none);
  const Field chance = random_field(shape_of(z), seed);
  z = (chance < 2 * share - 1).select(none, z);
  z(0, 0) = none;
  return z;
}

/// The largest difference, where neither is missing; NaN if one is missing where the other is not.
inline double largest_difference(const Field& a, const Field& b) {
  if ((a.isNaN() != b.isNaN()).any()) return none;
  return (a.isNaN() || a == b).select(0, a - b).abs().maxCoeff();
}

/// visit(z, z') over the pairs of points at lag (p,q) that are there.
template <class Visit>
void for_each_pair(const Field& z, bool periodic, Index p, Index q, Visit visit) {
  const Index nx = z.rows(), ny = z.cols();
  for (Index i = 0; i < nx; ++i)
    for (Index j = 0; j < ny; ++j) {
      const Index a = i + p, b = j + q;
      if (!periodic && (a < 0 || a >= nx || b < 0 || b >= ny)) continue;
      const double first = z(i, j), second = z((a + nx) % nx, (b + ny) % ny);
      if (!std::isnan(first) && !std::isnan(second)) visit(first, second);
    }
}

inline double mean_over_pairs(const Field& z, bool periodic, Index p, Index q, double (*f)(double, double)) {
  double sum = 0, pairs = 0;
  for_each_pair(z, periodic, p, q, [&](double a, double b) { sum += f(a, b), ++pairs; });
  return sum / pairs;
}

}  // namespace asperity::test
