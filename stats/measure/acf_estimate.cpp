#include "stats/measure/acf_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "stats/measure/groups.hpp"

namespace asperity {
namespace {

constexpr double unlimited = AcfDeviations::beyond;

// The first rows of lags, as many as lengths at a level and above are found in; all, if some are not found.
LagField lags_of_lengths(const LagField& rho, const Grid& grid, double level,
                         const std::optional<double>& direction = {}) {
  for (Index last = 63;; last = 2 * last + 1) {
    const LagField near = rho.within({last, rho.max_q()});
    auto crossed = [&](double angle) { return first_crossing(near, grid, angle, level).has_value(); };
    const bool found = crossed(0) && crossed(std::numbers::pi / 2) && (!direction || crossed(*direction)) &&
                       central_lobe(near, grid, level).r_max;
    if (found || last >= rho.max_p()) return near;
  }
}

AcfDeviations deviations_of(const AcfEstimate& estimate, const LagWaves& waves) {
  return estimate.biased ? waves.of_ratio(estimate.rho).scaled([&](Index p, Index q) {
    return estimate.basis.pairs.pair_fraction(p, q);
  })
                         : waves.of_ratio(estimate.rho);
}

// At lags up to half the field few will do: time and memory grow with their number.
LagWaves waves_of(const AcfEstimate& estimate, const Field& heights, Shape max_lag, int threads,
                  double most = LongWaves::reach) {
  return {heights, estimate.grid(), max_lag, estimate.basis.extent(), threads, most};
}

// The lengths at one level, of a target or of the estimate; only the latter has errors.
void add_lengths(ParameterList& out, const LagField& rho, const Grid& grid, const AcfLevel& level,
                 const std::optional<double>& direction, const std::string& prefix,
                 const LengthErrors* errors) {
  auto along = [&](const std::string& name, double angle) -> std::optional<double> {
    const auto crossing = first_crossing(rho, grid, angle, level.value);
    if (!crossing) return std::nullopt;
    out.add(prefix + "length_" + level.tag + "_" + name, "m", "lag at which the ACF falls to {}",
            errors ? errors->along(angle, level.value, crossing->lag) : Estimate{crossing->lag},
            {.meaning = level.text, .why_no_error = errors ? no_level : ""});
    return crossing->lag;
  };
  const auto x = along("x", 0), y = along("y", std::numbers::pi / 2);
  if (direction) along("direction", *direction);
  if (x && y) {
    auto ratio = [&](const LagField& r) -> std::optional<double> {
      const auto over = first_crossing(r, grid, 0, level.value),
                 under = first_crossing(r, grid, std::numbers::pi / 2, level.value);
      if (!over && !under) return std::nullopt;
      if (!over || !under) return over ? 0 : unlimited;
      return over->lag / under->lag;
    };
    out.add(prefix + "gamma_" + level.tag, "1", "ratio of lengths, x over y",
            errors ? errors->ratio(*x / *y, ratio, 0, unlimited) : Estimate{*x / *y},
            {.why_no_error = errors ? no_level : ""});
  }
  if (const auto ellipse = central_lobe(rho, grid, level.value).ellipse) {
    const std::string name = prefix + "ellipticity_" + level.tag;
    add_ellipse(out, *ellipse, grid, level.value, level.text, {name, name + "_direction"}, errors);
  }
}

}  // namespace

Shape lags_about(const LagField& rho, const Grid& grid, double level) {
  const CentralLobe lobe = central_lobe(lags_of_lengths(rho, grid, level), grid, level);
  if (!lobe.r_min || !lobe.r_max) return rho.max_lag();
  const double c = std::cos(lobe.r_max->angle), s = std::sin(lobe.r_max->angle);
  auto far = [&](double along_major, double along_minor, double spacing, Index most) {
    const double half_side = std::hypot(lobe.r_max->length * along_major, lobe.r_min->length * along_minor);
    return std::min(most, static_cast<Index>(2.5 * half_side / spacing) + 3);
  };
  return {far(c, s, grid.dx, rho.max_p()), far(s, c, grid.dy, rho.max_q())};
}

void add_ellipse(ParameterList& out, const LobeEllipse& ellipse, const Grid& grid, double level,
                 const std::string& level_text, const std::array<std::string, 2>& names,
                 const LengthErrors* errors) {
  const auto gamma = [=](const LagField& rho) -> std::optional<double> {
    const auto found = central_lobe(rho, grid, level).ellipse;
    return found ? found->gamma() : unlimited;
  };
  const auto axis = [=](const LagField& rho) -> std::optional<double> {
    const auto found = central_lobe(rho, grid, level).ellipse;
    return found ? std::optional(found->major.angle) : std::nullopt;
  };
  const Estimate ratio =
      errors ? errors->ratio(ellipse.gamma(), gamma, 1, unlimited) : Estimate{ellipse.gamma()};
  out.add(names[0], "1", "ellipticity of the ACF contour at {}, long over short axis", ratio,
          {.meaning = level_text, .why_no_error = errors ? no_level : ""});
  constexpr double round_off = 1e-9;
  if (ellipse.gamma() <= 1 + round_off) return;  // a circle
  out.add(names[1], "rad", "direction of the long axis of that contour, from +x towards +y",
          errors ? errors->axis(ellipse.major.angle, axis, ratio) : Estimate{ellipse.major.angle},
          {.why_no_error = errors ? no_direction : ""});
}

AcfEstimate::AcfEstimate(const LagField& acf, const ErrorBasis& of_errors, bool divided_by_all)
    : rho(acf.normalised()),
      variance(acf(0, 0)),
      basis(of_errors),
      size(basis.size()),
      biased(divided_by_all) {}

AcfEstimate AcfEstimate::of(const Surface& surface, const AcfParameters& parameters) {
  const Pairs pairs = Pairs::of(surface.heights, surface.grid, parameters.threads);
  const LagField acf = estimate_autocorrelation(surface.heights, pairs, parameters);
  return {acf,
          {surface.correlation.value_or(acf),
           !surface.correlation,
           pairs,
           {surface.heights, pairs, surface.degree, parameters.threads}},
          parameters.biased};
}

namespace {

LagField acf_errors(const AcfEstimate& estimate, const AcfDeviations& deviations, bool absolute) {
  const LagField errors = deviations.errors();
  return LagField::of(errors.max_lag(), [&](Index p, Index q) {
    if (!estimate.size.gives_errors()) return unknown;
    if (!absolute && p == 0 && q == 0) return 0.0;
    return (estimate.biased ? estimate.basis.pairs.pair_fraction(p, q) : 1) * errors(p, q);
  });
}

AcfDeviations deviations_of(const AcfEstimate& estimate, const LagWaves& waves, bool absolute) {
  return absolute ? waves.of_covariance() : waves.of_ratio(estimate.rho);
}

}  // namespace

LagField acf_errors(const AcfEstimate& estimate, const Field& heights, bool absolute, int threads) {
  const LagWaves waves = waves_of(estimate, heights, estimate.rho.max_lag(), threads, LongWaves::near);
  return acf_errors(estimate, deviations_of(estimate, waves, absolute), absolute);
}

ProfileErrors profile_errors(const AcfEstimate& estimate, const Field& heights, bool along_x, bool absolute,
                             int threads) {
  const Shape lags = along_x ? Shape{estimate.rho.max_p(), 0} : Shape{0, estimate.rho.max_q()};
  const LagWaves waves = waves_of(estimate, heights, lags, threads, LongWaves::near);
  auto profile = [&](const LagField& errors) -> Eigen::ArrayXd {
    return along_x ? errors.along_x() : errors.along_y();
  };
  const AcfDeviations of_acf = deviations_of(estimate, waves, absolute), of_structure = waves.of_structure();
  ProfileErrors out{profile(acf_errors(estimate, of_acf, absolute)), profile(of_structure.errors()),
                    of_acf.quantile(0.025), Eigen::ArrayXd()};
  out.structure(0) = 0;
  const double left = 1 - estimate.size.taken_by_form();
  const LagField near = estimate.rho.within(lags);
  const Eigen::ArrayXd rho = profile(near), freed = profile(estimate.size.freed(near));
  out.bias = absolute ? (estimate.variance * (rho - freed / left)).eval() : (rho - freed).eval();
  if (!estimate.size.gives_errors()) out.structure.setConstant(unknown);
  return out;
}

LengthErrors::LengthErrors(const AcfEstimate& estimate, const Field& heights, double least_level, int threads)
    : grid_(estimate.grid()),
      threads_(threads),
      deviations_(deviations_of(
          estimate, waves_of(estimate, heights, lags_about(estimate.rho, grid_, least_level), threads))),
      rho_(estimate.rho.within(deviations_.max_lag())),
      intervals_(rho_, grid_, deviations_, estimate.size.freed(rho_)) {}

Estimate LengthErrors::length(double found, const AcfDeviations::Figure& figure,
                              const Interval& interval) const {
  return {found, deviations_.relative(rho_, figure, threads_).error * found, interval};
}

Estimate LengthErrors::along(double angle, double level, double found) const {
  auto length_of = [&](const LagField& rho) -> std::optional<double> {
    const auto crossing = first_crossing(rho, grid_, angle, level);
    return crossing ? std::optional(crossing->lag) : std::nullopt;
  };
  return length(found, length_of, intervals_.along(angle, level));
}

Estimate LengthErrors::extreme(double level, const Reach& reach, Extreme which,
                               const Interval& interval) const {
  auto length_of = [&](const LagField& rho) -> std::optional<double> {
    const auto found = central_lobe(rho, grid_, level).*which;
    return found ? std::optional(found->length) : std::nullopt;
  };
  return length(reach.length, length_of, interval);
}

Estimate LengthErrors::r_min(double level, const Reach& reach) const {
  return extreme(level, reach, &CentralLobe::r_min, intervals_.r_min(level));
}
Estimate LengthErrors::r_max(double level, const Reach& reach) const {
  return extreme(level, reach, &CentralLobe::r_max, intervals_.r_max(level));
}

Estimate LengthErrors::ratio(double value, const AcfDeviations::Figure& figure, double least,
                             double most) const {
  const LagField& freed = intervals_.freed();
  const auto [error, bias, falls, rises] = deviations_.relative(freed, figure, threads_);
  if (std::isnan(error)) return {value};
  const double half = deviations_.quantile(0.025) * error, centre = *figure(freed) * std::exp(-bias),
               low = falls ? least : std::max(least, centre * std::exp(-half)),
               high = rises ? most : std::min(most, centre * std::exp(half));
  return {value, value * error, Interval::of(value, std::min(low, value), std::max(high, value))};
}

Estimate LengthErrors::axis(double angle, const AcfDeviations::Figure& figure, const Estimate& aspect,
                            double resolution) const {
  if (!aspect.interval || !(aspect.interval->low > 1 || aspect.interval->high < 1)) return {angle};
  const double error = std::hypot(deviations_.of_axis(rho_, figure, threads_), resolution / std::sqrt(12));
  return {angle, error, Interval::about(angle, deviations_.quantile(0.025) * error)};
}

namespace {

ParameterList list_of_lengths(const LagField& rho, const Grid& grid, const std::vector<AcfLevel>& levels,
                              const std::optional<double>& direction, const std::optional<LagField>& target,
                              const LengthErrors* errors) {
  ParameterList out("1");
  const double least = std::ranges::min(levels, {}, &AcfLevel::value).value;
  const LagField near = lags_of_lengths(rho, grid, least, direction);
  for (const AcfLevel& level : levels) {
    add_lengths(out, near, grid, level, direction, "", errors);
    if (target) add_lengths(out, *target, grid, level, direction, "target_", nullptr);
  }
  return out;
}

}  // namespace

Parameters acf_lengths(const AcfEstimate& estimate, const std::vector<AcfLevel>& levels,
                       const std::optional<double>& direction, const std::optional<LagField>& target,
                       const std::optional<LengthErrors>& errors) {
  return list_of_lengths(estimate.rho, estimate.grid(), levels, direction, target,
                         errors ? &*errors : nullptr)
      .with_known_errors(estimate.size);
}

Parameters acf_lengths(const LagField& rho, const Grid& grid, const std::vector<AcfLevel>& levels,
                       const std::optional<double>& direction) {
  return list_of_lengths(rho, grid, levels, direction, {}, nullptr).all();
}

}  // namespace asperity
