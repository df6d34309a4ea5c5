#include "stats/uncertainty/length_interval.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gsl/gsl_cdf.h>

#include "stats/sample/quantiles.hpp"
#include "stats/spatial/acf_length.hpp"
#include "stats/uncertainty/null_distribution.hpp"

namespace asperity {
namespace {

constexpr double beyond = std::numeric_limits<double>::infinity();
constexpr int directions = 12;

// Open above; none where even the lower end lies beyond the lags.
Interval held(double length, double low, double high) {
  return low < beyond ? Interval::of(length, low, high) : Interval();
}

// What the field's mean leaves of the errors that a known correlation gives.
double left_by_mean(const EffectiveSampleSize& size) {
  return std::sqrt(1 - std::min(std::pow(size.sum(1), 2) / (size.points() * size.sum(2)), 0.5));
}

// By how much the errors of what stands out of the noise are too small.
double lost_in_noise(const EffectiveSampleSize& size, const EffectiveSampleSize& admitted) {
  return std::pow(std::max(1.0, size.sum(2) / admitted.sum(2)), 0.25);
}

double normal_quantile(double tail) { return gsl_cdf_ugaussian_Qinv(tail); }

}  // namespace

LengthIntervals::LengthIntervals(const LagField& estimate, const Pairs& pairs,
                                 const std::optional<LagField>& known)
    : LengthIntervals(estimate.normalised(), significant_lags(estimate, pairs), pairs, known) {}

LengthIntervals::LengthIntervals(const LagField& rho, const LagField& admitted, const Pairs& pairs,
                                 const std::optional<LagField>& known)
    : rho_(rho),
      grid_(pairs.grid()),
      size_(known ? EffectiveSampleSize(*known, pairs) : EffectiveSampleSize::of_estimate(rho, pairs)),
      error_(known ? *known : admitted, pairs),
      freed_((rho.half_plane() + size_.bias_of_lags()) / (1 + size_.bias_of_lags())),
      strays_(error_.normalised(rho.max_lag()).half_plane() *
              (known ? left_by_mean(size_) : lost_in_noise(size_, EffectiveSampleSize(admitted, pairs)))) {}

LagField LengthIntervals::band(double u) const {
  return LagField(freed_.half_plane() + u * strays_.half_plane());
}

Interval LengthIntervals::along(double angle, double level, double confidence) const {
  const double u = normal_quantile((1 - confidence) / 2);
  auto length = [&](const LagField& rho) {
    const auto crossing = first_crossing(rho, grid_, angle, level);
    return crossing ? crossing->lag : beyond;
  };
  return held(length(rho_), length(band(-u)), length(band(u)));
}

double LengthIntervals::length_of(Decay decay, const LagField& rho, double level) const {
  const CentralLobe lobe = central_lobe(rho, grid_, level);
  const auto& reach = decay == Decay::r_min ? lobe.r_min : lobe.r_max;
  return reach ? reach->length : beyond;
}

double LengthIntervals::quantile_of_extreme(const std::vector<Reached>& reached, double tail) const {
  const double wider = student_quantile(tail, std::max(size_.degrees(), 1.0)) / normal_quantile(tail);
  if (reached.size() < 2) return wider * normal_quantile(tail);
  std::vector<Shape> lags;
  for (const Reached& r : reached) lags.push_back(r.lag);
  auto largest = [](const Eigen::VectorXd& g, auto) { return g.maxCoeff(); };
  return wider * NullDistribution(error_.correlation(lags), largest).quantile(tail);
}

double LengthIntervals::strayed(Decay decay, double level, double tail) const {
  std::vector<Reached> reached;
  for (int direction = 0; direction < directions; ++direction) {
    const double angle = std::numbers::pi * direction / directions;
    if (const auto at = first_crossing(freed_, grid_, angle, level))
      reached.push_back({nearest_lag(grid_, angle, at->lag), at->lag});
  }
  const double side = decay == Decay::r_min ? 1 : -1;
  while (true) {
    const double end = length_of(decay, band(side * quantile_of_extreme(reached, tail)), level);
    if (std::erase_if(reached, [&](const Reached& r) { return side * (r.length - end) > 0; }) == 0)
      return end;
  }
}

Interval LengthIntervals::r_min(double level, double confidence) const {
  const double tail = 1 - confidence, u = normal_quantile(tail / 2);
  return held(length_of(Decay::r_min, rho_, level), length_of(Decay::r_min, band(-u), level),
              strayed(Decay::r_min, level, tail));
}

Interval LengthIntervals::r_max(double level, double confidence) const {
  const double tail = 1 - confidence, u = normal_quantile(tail / 2);
  return held(length_of(Decay::r_max, rho_, level), strayed(Decay::r_max, level, tail),
              length_of(Decay::r_max, band(u), level));
}

}  // namespace asperity
