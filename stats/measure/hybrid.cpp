// Slopes, spectral moments and summits.
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>

#include "core/error.hpp"
#include "stats/measure/groups.hpp"

namespace asperity {
namespace {

// What a surface has, or why it has none.
template <class Value>
struct Had {
  Value value;
  std::string why;

  std::string why_or(const char* words) const { return why.empty() ? words : why; }
};

template <class Compute, class Value = std::invoke_result_t<Compute>>
Had<Value> had(const Surface& surface, Compute compute, Value none) try {
  if (surface.units != "m")
    throw DataError(surface.variable, "slopes and areas are those of heights in m, not of " + surface.units);
  return {compute(), ""};
} catch (const DataError& error) {
  return {none, error.what()};
}

// With the relative standard errors of what they are the mean squares of.
struct Slopes : SlopeParameters {
  double square_error;
};
struct ProfileMoments : ProfileSpectralMoments {
  double m2_error, m4_error;
};

constexpr Definition<Slopes> slope_table[] = {
    {"Sdq", "1", "root mean square slope",
     [](const Slopes& s) {
       return Estimate{s.sdq, 0.5 * s.sdq * s.square_error};
     }},
    {"Sdr", "1", "area beyond the plan area, as a share of it; four triangles a cell", [](const Slopes& s) {
       return Estimate{s.sdr, s.sdr * s.square_error};
     }}};

constexpr Definition<ProfileMoments> moment_table[] = {
    {"m2_{}", "1", "mean square slope {}",
     [](const ProfileMoments& m) {
       return Estimate{m.m2, m.m2 * m.m2_error};
     }},
    {"m4_{}", "m-2", "mean square second derivative {}",
     [](const ProfileMoments& m) {
       return Estimate{m.m4, m.m4 * m.m4_error};
     }},
    {"alpha_{}", "1", "bandwidth parameter m0 m4 / m2^2 {}",
     [](const ProfileMoments& m) { return Estimate{m.bandwidth()}; }}};

// Without summits none of them has a height.
double of_any(const Summits& s, double value) { return s.density > 0 ? value : unknown; }

constexpr Definition<Summits> summit_table[] = {
    {"{}_density", "m-2", "summits per area, {}", [](const Summits& s) { return Estimate{s.density}; }},
    {"{}_height", "m", "their mean height above the mean, {}",
     [](const Summits& s) { return Estimate{of_any(s, s.mean_height)}; }},
    {"{}_deviation", "m", "standard deviation of their heights, {}",
     [](const Summits& s) { return Estimate{of_any(s, s.height_deviation)}; }},
    {"{}_curvature", "m-1", "their mean curvature, {}",
     [](const Summits& s) { return Estimate{of_any(s, s.mean_curvature)}; }},
    {"{}_radius", "m", "1 / mean curvature, {}",
     [](const Summits& s) { return Estimate{s.mean_curvature > 0 ? of_any(s, s.radius()) : unknown}; }}};

// Of heights alone; each of them NaN where the surface has none.
struct Hybrid {
  Had<SlopeParameters> slopes;
  Had<SpectralMoments> moments;
  Had<CountedSummits> summits;
  DerivativeErrors errors;

  explicit Hybrid(const Sample& sample)
      : slopes(had(sample.surface(), [&] { return sample.slopes(); }, {unknown, unknown})),
        moments(had(sample.surface(), [&] { return sample.spectral_moments(); },
                    {unknown, unknown, unknown, unknown, unknown, unknown, unknown, unknown, unknown})),
        summits(had(sample.surface(), [&] { return sample.summits(); },
                    {{unknown, unknown, unknown, unknown}, unknown})),
        errors(had(sample.surface(), [&] { return sample.derivative_errors(); },
                   {unknown, unknown, unknown, unknown, unknown})
                   .value) {}
};

}  // namespace

Parameters hybrid_parameters(const Sample& sample, const std::optional<Direction>& direction) {
  const Hybrid of(sample);
  const SpectralMoments& m = of.moments.value;
  // √(2/ν) of ν independent ones.
  auto told = [least = sample.size().least_effective()](double relative) {
    return 2 >= least * relative * relative ? relative : unknown;
  };
  const DerivativeErrors& e = of.errors;
  const std::string no_slope = of.moments.why_or("no value: there is no slope along it");
  ParameterList out(sample.surface().units);
  out.add(slope_table, {of.slopes.value, told(e.square_slope)}, {.why = of.slopes.why});
  out.add("m0", "m2", "spectral moment of order 0, Sq squared",
          {m.m00, m.m00 * told(std::sqrt(2 / sample.size().effective(2)))}, {.why = no_slope});
  out.add(moment_table, {m.along(0), told(e.m20), told(e.m40)}, {"x", "along x", no_slope});
  out.add(moment_table, {m.along(std::numbers::pi / 2), told(e.m02), told(e.m04)},
          {"y", "along y", no_slope});
  if (direction)
    out.add(moment_table, {m.along(direction->angle), unknown, unknown},
            {"direction", "at " + direction->text, no_slope});
  out.add<Summits>(summit_table, of.summits.value,
                   {"summit", "counted", of.summits.why_or("no value: there is no summit")});
  out.add(summit_table, expected_summits(m.isotropic()),
          {"nayak", "expected of a Gaussian surface",
           of.moments.why_or("no value: no Gaussian surface has such spectral moments")});
  return std::move(out).all();
}

}  // namespace asperity
