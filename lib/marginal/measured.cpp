#include "marginal/measured.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <gsl/gsl_cdf.h>

#include "core/error.hpp"
#include "core/words.hpp"

namespace asperity {
namespace {

constexpr auto last_node = static_cast<double>(2 * MeasuredHeights::half);

// Q(p) between order statistics.
double quantile(const std::vector<double>& sorted, double p) {
  const double place =
      std::clamp(p * static_cast<double>(sorted.size()) - 0.5, 0.0, static_cast<double>(sorted.size() - 1));
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

void standardise(MeasuredHeights& g) {
  const HeightMoments moments = height_moments(g.translation());
  if (!(moments.variance > 0)) throw DataError("marginal", "all its heights are equal");
  g.quantiles = (g.quantiles - moments.mean) / std::sqrt(moments.variance);
}

}  // namespace

MeasuredHeights MeasuredHeights::of(std::vector<double> sample) {
  if (sample.size() < least)
    throw DataError("marginal", counted(static_cast<std::int64_t>(sample.size()), "height") +
                                    " are too few for a distribution: at least " + std::to_string(least));
  if (!std::ranges::all_of(sample, [](double z) { return std::isfinite(z); }))
    throw DataError("marginal", "a height is not finite");
  std::ranges::sort(sample);
  const double size = sample.back() - sample.front(), middle = sample[sample.size() / 2];
  if (!(size > 0)) throw DataError("marginal", "all its heights are equal");
  const double last = gsl_cdf_ugaussian_Qinv(0.5 / static_cast<double>(sample.size()));
  MeasuredHeights out{last / static_cast<double>(half), Eigen::ArrayXd(2 * half + 1)};
  for (Eigen::Index j = -half; j <= half; ++j)
    out.quantiles(half + j) =
        (quantile(sample, gsl_cdf_ugaussian_P(static_cast<double>(j) * out.step)) - middle) / size;
  standardise(out);
  return out;
}

Translation MeasuredHeights::translation() const {
  const auto table = std::make_shared<const Eigen::ArrayXd>(quantiles);
  // Nodes of a quadrature of this detail are those of the table.
  return {"measured", 2.5 * step, [table, step = step](std::span<double> y) {
            for (double& value : y) {
              const double place = std::clamp(value / step + static_cast<double>(half), 0.0, last_node);
              const Eigen::Index below =
                  std::min<Eigen::Index>(static_cast<Eigen::Index>(place), 2 * half - 1);
              const double low = (*table)(below), high = (*table)(below + 1);
              value = low + (place - static_cast<double>(below)) * (high - low);
            }
          }};
}

}  // namespace asperity
