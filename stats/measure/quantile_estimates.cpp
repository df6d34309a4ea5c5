#include "stats/measure/quantile_estimates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stats/height/material_ratio.hpp"
#include "stats/sample/quantiles.hpp"

namespace asperity {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

// Of heights that the form has lowered by the factor `left`.
Interval freed(double height, double left, double low, double high) {
  return Interval::of(height, std::min(height, low / left), std::max(height, high / left));
}

}  // namespace

std::vector<Estimate> quantile_estimates(const Sample& sample, const std::vector<double>& shares,
                                         const std::vector<double>& heights, Origin origin) {
  std::vector<Estimate> out;
  const bool lowered = origin == Origin::own_mean && !sample.distribution();
  const double left = lowered ? std::sqrt(1 - sample.taken_by_form()) : 1;
  if (lowered && sample.correlation_gives_errors()) {
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const double error = material_height_error(1 - shares[i], sample.moments(), sample.size()),
                   half = half_width_95 * error;
      out.push_back({heights[i], error, freed(heights[i], left, heights[i] - half, heights[i] + half)});
    }
    return out;
  }
  const auto errors = shares.empty() ? std::nullopt : sample.quantile_errors(heights);
  auto quantiles_beside = [&](const std::vector<double>& widths) {
    std::vector<double> at;
    for (std::size_t k = 0; k < shares.size(); ++k)
      for (const double sign : {-1, 1})
        at.push_back(std::isnan(widths[k]) ? shares[k] : std::clamp(shares[k] + sign * widths[k], 0.0, 1.0));
    return sample.quantiles(at);
  };
  if (!errors) {
    for (const double height : heights) out.push_back({height});
    return out;
  }
  std::vector<double> width;
  for (std::size_t k = 0; k < shares.size(); ++k) width.push_back((*errors)(k));
  const double t = student_quantile(0.025, errors->degrees());
  const std::vector<double> near = quantiles_beside(width);
  for (double& w : width) w *= t;
  const std::vector<double> ends = quantiles_beside(width);
  for (std::size_t k = 0; k < shares.size(); ++k) {
    out.push_back({heights[k]});
    const double apart = near[2 * k + 1] - near[2 * k], share = width[k] / t;
    if (!(apart > 0 && share > 0)) continue;  // as of heights of two values
    const double density = origin == Origin::own_mean ? 2 * share / apart : 0,
                 of_all = errors->with_mean(k, density) / share;
    out[k].standard_error = of_all * apart / 2;
    // Open where the field holds no such share.
    const double low = heights[k] - of_all * std::max(heights[k] - ends[2 * k], 0.0),
                 high = heights[k] + of_all * std::max(ends[2 * k + 1] - heights[k], 0.0);
    out[k].interval = freed(heights[k], left, shares[k] > width[k] ? low : -unlimited,
                            1 - shares[k] > width[k] ? high : unlimited);
  }
  return out;
}

}  // namespace asperity
