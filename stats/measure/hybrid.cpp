// Slopes, spectral moments and summits.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <type_traits>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/measure/groups.hpp"

namespace asperity {
namespace {

constexpr double least_share = 0.01;  // of a parameter, below which it is not mentioned

std::string steps_in(double step, double share, const char* square) {
  if (!(share > least_share)) return "";
  return "steps of " + number(step) + " m in the heights are " + number(std::min(100.0, 100 * share)) +
         " % of the mean square " + square;
}

// A value, or NaN and the reason.
template <class Value>
struct Had {
  Value value = {};
  std::string why = {};

  std::string why_or(const char* words) const { return why.empty() ? words : why; }
};

template <class Compute, class Value = std::decay_t<std::invoke_result_t<Compute, const Sample&>>>
Had<Value> had(const Sample& sample, Compute compute) try {
  const Surface& surface = sample.surface();
  if (surface.units != "m")
    throw DataError(surface.variable, "slopes and areas need heights in m, not in " + surface.units);
  return {std::invoke(compute, sample)};
} catch (const DataError& error) {
  return {.why = error.what()};
}

// What a parameter is a function of.
enum class Rests { on_slopes, on_curvatures, on_summits };

// What heights in steps s do: of heights rounded anywhere within them, m2 and m4 of an axis are larger by
// s²/6 and s²/2 over Δ² and Δ⁴, and summits are plateaus.
struct StepDoubts {
  double step = 0, slopes = 0, curvatures = 0, plateaus = 0, summits = 0, width = 0;

  StepDoubts(const Sample& sample, const Derivatives& of)
      : step(sample.surface().step),
        plateaus(of.summits.plateaus),
        summits(of.summits.count),
        width(of.summits.width) {
    const Grid& grid = sample.grid();
    auto share = [this](double parts, double moment, double spacing, int order) {
      const double part = step * step / parts / std::pow(spacing, 2 * order);
      return part < moment * 1e6 ? part / moment : 0;
    };
    const bool x = grid.shape.nx > 1, y = grid.shape.ny > 1;
    slopes = std::max(x * share(6, of.moments.m20, grid.dx, 1), y * share(6, of.moments.m02, grid.dy, 1));
    curvatures = std::max(x * share(2, of.moments.m40, grid.dx, 2), y * share(2, of.moments.m04, grid.dy, 2));
  }
  std::string why(Rests on) const {
    if (on == Rests::on_slopes) return steps_in_slopes(step, slopes);
    if (on == Rests::on_curvatures) return steps_in_curvatures(step, curvatures);
    if (plateaus > least_share * summits)
      return shortest(plateaus) + " of " + shortest(summits) + " summits are plateaus of equal heights";
    // A hundredth of the summits or more were plateaus where steps are a hundredth of second differences.
    if (!(curvatures > least_share * least_share)) return "";
    return "steps of " + number(step) + " m in the heights made plateaus of summits, which a form tilted";
  }
};

// A function of derivatives: its value, and its error by what it is a function of.
struct Differentiated {
  const Derivatives& values;
  const std::optional<DerivativeErrors>& errors;
  const StepDoubts& steps;
  double taken;      // by the form, of the variance of the heights
  double angle = 0;  // of profiles

