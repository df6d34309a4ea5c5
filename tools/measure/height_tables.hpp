/// Tables of the distribution of the heights of a field beside the Gaussian of the same mean and Sq.
#pragma once

#include "stats/height/distribution.hpp"
#include "stats/measure/surface.hpp"
#include "tools/cli/table.hpp"

namespace asperity::cli {

/// A field, and the errors of its distribution.
struct Heights {
  const Surface& surface;
  const Moments& m;
  const EffectiveSampleSize& size;
};

/// Columns: height, count, standard_error, gaussian, misfit, density, density_error, gaussian_density.
Table histogram_of(const Heights& heights, int bins, std::optional<HeightRange> range = {});
/// Columns: height, density, standard_error, gaussian_density, misfit. The bandwidth is in metres.
Table density_of(const Heights& heights, double bandwidth, int rows, std::optional<HeightRange> range = {});
/// Columns: share, normal_quantile, height, standard_error, gaussian_height, misfit.
Table quantiles_of(const Heights& heights, int rows, int threads);

}  // namespace asperity::cli
