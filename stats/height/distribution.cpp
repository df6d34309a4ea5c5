#include "stats/height/distribution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include "core/error.hpp"
#include "math/hermite.hpp"

namespace asperity {
namespace {

// Φ(b) - Φ(a) without cancellation in the upper tail.
double gaussian_share(double a, double b) {
  return a > 0 ? gsl_cdf_ugaussian_Q(a) - gsl_cdf_ugaussian_Q(b)
               : gsl_cdf_ugaussian_P(b) - gsl_cdf_ugaussian_P(a);
}

void compare_with_gaussian(Bin& bin, const Moments& moments, const EffectiveSampleSize& size) {
  const double a = (bin.lower - moments.mean) / moments.sq, b = (bin.upper - moments.mean) / moments.sq;
  const double share = gaussian_share(a, b);
  HermiteFunction at_a(a, gsl_ran_ugaussian_pdf(a)), at_b(b, gsl_ran_ugaussian_pdf(b));
  auto weight = [&](int k) {
    const double c = at_a.next() - at_b.next();
    return c * c / k;
  };
  const double n = size.points();
  const auto [all, misfit] = variance_of(weight, share * (1 - share), size);
  bin.expected = n * share;
  bin.count_error = std::sqrt(n * n * all);
  bin.misfit_error = std::sqrt(n * n * misfit);
}

}  // namespace

HermiteVariance variance_of(const std::function<double(int)>& weight, double total,
                            const EffectiveSampleSize& size) {
  constexpr int powers = EffectiveSampleSize::powers;
  std::array<double, powers + 1> w;
  for (int k = 1; k <= powers; ++k) w[static_cast<std::size_t>(k)] = weight(k);
  auto from = [&](int first) {
    auto kept = [&](int k) { return k < first ? 0 : w[static_cast<std::size_t>(k)]; };
    return size.variance_of_mean(kept, total);
  };
  const double dropped = (w[1] + w[2]) * size.sum(powers) / size.points();
  return {std::max(from(1), 0.0), std::max(from(3) - dropped, 0.0)};
}

HeightRange height_range(const Field& z) {
  return {z.minCoeff<Eigen::PropagateNumbers>(), z.maxCoeff<Eigen::PropagateNumbers>()};
}

int scott_bins(const Moments& moments, double points) {
  const double width = std::cbrt(24 / std::numbers::inv_sqrtpi / points) * moments.sq;
  return static_cast<int>(std::clamp(std::ceil(moments.sz() / width), 1.0, std::min(points, 1e6)));
}

std::vector<Bin> histogram(const Field& z, const Moments& moments, const EffectiveSampleSize& size, int bins,
                           std::optional<HeightRange> range) {
  if (bins < 1) throw ParameterError("bins", "'" + std::to_string(bins) + "' is below 1");
  if (!range) range = height_range(z);
  const double lowest = range->lowest, width = range->width() / bins;
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  if (!(width >= epsilon * z.isNaN().select(0, z).abs().maxCoeff()))
    throw DataError("heights", "their range is too narrow for " + std::to_string(bins) +
                                   " bins: neighbouring edges are the same double");
  std::vector<Bin> out(static_cast<std::size_t>(bins));
  for (std::size_t b = 0; b < out.size(); ++b) {
    out[b].lower = lowest + static_cast<double>(b) * width;
    out[b].upper = lowest + static_cast<double>(b + 1) * width;
  }
  for (const double height : z.reshaped<Eigen::RowMajor>()) {
    if (std::isnan(height)) continue;
    const auto b = static_cast<std::size_t>((height - lowest) / width);
    out[std::min(b, out.size() - 1)].count += 1;
  }
  for (Bin& bin : out) compare_with_gaussian(bin, moments, size);
  return out;
}

}  // namespace asperity
