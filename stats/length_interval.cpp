#include "stats/length_interval.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gsl/gsl_cdf.h>

#include "stats/acf_length.hpp"
#include "stats/acf_lobe.hpp"
#include "stats/gaussian_maximum.hpp"

namespace asperity {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr int directions = 12;

// (1).
LagField freed_of_mean(const LagField& rho, const EffectiveSize& size) {
  const double share = std::min(size.sum(1) / size.points(), 0.5), b = share / (1 - share);
  return LagField((rho.half_plane() + b) / (1 + b));
}

EffectiveSize size_of(const LagField& estimate, const Pairs& pairs, const std::optional<LagField>& known) {
  return known ? EffectiveSize(*known, pairs) : EffectiveSize::of_estimate(estimate, pairs);
}

// The length at a level, if there is such a level and the correlation falls to it.
template <class Length>
double length_at(double level, Length length) {
  return level > 0 && level < 1 ? length(level) : level < 1 ? none : 0;
}

Shape nearest_lag(const Grid& grid, double angle, double length) {
  return {std::lround(length * std::cos(angle) / grid.dx), std::lround(length * std::sin(angle) / grid.dy)};
}

}  // namespace

LengthIntervals::LengthIntervals(const LagField& estimate, const Pairs& pairs,
                                 const std::optional<LagField>& known)
    : rho_(estimate.normalised()),
      freed_(rho_),
      grid_(pairs.grid()),
      error_(known ? *known : significant_lags(estimate, pairs), pairs) {
  const EffectiveSize size = size_of(estimate, pairs, known);
  freed_ = freed_of_mean(rho_, size);
  degrees_ = size.degrees();
  if (!known)
    inflation_ = std::sqrt(
        std::max(1.0, size.sum(2) / EffectiveSize(significant_lags(estimate, pairs), pairs).sum(2)));
}

double LengthIntervals::quantile(double tail) const {
  return std::isinf(degrees_) ? gsl_cdf_ugaussian_Qinv(tail)
                              : gsl_cdf_tdist_Qinv(tail, std::max(degrees_, 1.0));
}

double LengthIntervals::error_at(double angle, double length) const {
  const auto [p, q] = nearest_lag(grid_, angle, length);
  return inflation_ * error_.normalised(p, q);
}

Interval LengthIntervals::along(double angle, double level, double confidence) const {
  const auto at = first_crossing(rho_, grid_, angle, level);
  if (!at) return {none, none};
  const double strays = quantile((1 - confidence) / 2) * error_at(angle, at->lag);
  auto length = [&](double t) {
    const auto crossing = first_crossing(freed_, grid_, angle, t);
    return crossing ? crossing->lag : none;
  };
  return {length_at(level + strays, length), length_at(level - strays, length)};
}

double LengthIntervals::fastest_at(double level) const {
  return length_at(level, [&](double t) {
    const auto reach = central_lobe(freed_, grid_, t).fastest;
    return reach ? reach->length : none;
  });
}

std::vector<Shape> LengthIntervals::lags_within(double level, double length) const {
  std::vector<Shape> out;
  for (int direction = 0; direction < directions; ++direction) {
    const double angle = std::numbers::pi * direction / directions;
    const auto at = first_crossing(freed_, grid_, angle, level);
    if (at && !(at->lag > length)) out.push_back(nearest_lag(grid_, angle, at->lag));
  }
  return out;
}

Interval LengthIntervals::fastest(double level, double confidence) const {
  const auto at = central_lobe(rho_, grid_, level).fastest;
  if (!at) return {none, none};
  const double error = error_at(at->angle, at->length), above = 0.8 * (1 - confidence),
               below = 0.2 * (1 - confidence), single = quantile(above);
  const std::vector<Shape> lags = lags_within(level, fastest_at(level - 2 * single * error));
  const double largest =
      lags.size() < 2
          ? single
          : single / gsl_cdf_ugaussian_Qinv(above) *
                GaussianMaximum(error_.correlation(lags), GaussianMaximum::Of::values).quantile(above);
  return {fastest_at(level + quantile(below) * error), fastest_at(level - largest * error)};
}

}  // namespace asperity
