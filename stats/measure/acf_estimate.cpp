#include "stats/measure/acf_estimate.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "stats/measure/groups.hpp"
#include "stats/spatial/acf_length.hpp"

namespace asperity {
namespace {

// What is measured at one level, of the estimate, which has errors, or of the target.
struct LevelLengths {
  ParameterList& out;
  const AcfEstimate& estimate;
  const AcfLevel& level;
  const LagField* target;
  const LagField& rho = target ? *target : estimate.rho;

  void add(const std::optional<double>& direction) {
    const auto x = add_length("x", 0), y = add_length("y", std::numbers::pi / 2);
    if (direction) add_length("direction", *direction);
    if (x && y) add_ratio(*x, *y);
    add_ellipse();
  }

  struct Length {
    double length, error;
  };

  const Grid& grid() const { return estimate.basis.pairs.grid(); }
  std::string prefix() const { return target ? "target_" : ""; }

  std::optional<Length> add_length(const std::string& name, double angle) {
    const auto crossing = first_crossing(rho, grid(), angle, level.value);
    if (!crossing) return std::nullopt;
    Estimate length{crossing->lag};
    if (!target) {
      length.standard_error = estimate.length_error(angle, crossing->lag, crossing->slope);
      length.interval = estimate.lengths.along(angle, level.value);
    }
    out.add(prefix() + "length_" + level.tag + "_" + name, "m", "where the ACF has fallen to {}", length,
            {.meaning = level.text});
    return Length{length.value, estimate.size.tells_errors() ? length.standard_error : unknown};
  }
  void add_ratio(const Length& x, const Length& y) {
    const double ratio = x.length / y.length, relative = std::hypot(x.error / x.length, y.error / y.length);
    out.add(prefix() + "gamma_" + level.tag, "1", "ellipticity, length in x over length in y",
            {ratio, ratio * relative, Interval::of_ratio(ratio, half_width_95 * relative)});
  }
  void add_ellipse() {
    const auto ellipse = central_lobe(rho, grid(), level.value).ellipse;
    if (!ellipse) return;
    const std::string name = prefix() + "ellipticity_" + level.tag;
    out.add(name, "1", "long over short axis of the contour at {}", {ellipse->gamma()},
            {.meaning = level.text});
    out.add(name + "_direction", "rad", "of the long axis, from +x towards +y", {ellipse->major.angle});
  }
};

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
  const bool known = surface.correlation.has_value();
  return {acf, {known ? *surface.correlation : acf, !known, pairs}, parameters.biased};
}

double AcfEstimate::standard_error(Index p, Index q, bool absolute) const {
  if (!size.tells_errors()) return unknown;
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
    LevelLengths{out, estimate, level, nullptr}.add(direction);
    if (target) LevelLengths{out, estimate, level, &*target}.add(direction);
  }
  return std::move(out).told(estimate.size);
}

}  // namespace asperity
