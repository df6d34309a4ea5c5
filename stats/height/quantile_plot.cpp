#include "stats/height/quantile_plot.hpp"

#include <cmath>
#include <string>

#include <gsl/gsl_cdf.h>

#include "core/error.hpp"

namespace asperity {

std::vector<QuantilePoint> quantile_plot(const MaterialRatioCurve& curve, const Moments& moments,
                                         const EffectiveSampleSize& size, int points) {
  if (points < 1) throw ParameterError("points", "value " + std::to_string(points) + " is below 1");
  std::vector<QuantilePoint> out(static_cast<std::size_t>(points));
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double share = (static_cast<double>(i) + 0.5) / points, x = gsl_cdf_ugaussian_Pinv(share);
    out[i] = {.share = share,
              .normal = x,
              .height = curve.quantile(share),
              .height_error = material_height_error(1 - share, moments, size),
              .gaussian = moments.mean + moments.sq * x,
              .misfit_error = material_height_error(1 - share, moments, size, Fitted::mean_and_sq)};
  }
  return out;
}

}  // namespace asperity
