/// Coefficients scaled to a variance.
#pragma once

#include <cmath>
#include <span>
#include <vector>

namespace asperity {

/// Scales u to Σ w u² = variance.
inline void normalise(std::span<double> u, const std::vector<double>& w, double variance) {
  double sum = 0;
  for (std::size_t i = 0; i < u.size(); ++i) sum += w[i] * u[i] * u[i];
  for (double& x : u) x *= std::sqrt(variance / sum);
}

}  // namespace asperity
