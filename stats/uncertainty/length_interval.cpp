#include "stats/uncertainty/length_interval.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gsl/gsl_cdf.h>

#include "stats/spatial/acf_length.hpp"
#include "stats/uncertainty/null_distribution.hpp"

namespace asperity {
namespace {

constexpr double beyond = std::numeric_limits<double>::infinity();
constexpr int directions = 12;

// Open above; none where even the lower end lies beyond the lags.
Interval held(double length, double low, double high) {
  return low < beyond ? Interval::of(length, std::min(length, low), std::max(length, high)) : Interval();
}

// The rms of the errors at lags of nearly the same ρ, linear between steps of ρ.
LagField as_function_of(const LagField& rho, const LagField& errors) {
  constexpr double step = 0.05;
  const Field &at = rho.half_plane(), &error = errors.half_plane();
  auto place = [](double r) { return std::clamp((r + 0.5) / step, 0.0, 1.5 / step); };
  Eigen::ArrayXd sums = Eigen::ArrayXd::Zero(static_cast<Index>(1.5 / step) + 2), weights = sums;
  auto share = [&](double r, auto visit) {
    const auto low = static_cast<Index>(place(r));
    const double high = place(r) - static_cast<double>(low);
    visit(low, 1 - high), visit(low + 1, high);
  };
  for (Index i = 0; i < at.size(); ++i)
    if (const double square = error(i) * error(i); std::isfinite(square) && std::isfinite(at(i)))
      share(at(i), [&](Index k, double w) { sums(k) += w * square, weights(k) += w; });
  return LagField(Field::NullaryExpr(at.rows(), at.cols(), [&](Index i, Index j) {
    if (!std::isfinite(at(i, j)) || !std::isfinite(error(i, j))) return error(i, j);
    double square = 0;
    share(at(i, j), [&](Index k, double w) {
      if (weights(k) > 0) square += w * sums(k) / weights(k);
    });
    return std::sqrt(square);
  }));
}

}  // namespace

LengthIntervals::LengthIntervals(const LagField& rho, const Grid& grid, const AcfDeviations& deviations,
                                 LagField freed)
    : rho_(rho),
      grid_(grid),
      deviations_(deviations),
      freed_(std::move(freed)),
      strays_(deviations.errors()),
      even_(as_function_of(freed_, strays_)) {}

LagField LengthIntervals::band(const LagField& freed, double u, const LagField& strays) {
  return LagField(freed.half_plane() + u * strays.half_plane());
}

Interval LengthIntervals::along(double angle, double level, double confidence) const {
  const double u = deviations_.quantile((1 - confidence) / 2);
  auto length = [&](const LagField& rho) {
    const auto crossing = first_crossing(rho, grid_, angle, level);
    return crossing ? crossing->lag : beyond;
  };
  return held(length(rho_), length(band(freed_, -u, strays_)), length(band(freed_, u, strays_)));
}

double LengthIntervals::length_of(Decay decay, const LagField& rho, double level) const {
  const CentralLobe lobe = central_lobe(rho, grid_, level);
  const auto& reach = decay == Decay::r_min ? lobe.r_min : lobe.r_max;
  return reach ? reach->length : beyond;
}

double LengthIntervals::quantile_of_extreme(const std::vector<Reached>& reached, double tail) const {
  const double of_one = deviations_.quantile(tail);
  if (reached.size() < 2) return of_one;
  std::vector<Shape> lags;
  for (const Reached& r : reached) lags.push_back(r.lag);
  auto largest = [](const Eigen::VectorXd& g, auto) { return g.maxCoeff(); };
  return of_one / gsl_cdf_ugaussian_Qinv(tail) *
         NullDistribution(deviations_.correlation(lags), largest).quantile(tail);
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
    const double end =
        length_of(decay, band(freed_, side * quantile_of_extreme(reached, tail), even_), level);
    if (std::erase_if(reached, [&](const Reached& r) { return side * (r.length - end) > 0; }) == 0)
      return end;
  }
}

Interval LengthIntervals::r_min(double level, double confidence) const {
  const double tail = 1 - confidence, u = deviations_.quantile(tail / 2);
  return held(length_of(Decay::r_min, rho_, level), length_of(Decay::r_min, band(freed_, -u, even_), level),
              strayed(Decay::r_min, level, tail));
}

Interval LengthIntervals::r_max(double level, double confidence) const {
  const double tail = 1 - confidence, u = deviations_.quantile(tail / 2);
  return held(length_of(Decay::r_max, rho_, level), strayed(Decay::r_max, level, tail),
              length_of(Decay::r_max, band(freed_, u, even_), level));
}

}  // namespace asperity
