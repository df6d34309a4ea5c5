#include "stats/height/distribution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include "core/error.hpp"
#include "math/hermite.hpp"
#include "stats/height/height_classes.hpp"

namespace asperity {
namespace {

// Φ(b) - Φ(a) without cancellation in the upper tail.
double gaussian_share(double a, double b) {
  return a > 0 ? gsl_cdf_ugaussian_Q(a) - gsl_cdf_ugaussian_Q(b)
               : gsl_cdf_ugaussian_P(b) - gsl_cdf_ugaussian_P(a);
}

}  // namespace

double misfit_variance(const std::function<double(int)>& weight, double total,
                       const EffectiveSampleSize& size) {
  constexpr int powers = EffectiveSampleSize::powers;
  std::array<double, powers + 1> w;
  for (int k = 1; k <= powers; ++k) w[static_cast<std::size_t>(k)] = weight(k);
  const double dropped = (w[1] + w[2]) * size.sum(powers) / size.points();
  auto kept = [&](int k) { return k < 3 ? 0 : w[static_cast<std::size_t>(k)]; };
  return std::max(size.variance_of_mean(kept, total) - dropped, 0.0);
}

HeightRange height_range(const Field& z) {
  return {z.minCoeff<Eigen::PropagateNumbers>(), z.maxCoeff<Eigen::PropagateNumbers>()};
}

int scott_bins(const Moments& moments, double points) {
  const double width = std::cbrt(24 / std::numbers::inv_sqrtpi / points) * moments.sq;
  return static_cast<int>(std::clamp(std::ceil(moments.sz() / width), 1.0, std::min(points, 1e6)));
}

std::vector<Bin> histogram(const Field& z, int bins, std::optional<HeightRange> range) {
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
  return out;
}

void compare_with_gaussian(std::vector<Bin>& bins, const Moments& moments, const EffectiveSampleSize& size) {
  for (Bin& bin : bins) {
    const double a = (bin.lower - moments.mean) / moments.sq, b = (bin.upper - moments.mean) / moments.sq;
    const double share = gaussian_share(a, b);
    HermiteFunction at_a(a, gsl_ran_ugaussian_pdf(a)), at_b(b, gsl_ran_ugaussian_pdf(b));
    auto weight = [&](int k) {
      const double c = at_a.next() - at_b.next();
      return c * c / k;
    };
    const double n = size.points();
    bin.expected = n * share;
    bin.misfit_error = n * std::sqrt(misfit_variance(weight, share * (1 - share), size));
  }
}

void set_errors(std::vector<Bin>& bins, const Field& z, const Grid& grid, const FieldExtent& extent,
                double sq) {
  // An error of the mean is Sq/√N_eff at least.
  const double step = 0.5 * sq / std::sqrt(std::max(extent.patches, 1.0)), width = bins.front().width();
  const Index parts = sq > 0 ? static_cast<Index>(std::min(std::ceil(width / step), 1e3)) : 1;
  const HeightClasses classes(
      z, grid, extent, {bins.front().lower, bins.back().upper, parts * static_cast<Index>(bins.size())},
      sq > 0);
  std::vector<Frequency> shares;
  for (std::size_t b = 0; b < bins.size(); ++b) {
    ShareErrors::Function in_bin(classes.errors());
    for (Index k = 0; k < parts; ++k) in_bin.add(static_cast<Index>(b) * parts + k, 1);
    shares.push_back(classes.frequency(in_bin, bins[b].count, [&](double delta) {
      return classes.below(bins[b].upper + delta) - classes.below(bins[b].lower + delta);
    }));
  }
  set_intervals(shares, 1, classes.errors().degrees());
  for (std::size_t b = 0; b < bins.size(); ++b) bins[b].share = shares[b];
}

}  // namespace asperity
