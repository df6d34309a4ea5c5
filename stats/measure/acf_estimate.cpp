#include "stats/measure/acf_estimate.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "stats/measure/groups.hpp"
#include "stats/spatial/acf_length.hpp"

namespace asperity {
namespace {

// The lengths at one level, of a target or of the estimate; only the latter has errors.
void add_lengths(ParameterList& out, const AcfEstimate& estimate, const AcfLevel& level,
                 const std::optional<double>& direction, const LagField* target) {
  const LagField& rho = target ? *target : estimate.rho;
  const Grid& grid = estimate.basis.pairs.grid();
  const std::string prefix = target ? "target_" : "";
  auto along = [&](const std::string& name, double angle) -> std::optional<Estimate> {
    const auto crossing = first_crossing(rho, grid, angle, level.value);
    if (!crossing) return std::nullopt;
    Estimate length{crossing->lag};
    if (!target) {
      length.standard_error = estimate.length_error(angle, crossing->lag, crossing->slope);
      length.interval = estimate.lengths.along(angle, level.value);
    }
    out.add(prefix + "length_" + level.tag + "_" + name, "m", "lag at which the ACF falls to {}", length,
            {.meaning = level.text});
    return length;
  };
  const auto x = along("x", 0), y = along("y", std::numbers::pi / 2);
  if (direction) along("direction", *direction);
  if (x && y) {
    const double ratio = x->value / y->value,
                 relative = std::hypot(x->standard_error / x->value, y->standard_error / y->value),
                 error = estimate.size.gives_errors() ? relative : unknown;
    out.add(prefix + "gamma_" + level.tag, "1", "ratio of lengths, x over y",
            {ratio, ratio * error, Interval::of_ratio(ratio, half_width_95 * error)});
  }
  if (const auto ellipse = central_lobe(rho, grid, level.value).ellipse) {
    const std::string name = prefix + "ellipticity_" + level.tag;
    out.add(name, "1", "ellipticity of the ACF contour at {}, long over short axis", {ellipse->gamma()},
            {.meaning = level.text});
    out.add(name + "_direction", "rad", "direction of the long axis of that contour, from +x towards +y",
            {ellipse->major.angle});
  }
}

}  // namespace

AcfEstimate::AcfEstimate(const LagField& acf, const ErrorBasis& of_errors, bool divided_by_all)
    : rho(acf.normalised()),
      variance(acf(0, 0)),
      basis(of_errors),
      error(basis.known_lags(), basis.pairs),
      lengths(acf, basis.pairs, basis.known()),
      size(basis.size()),
      biased(divided_by_all) {}

AcfEstimate AcfEstimate::of(const Surface& surface, const AcfParameters& parameters) {
  const Pairs pairs = Pairs::of(surface.heights, surface.grid, parameters.threads);
  const LagField acf = estimate_autocorrelation(surface.heights, pairs, parameters);
  return {acf, {surface.correlation.value_or(acf), !surface.correlation, pairs}, parameters.biased};
}

double AcfEstimate::standard_error(Index p, Index q, bool absolute) const {
  if (!size.gives_errors()) return unknown;
  return (biased ? basis.pairs.pair_fraction(p, q) : 1) *
         (absolute ? error.absolute(p, q) : error.normalised(p, q));
}

double AcfEstimate::length_error(double angle, double length, double slope) const {
  const auto [p, q] = nearest_lag(basis.pairs.grid(), angle, length);
  return (biased ? basis.pairs.pair_fraction(p, q) : 1) * error.normalised(p, q) / -slope;
}

Parameters acf_lengths(const AcfEstimate& estimate, const std::vector<AcfLevel>& levels,
                       const std::optional<double>& direction, const std::optional<LagField>& target) {
  ParameterList out("1");
  for (const AcfLevel& level : levels) {
    add_lengths(out, estimate, level, direction, nullptr);
    if (target) add_lengths(out, estimate, level, direction, &*target);
  }
  return std::move(out).with_known_errors(estimate.size);
}

}  // namespace asperity
