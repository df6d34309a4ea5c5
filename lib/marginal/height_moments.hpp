/// The four moments of heights.
#pragma once

namespace asperity {

/// Kurtosis is 3 of a Gaussian.
struct HeightMoments {
  double mean = 0, variance = 1, skewness = 0, kurtosis = 3;
};

}  // namespace asperity
