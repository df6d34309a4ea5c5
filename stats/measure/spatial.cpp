// Lengths and directions of the autocorrelation and of the spectrum.
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/measure/acf_estimate.hpp"
#include "stats/measure/groups.hpp"
#include "stats/spatial/acf_length.hpp"
#include "stats/spectrum/spectrum.hpp"

namespace asperity {
namespace {

// A decay's length and direction; returns the relative error of the length.
double add_decay(ParameterList& out, const AcfEstimate& acf, double level, const Reach& reach,
                 const Interval& interval, bool fastest) {
  const auto crossing = first_crossing(acf.rho, acf.basis.pairs.grid(), reach.angle, level);
  const double error = crossing ? acf.length_error(reach.angle, reach.length, crossing->slope) : unknown;
  out.add(
      fastest ? "Sal" : "slowest_decay", "m",
      fastest ? "autocorrelation length, of the fastest decay to {}" : "length of the slowest decay to {}",
      {reach.length, error, interval}, {.meaning = shortest(level)});
  out.add(fastest ? "Sal_direction" : "slowest_direction", "rad",
          fastest ? "of that decay, from +x towards +y" : "of that decay, the lay", {reach.angle});
  return error / reach.length;
}

void add_lobe(ParameterList& out, const AcfEstimate& acf, double level) {
  const CentralLobe lobe = central_lobe(acf.rho, acf.basis.pairs.grid(), level);
  double fastest = 0, slowest = 0;  // relative errors
  if (lobe.r_min) fastest = add_decay(out, acf, level, *lobe.r_min, acf.lengths.r_min(level), true);
  if (lobe.r_max) slowest = add_decay(out, acf, level, *lobe.r_max, acf.lengths.r_max(level), false);
  if (const auto ratio = lobe.aspect_ratio()) {
    const double relative = std::hypot(fastest, slowest);
    out.add("Str", "1", "texture aspect ratio, fastest over slowest decay",
            {*ratio, *ratio * relative, Interval::of_ratio(*ratio, half_width_95 * relative, 1)});
  }
  if (!lobe.ellipse) return;
  out.add("gamma", "1", "ellipticity of the ACF's contour at {}, long axis over short",
          {lobe.ellipse->gamma()}, {.meaning = shortest(level)});
  out.add("gamma_direction", "rad", "of its long axis", {lobe.ellipse->major.angle});
}

}  // namespace

Parameters spatial_parameters(const Sample& sample, const MeasureOptions& options) {
  const Field& z = sample.surface().heights;
  const ErrorBasis& basis = sample.basis();
  if (z.size() == 0) throw DataError(sample.surface().variable, "spatial parameters need the whole field");
  const AcfParameters half{.max_lag = default_max_lag(sample.grid()), .threads = sample.threads()};
  ParameterList out(sample.surface().units);
  add_lobe(out, {basis.estimated ? basis.correlation : estimate_autocorrelation(z, basis.pairs, half), basis},
           options.acf_level);
  const LagField psd = power_spectrum(z, sample.grid(), default_windows(sample.grid()), sample.threads());
  const auto [angle, contrast] = texture_direction(psd, sample.grid());
  const Words few{.why = "no value: the field has too few wave numbers in all directions"};
  out.add("Std", "rad", "texture direction: most power runs this way, the lay across it", {angle}, few);
  out.add("Std_contrast", "1", "power in that direction over its mean, 1 for no texture", {contrast}, few);
  return std::move(out).told(sample.size());
}

}  // namespace asperity
