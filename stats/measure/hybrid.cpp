// Slopes, spectral moments and summits.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "stats/measure/groups.hpp"

namespace asperity {
namespace {

// A value, or NaN and the reason.
template <class Value>
struct Had {
  Value value = {};
  std::string why = {};

  std::string why_or(const char* words) const { return why.empty() ? words : why; }
};

template <class Value>
Had<Value> had(const Sample& sample, Value (Sample::*compute)() const) try {
  const Surface& surface = sample.surface();
  if (surface.units != "m")
    throw DataError(surface.variable, "slopes and areas need heights in m, not in " + surface.units);
  return {(sample.*compute)()};
} catch (const DataError& error) {
  return {.why = error.what()};
}

// With the relative standard errors of the mean squares.
struct Slopes : SlopeParameters {
  double square_error;
};
struct ProfileMoments : ProfileSpectralMoments {
  double m2_error, m4_error;
};

Estimate with_relative_error(double value, double error) { return {value, value * error}; }

constexpr Definition<Slopes> slope_table[] = {
    {"Sdq", "1", "root mean square gradient",
     [](const Slopes& s) { return with_relative_error(s.sdq, 0.5 * s.square_error); }},
    {"Sdr", "1", "developed interfacial area ratio, from four triangles per cell",
     [](const Slopes& s) { return with_relative_error(s.sdr, s.square_error); }}};

constexpr Definition<ProfileMoments> moment_table[] = {
    {"m2_{}", "1", "mean square slope {}",
     [](const ProfileMoments& m) { return with_relative_error(m.m2, m.m2_error); }},
    {"m4_{}", "m-2", "mean square second derivative {}",
     [](const ProfileMoments& m) { return with_relative_error(m.m4, m.m4_error); }},
    {"alpha_{}", "1", "bandwidth parameter m0 m4 / m2^2 {}",
     [](const ProfileMoments& m) { return Estimate{m.bandwidth()}; }}};

constexpr Definition<Summits> summit_table[] = {
    {"{}_density", "m-2", "summits per area, {}", value_of<&Summits::density>},
    {"{}_height", "m", "mean height of summits above the mean height, {}", value_of<&Summits::mean_height>},
    {"{}_deviation", "m", "standard deviation of summit heights, {}", value_of<&Summits::height_deviation>},
    {"{}_curvature", "m-1", "mean curvature of summits, {}", value_of<&Summits::mean_curvature>},
    {"{}_radius", "m", "1 / mean curvature of summits, {}",
     [](const Summits& s) { return Estimate{s.radius()}; }}};

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

Parameters hybrid_parameters(const Sample& sample, const MeasureOptions& options) {
  const auto slopes = had(sample, &Sample::slopes);
  const auto moments = had(sample, &Sample::spectral_moments);
  const SpectralMoments& m = moments.value;
  const auto summits = had(sample, &Sample::summits);
  const DerivativeErrors e = had(sample, &Sample::derivative_errors).value;
  // √(2/ν) of ν independent ones.
  auto known = [least = sample.size().least_effective()](double relative) {
    return 2 >= least * relative * relative ? relative : unknown;
  };
  const std::string no_slope = moments.why_or("no value: the slope in this direction is zero");
  ParameterList out(sample.surface().units);
  out.add(slope_table, {slopes.value, known(e.square_slope)}, {.why = slopes.why});
  out.add("m0", "m2", "spectral moment of order 0, Sq squared",
          moments.why.empty() ? square_of_sq(sample, options) : Estimate{unknown}, {.why = no_slope});
  out.add(moment_table, {m.along(0), known(e.m20), known(e.m40)}, {"x", "along x", no_slope});
  out.add(moment_table, {m.along(std::numbers::pi / 2), known(e.m02), known(e.m04)},
          {"y", "along y", no_slope});
  if (options.direction)
    out.add(moment_table, {m.along(options.direction->angle), unknown, unknown},
            {"direction", "at " + options.direction->text, no_slope});
  out.add<Summits>(summit_table, summits.value,
                   {"summit", "counted", summits.why_or("no value: the field has no summit")});
  out.add(summit_table, expected_summits(m.isotropic()),
          {"nayak", "expected of a Gaussian surface",
           moments.why_or("no value: no Gaussian surface has these spectral moments")});
  return std::move(out).all();
}

}  // namespace asperity
