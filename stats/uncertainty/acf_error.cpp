#include "stats/uncertainty/acf_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace asperity {

AcfError::AcfError(const LagField& correlation, const Pairs& pairs)
    : algebra_(correlation, pairs), pairs_(pairs) {
  const Shape most = algebra_.rho().max_lag();
  for (Index p = -most.nx; p <= most.nx; ++p)
    for (Index q = -most.ny; q <= most.ny; ++q)
      if (const double rho = algebra_.rho()(p, q); rho != 0) support_.push_back({{p, q}, rho});
}

double AcfError::pairs(Index p, Index q) const { return pairs_.pair_fraction(p, q) * pairs_.points(); }

double AcfError::weight(Index p, Index q, Index k, Index l) const {
  const double there = pairs_.density(k, l);
  if (pairs_.grid().periodic.both()) return there;
  auto overlapping = [](Index n, Index distance) {
    return std::max(0.0, 1 - static_cast<double>(std::abs(distance)) / static_cast<double>(n));
  };
  const auto [nx, ny] = pairs_.grid().shape;
  return there * overlapping(nx - std::abs(p), k) * overlapping(ny - std::abs(q), l);
}

// The second product of (1) is summed over m = k + h, where ρ(m) ≠ 0.
double AcfError::normalised(Index p, Index q) const {
  if (p == 0 && q == 0) return 0;
  const double at_lag = algebra_.rho()(p, q);
  double sum = 0;
  for (const auto& [lag, rho] : support_) {
    const auto [k, l] = lag;
    const double shifted = algebra_.rho()(k - 2 * p, l - 2 * q), beside = algebra_.rho()(k + p, l + q);
    sum += weight(p, q, k, l) * rho * ((1 + 2 * at_lag * at_lag) * rho - 4 * at_lag * beside) +
           weight(p, q, k - p, l - q) * rho * shifted;
  }
  return std::sqrt(std::max(sum, 0.0) / pairs(p, q));
}

Eigen::MatrixXd AcfError::correlation(const std::vector<Shape>& lags) const {
  Shape farthest{0, 0};
  std::vector<CorrelatedLag> values;
  for (const auto& [p, q] : lags) {
    farthest = {std::max(farthest.nx, std::abs(p)), std::max(farthest.ny, std::abs(q))};
    values.push_back({{p, q}, algebra_.rho()(p, q)});
  }
  return bartlett_correlation(algebra_.convolution({2 * farthest.nx, 2 * farthest.ny}, false), values);
}

}  // namespace asperity
