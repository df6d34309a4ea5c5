#include "stats/measure/acf_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/words.hpp"
#include "stats/measure/groups.hpp"

namespace asperity {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

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
    auto ratio = [&](const LagField& r) {
      const auto over = first_crossing(r, grid, 0, level.value),
                 under = first_crossing(r, grid, std::numbers::pi / 2, level.value);
      if (!over && !under) return unknown;
      if (!over || !under) return over ? 0 : unlimited;
      return over->lag / under->lag;
    };
    out.add(prefix + "gamma_" + level.tag, "1", "ratio of lengths, x over y",
            errors ? errors->figure(*x / *y, ratio, 0, unlimited) : Estimate{*x / *y},
            {.why_no_error = errors ? no_level : ""});
  }
  const std::string name = prefix + "ellipticity_" + level.tag;
  add_ellipse(out, errors ? errors->lobe(level.value) : lobe_estimates(rho, grid, level.value), level.text,
              {name, name + "_direction"}, errors != nullptr);
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

void add_ellipse(ParameterList& out, const LobeEstimates& lobe, const std::string& level_text,
                 const std::array<std::string, 2>& names, bool with_errors) {
  if (!lobe.gamma) return;
  out.add(names[0], "1", "ellipticity of the ACF contour at {}, long over short axis", *lobe.gamma,
          {.meaning = level_text, .why_no_error = with_errors ? no_level : ""});
  if (lobe.gamma_axis)
    out.add(names[1], "rad", "direction of the long axis of that contour, from +x towards +y",
            *lobe.gamma_axis);
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

// ---- errors of lengths ----

LengthErrors::LengthErrors(const AcfEstimate& estimate, const Field& heights, double least_level, int threads)
    : grid_(estimate.grid()),
      threads_(threads),
      deviations_(deviations_of(
          estimate, waves_of(estimate, heights, lags_about(estimate.rho, grid_, least_level), threads))),
      rho_(estimate.rho.within(deviations_.max_lag())),
      freed_(estimate.size.freed(rho_)),
      texture_(texture_direction(heights, grid_, threads)) {}

namespace {

// Figure i of ρ', with the interval about it less its bias.
Estimate estimate_of(double value, const FigureDeviations& freed, Index i, double least, double most) {
  const auto [error, bias, falls, rises] = freed.relative(i);
  if (std::isnan(error)) return {value};
  const double half = freed.quantile(0.025) * error, centre = freed(i) * std::exp(-bias),
               low = falls ? least : std::max(least, centre * std::exp(-half)),
               high = rises ? most : std::min(most, centre * std::exp(half));
  return {value, value * error, Interval::of(value, std::min(low, value), std::max(high, value))};
}

}  // namespace

Estimate LengthErrors::figure(double value, const Figure& of, double least, double most) const {
  const auto figures = [&](const LagField& rho) { return Eigen::ArrayXd::Constant(1, of(rho)).eval(); };
  return estimate_of(value, deviations_.of(freed_, figures, threads_), 0, least, most);
}

Estimate LengthErrors::along(double angle, double level, double found) const {
  const auto length = [&](const LagField& rho) {
    const auto crossing = first_crossing(rho, grid_, angle, level);
    return crossing ? crossing->lag : unlimited;
  };
  return figure(found, length, 0, unlimited);
}

// ---- the central lobe ----

namespace {

constexpr double rarely = 0.05;

enum LobeFigure {
  of_r_min,
  of_r_max,
  of_aspect,
  of_gamma,
  of_radius,
  at_r_min,
  at_r_max,
  at_gamma,
  of_anisotropy
};

Eigen::ArrayXd figures_of(const CentralLobe& lobe) {
  auto angle = [](const auto& reach) { return reach ? reach->angle : unknown; };
  auto length = [](const auto& reach) { return reach ? reach->length : unlimited; };
  const auto& ellipse = lobe.ellipse;
  Eigen::ArrayXd out(10);
  out << length(lobe.r_min), length(lobe.r_max),
      lobe.r_min && !lobe.r_max ? 0 : lobe.aspect_ratio().value_or(unknown),
      ellipse ? ellipse->gamma() : unlimited,
      ellipse ? std::sqrt(ellipse->major.length * ellipse->minor) : unlimited, angle(lobe.r_min),
      angle(lobe.r_max), ellipse ? ellipse->major.angle : unknown,
      lobe.anisotropy.value_or(Eigen::Vector2d::Constant(unknown));
  return out;
}

// The interval with this value too.
void hold(std::optional<Estimate>& of, double value) {
  if (!of || !of->interval || !of->interval->known()) return;
  const double low = of->interval->low, high = of->interval->high;
  of->interval = Interval::of(of->value, std::min(low, value), std::max(high, value));
}

// Of a circle the extremes vary as the length of a vector of two chances does, not as one of them.
void set_error_of_circle(std::optional<Estimate>& of, double of_radius) {
  const double rayleigh = std::sqrt(2 - std::numbers::pi / 2);
  if (!of) return;
  const double common = of_radius * of->value, rest = std::pow(of->standard_error, 2) - common * common;
  of->standard_error = std::hypot(common, rayleigh * std::sqrt(std::max(rest, 0.0)));
}

// "two lays or more, near -12 deg and 80 deg", at right angles to their waves.
std::string two_lays(const TextureDirection& texture) {
  auto lay = [](double angle) {
    const double across = std::round((angle + std::numbers::pi / 2) * 180 / std::numbers::pi);
    return across > 90 ? across - 180 : across;
  };
  const auto [one, other] = std::minmax({lay(texture.angle), lay(*texture.other)});
  return "two lays or more, near " + shortest(one) + " deg and " + shortest(other) + " deg";
}

// The contour is interpolated between lags, to h²/(8 r) (acf_length.hpp): ε of (6) to 1 - ε² of h²/(8 r²).
bool is_directed(const FigureDeviations& freed, double between_lags) {
  constexpr double least = 1e-3;
  const double square = std::pow(freed(of_anisotropy), 2) + std::pow(freed(of_anisotropy + 1), 2),
               interpolated = (1 - square) * between_lags * between_lags / 8;
  return freed.chance_of_pair(of_anisotropy, std::pow(std::max(interpolated, least), 2)) < rarely;
}

constexpr const char* no_direction = "no direction is preferred: the contour may be a circle";

}  // namespace

LobeEstimates lobe_estimates(const LagField& rho, const Grid& grid, double level) {
  const CentralLobe lobe = central_lobe(rho, grid, level);
  LobeEstimates out;
  if (lobe.r_min) out.r_min = {lobe.r_min->length}, out.r_min_axis = {lobe.r_min->angle};
  if (lobe.r_max) out.r_max = {lobe.r_max->length}, out.r_max_axis = {lobe.r_max->angle};
  if (const auto aspect = lobe.aspect_ratio()) out.aspect_ratio = {*aspect};
  if (!lobe.ellipse) return out;
  out.gamma = {lobe.ellipse->gamma()};
  constexpr double round_off = 1e-9;
  if (out.gamma->value > 1 + round_off) out.gamma_axis = {lobe.ellipse->major.angle};
  return out;
}

LobeEstimates LengthErrors::lobe(double level) const {
  LobeEstimates out = lobe_estimates(rho_, grid_, level);
  const FigureDeviations freed = deviations_.of(
      freed_, [&](const LagField& rho) { return figures_of(central_lobe(rho, grid_, level)); }, threads_);
  const double spacing = std::max(grid_.dx, grid_.dy);
  auto between_lags = [&](const auto& length) { return length ? spacing / length->value : 0; };
  const std::string why = texture_.other                                ? two_lays(texture_)
                          : is_directed(freed, between_lags(out.r_min)) ? ""
                                                                        : no_direction;
  auto set_axis = [&](std::optional<Estimate>& of, double error, double resolution) {
    if (!of) return;
    const double both = std::hypot(error, resolution / std::sqrt(12)), half = freed.quantile(0.025) * both;
    of = why.empty() && !std::isnan(both)
             ? Estimate{of->value, both, Interval::about(of->value, half)}
             : Estimate{.value = unknown, .why = "no value: " + (why.empty() ? no_direction : why)};
  };
  set_axis(out.r_min_axis, freed.of_axis(at_r_min), between_lags(out.r_min));
  set_axis(out.r_max_axis, freed.of_axis(at_r_max), between_lags(out.r_max));
  set_axis(out.gamma_axis, freed.of_axis(at_gamma), 0);
  set_axis(out.texture = Estimate{texture_.angle}, texture_.error, 0);
  auto set = [&](std::optional<Estimate>& of, Index i, double least, double most) {
    if (of) of = estimate_of(of->value, freed, i, least, most);
  };
  set(out.r_min, of_r_min, 0, unlimited);
  if (texture_.other) {
    for (auto* of : {&out.r_max, &out.aspect_ratio, &out.gamma})
      if (*of) (*of)->why = "no error: " + why;
    return out;
  }
  set(out.r_max, of_r_max, 0, unlimited);
  set(out.aspect_ratio, of_aspect, 0, 1), set(out.gamma, of_gamma, 1, unlimited);
  if (why.empty()) return out;
  hold(out.aspect_ratio, 1), hold(out.gamma, 1);
  set_error_of_circle(out.aspect_ratio, 0), set_error_of_circle(out.gamma, 0);
  const Estimate radius = estimate_of(freed(of_radius), freed, of_radius, 0, unlimited);
  if (!radius.interval) return out;
  set_error_of_circle(out.r_max, radius.standard_error / radius.value);
  hold(out.r_min, radius.interval->high), hold(out.r_max, radius.interval->low);
  return out;
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
