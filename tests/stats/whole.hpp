/// What sums over the strips of a field make of it as a single strip.
#pragma once

#include "stats/filter/form.hpp"
#include "stats/hybrid/slopes.hpp"
#include "stats/hybrid/spectral_moments.hpp"
#include "stats/hybrid/summits.hpp"
#include "stats/profile/profile.hpp"

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

inline ProfileAverages average_profiles(const Field& z, const Pairs& pairs, Axis1D along, double section,
                                        const LagField& rho) {
  ProfileSums sums(pairs.grid(), along, section);
  sums.add(z);
  return sums.averages(pairs, rho);
}

}  // namespace asperity::test
