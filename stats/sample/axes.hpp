/// The spread of directions without sense, such as lays: axes of period π.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace asperity {

/// √(-½ ln ρ), ρ = |mean exp(2iθ)|: their standard deviation if it is small, and large without a preferred
/// axis. K. V. Mardia, P. E. Jupp, Directional statistics, Wiley (2000), section 2.3.
inline double axial_spread(const std::vector<double>& angles) {
  std::complex<double> sum = 0;
  for (const double angle : angles) sum += std::polar(1.0, 2 * angle);
  return 0.5 * std::sqrt(-2 * std::log(std::min(1.0, std::abs(sum) / static_cast<double>(angles.size()))));
}

}  // namespace asperity