  // `least` bounds the parameter.
  Estimate operator()(const DerivativeErrors::Function& parameter, Rests on, double least = 0) const {
    const double value = parameter(values);
    if (!errors || !std::isfinite(value)) return {value};
    if (const std::string few =
            on == Rests::on_slopes ? errors->too_few_slopes() : errors->too_few_curvatures();
        !few.empty())
      return {.value = value, .why = few};
    if (const std::string doubt = steps.why(on); !doubt.empty())
      return {.value = value, .why = "no standard error: " + doubt};
    const WaveError error = (*errors)(parameter);
    constexpr double round_off = 1e-12;
    if (!(error.error > round_off * value && value > 0)) return {value};
    const double freed = value / errors->left(parameter, taken), width = error.half_width() / value;
    return {value, error.error,
            Interval::of(value, std::max(std::min(least, value), std::min(value, freed * std::exp(-width))),
                         std::max(value, freed * std::exp(width)))};
  }
};

template <auto figure>
Estimate slope(const Differentiated& of) {
  return of([](const Derivatives& d) { return std::invoke(figure, d.slopes); }, Rests::on_slopes);
}
// Of the profile moments at the angle; `least` bounds the parameter.
template <auto figure, Rests on = Rests::on_curvatures, int least = 0>
Estimate profile(const Differentiated& of) {
  return of([a = of.angle](const Derivatives& d) { return std::invoke(figure, d.moments.along(a)); }, on,
            least);
}

constexpr Definition<Differentiated> slope_table[] = {
    {"Sdq", "1", "root mean square gradient", slope<&SlopeParameters::sdq>},
    {"Sdr", "1", "developed interfacial area ratio, from four triangles per cell",
     slope<&SlopeParameters::sdr>}};

constexpr Definition<Differentiated> moment_table[] = {
    {"m2_{}", "1", "mean square slope {}", profile<&ProfileSpectralMoments::m2, Rests::on_slopes>},
    {"m4_{}", "m-2", "mean square second derivative {}", profile<&ProfileSpectralMoments::m4>},
    {"alpha_{}", "1", "bandwidth parameter m0 m4 / m2^2 {}",
     profile<&ProfileSpectralMoments::bandwidth, Rests::on_curvatures, 1>}};

// Of counted summits, or of those expected.
template <auto figure>
Estimate counted(const Differentiated& of) {
  return of([](const Derivatives& d) { return std::invoke(figure, d.summits); }, Rests::on_summits);
}
template <auto figure>
Estimate expected(const Differentiated& of) {
  return of([](const Derivatives& d) { return std::invoke(figure, expected_summits(d.moments.isotropic())); },
            Rests::on_curvatures);
}

constexpr Definition<Differentiated> summit_table[] = {
    {"summit_density", "m-2", "summits per area, counted", counted<&Summits::density>},
    {"summit_height", "m", "mean height of summits above the mean height, counted",
     counted<&Summits::mean_height>},
    {"summit_deviation", "m", "standard deviation of summit heights, counted",
     counted<&Summits::height_deviation>},
    {"summit_curvature", "m-1", "mean curvature of summits, counted", counted<&Summits::mean_curvature>},
    {"summit_radius", "m", "1 / mean curvature of summits, counted", counted<&Summits::radius>}};

constexpr Definition<Differentiated> nayak_table[] = {
    {"nayak_density", "m-2", "summits per area, expected of a Gaussian surface", expected<&Summits::density>},
    {"nayak_height", "m", "mean height of summits above the mean height, expected of a Gaussian surface",
     expected<&Summits::mean_height>},
    {"nayak_deviation", "m", "standard deviation of summit heights, expected of a Gaussian surface",
     expected<&Summits::height_deviation>},
    {"nayak_curvature", "m-1", "mean curvature of summits, expected of a Gaussian surface",
     expected<&Summits::mean_curvature>},
    {"nayak_radius", "m", "1 / mean curvature of summits, expected of a Gaussian surface",
     expected<&Summits::radius>}};

bool is_profile(const Sample& sample) {
  const auto [nx, ny] = sample.grid().shape;
  return (nx == 1 || ny == 1) && sample.surface().units == "m";
}

// m0 = Sq², with the error and the interval of Sq.
Estimate square_of_sq(const Sample& sample, const MeasureOptions& options) {
  const Parameters heights = height_parameters(sample, options);
  const Parameter& sq = *std::ranges::find(heights, "Sq", &Parameter::name);
  const Interval ends = sq.interval_95();
  const double value = sq.value * sq.value;
  return {value, 2 * sq.value * sq.standard_error,
          Interval::of(value, ends.low * ends.low, ends.high * ends.high)};
}

}  // namespace

std::string slope_symbols() { return symbols_of(slope_table); }

std::string steps_in_slopes(double step, double share) { return steps_in(step, share, "slope"); }
std::string steps_in_curvatures(double step, double share) {
  return steps_in(step, share, "second derivative");
}

Parameters hybrid_parameters(const Sample& sample, const MeasureOptions& options) {
  if (is_profile(sample)) {
    if (options.direction)
      throw ParameterError("direction",
                           "'" + options.direction->text + "' is none of a single row or column");
    return profile_derivatives(sample, square_of_sq(sample, options));
  }
  const auto slopes = had(sample, &Sample::slopes);
  const auto moments = had(sample, &Sample::spectral_moments);
  const auto summits = had(sample, &Sample::summits);
  const Derivatives values{slopes.value, moments.value, summits.value};
  const StepDoubts steps(sample, values);
  const auto errors = had(sample, &Sample::derivative_errors).value;
  const double taken = sample.taken_by_form();
  const std::string no_slope = moments.why_or("no value: the slope in this direction is zero");
  const std::string same = errors ? "no standard error: it is the same all over the field" : "";
  ParameterList out(sample.surface().units);
  out.add(slope_table, {values, errors, steps, taken}, {.why = slopes.why, .why_no_error = same});
  out.add("m0", "m2", "spectral moment of order 0, Sq squared",
          slopes.why.empty() ? square_of_sq(sample, options) : Estimate{unknown},
          {.why = "no value, as slopes have none: " + slopes.why});
  auto add_profiles = [&](double angle, const std::string& name, const std::string& words) {
    out.add(moment_table, {values, errors, steps, taken, angle}, {name, words, no_slope, same});
  };
  add_profiles(0, "x", "along x");
  add_profiles(std::numbers::pi / 2, "y", "along y");
  if (options.direction) add_profiles(options.direction->angle, "direction", "at " + options.direction->text);
  out.add(summit_table, {values, errors, steps, taken},
          {.why = summits.why_or("no value: the field has no summit"), .why_no_error = same});
  out.add(nayak_table, {values, errors, steps, taken},
          {.why = moments.why_or("no value: no Gaussian surface has these spectral moments"),
           .why_no_error = same});
  return std::move(out).with_known_errors(sample.size());
}

std::string doubt_of_steps(const Sample& sample) {
  Derivatives values{.moments = had(sample, &Sample::spectral_moments).value,
                     .summits = had(sample, &Sample::summits).value};
  if (is_profile(sample)) {
    const Parameters rows = profile_derivatives(sample, {unknown});  // m0, m2, m4, …
    const double m2 = rows[1].value, m4 = rows[2].value;
    values = {.moments = {.m20 = m2, .m02 = m2, .m40 = m4, .m04 = m4}};
  }
  const StepDoubts steps(sample, values);
  std::string whys, names;
  for (const auto& [on, these] :
       {std::pair{Rests::on_slopes, "Sdq, Sdr, m2"}, std::pair{Rests::on_curvatures, "m4, alpha, nayak_..."},
        std::pair{Rests::on_summits, "summit_..."}})
    if (const std::string why = steps.why(on); !why.empty()) {
      whys += (whys.empty() ? "" : ", ") + why;
      names += (names.empty() ? "" : ", ") + std::string(these);
    }
  const double least = std::max(4.0, std::ceil(steps.width) + 1);
  return whys.empty() ? ""
                      : whys + ": " + names + " are in doubt and have no errors; lambda-s of " +
                            shortest(least) + " spacings smooths the steps";
}

}  // namespace asperity
