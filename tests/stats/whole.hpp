/// Slopes, spectral moments and summits of a field at hand, as a single strip.
#pragma once

#include "stats/filter/form.hpp"
#include "stats/hybrid/slopes.hpp"
#include "stats/hybrid/spectral_moments.hpp"
#include "stats/hybrid/summits.hpp"

namespace asperity::test {

inline SlopeParameters slope_parameters(const Field& z, const Grid& grid, int threads = 1) {
  SlopeSums sums;
  sums.add(Strip::whole(z, grid), threads);
  return sums.parameters(grid);
}

inline SpectralMoments spectral_moments(const Field& z, const Grid& grid, int threads = 1) {
  SpectralMomentSums sums;
  sums.add(Strip::whole(z, grid), mean(z), threads);
  return sums.moments(grid);
}

inline CountedSummits counted_summits(const Field& z, const Grid& grid, int threads = 1) {
  SummitSums sums;
  sums.add(Strip::whole(z, grid), mean(z), threads);
  return sums.summits(grid);
}

}  // namespace asperity::test
