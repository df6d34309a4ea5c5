// Slopes, spectral moments and summits.
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "stats/measure/groups.hpp"

namespace asperity {
namespace {

// Computes what a surface of heights has; returns why it has none, "" where it has.
std::string why_not(const Surface& surface, const auto& compute) try {
  if (surface.units != "m")
    throw DataError(surface.variable, "slopes and areas are those of heights in m, not of " + surface.units);
  compute();
  return "";
} catch (const DataError& error) {
  return error.what();
}

// With the relative standard errors of these mean squares.
struct ProfileMoments : ProfileSpectralMoments {
  double m2_error, m4_error;
};

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

}  // namespace

Parameters hybrid_parameters(const Sample& sample, const MeasureOptions& options) {
  const Surface& surface = sample.surface();
  SlopeParameters slopes{unknown, unknown};
  SpectralMoments m{unknown, unknown, unknown, unknown, unknown, unknown, unknown, unknown, unknown};
  CountedSummits summits{{unknown, unknown, unknown, unknown}, unknown};
  DerivativeErrors e{unknown, unknown, unknown, unknown, unknown};
  auto or_else = [](const std::string& why, const char* words) { return why.empty() ? words : why; };
  const std::string no_slopes = why_not(surface, [&] { slopes = sample.slopes(); }),
                    no_moments = why_not(surface, [&] { m = sample.spectral_moments(); }),
                    no_summits = why_not(surface, [&] { summits = sample.summits(); }),
                    no_slope = or_else(no_moments, "no value: there is no slope along it");
  why_not(surface, [&] { e = sample.derivative_errors(); });
  // √(2/ν) of ν independent ones.
  auto told = [least = sample.size().least_effective()](double relative) {
    return 2 >= least * relative * relative ? relative : unknown;
  };
  const double of_square = told(e.square_slope);
  ParameterList out(surface.units);
  out.add("Sdq", "1", "root mean square slope", {slopes.sdq, 0.5 * slopes.sdq * of_square},
          {.why = no_slopes});
  out.add("Sdr", "1", "area beyond the plan area, as a share of it; four triangles a cell",
          {slopes.sdr, slopes.sdr * of_square}, {.why = no_slopes});
  out.add("m0", "m2", "spectral moment of order 0, Sq squared",
          {m.m00, m.m00 * told(std::sqrt(2 / sample.size().effective(2)))}, {.why = no_slope});
  out.add(moment_table, {m.along(0), told(e.m20), told(e.m40)}, {"x", "along x", no_slope});
  out.add(moment_table, {m.along(std::numbers::pi / 2), told(e.m02), told(e.m04)},
          {"y", "along y", no_slope});
  if (const auto& direction = options.direction)
    out.add(moment_table, {m.along(direction->angle), unknown, unknown},
            {"direction", "at " + direction->text, no_slope});
  out.add<Summits>(summit_table, summits,
                   {"summit", "counted", or_else(no_summits, "no value: there is no summit")});
  out.add(summit_table, expected_summits(m.isotropic()),
          {"nayak", "expected of a Gaussian surface",
           or_else(no_moments, "no value: no Gaussian surface has such spectral moments")});
  return std::move(out).all();
}

}  // namespace asperity
