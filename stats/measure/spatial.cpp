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

struct Decay {
  Reach reach;
  double error;
  Interval interval;
};

Estimate length_of(const Decay& decay) { return {decay.reach.length, decay.error, decay.interval}; }
Estimate angle_of(const Decay& decay) { return {decay.reach.angle}; }

constexpr Definition<Decay> fastest_table[] = {
    {"Sal", "m", "autocorrelation length, of the fastest decay to {}", length_of},
    {"Sal_direction", "rad", "of that decay, from +x towards +y", angle_of}};

constexpr Definition<Decay> slowest_table[] = {
    {"slowest_decay", "m", "length of the slowest decay to {}", length_of},
    {"slowest_direction", "rad", "of that decay, the lay", angle_of}};

constexpr Definition<LobeEllipse> ellipse_table[] = {
    {"gamma", "1", "ellipticity of the ACF's contour at {}, long axis over short",
     [](const LobeEllipse& ellipse) { return Estimate{ellipse.gamma()}; }},
    {"gamma_direction", "rad", "of its long axis",
     [](const LobeEllipse& ellipse) { return Estimate{ellipse.major.angle}; }}};

constexpr Definition<TextureDirection> texture_table[] = {
    {"Std", "rad", "texture direction: most power runs this way, the lay across it",
     value_of<&TextureDirection::angle>},
    {"Std_contrast", "1", "power in that direction over its mean, 1 for no texture",
     value_of<&TextureDirection::contrast>}};

Decay decay_of(const AcfEstimate& acf, const Reach& reach, double level, const Interval& interval) {
  const auto crossing = first_crossing(acf.rho, acf.basis.pairs.grid(), reach.angle, level);
  return {reach, crossing ? acf.length_error(reach.angle, reach.length, crossing->slope) : unknown, interval};
}

void add_lobe(ParameterList& out, const AcfEstimate& acf, double level) {
  const CentralLobe lobe = central_lobe(acf.rho, acf.basis.pairs.grid(), level);
  const Words words{.meaning = shortest(level)};
  double relative = 0;  // error of Str
  auto add = [&](const auto& table, const Reach& reach, const Interval& interval) {
    const Decay decay = decay_of(acf, reach, level, interval);
    relative = std::hypot(relative, decay.error / reach.length);
    out.add(table, decay, words);
  };
  if (lobe.r_min) add(fastest_table, *lobe.r_min, acf.lengths.r_min(level));
  if (lobe.r_max) add(slowest_table, *lobe.r_max, acf.lengths.r_max(level));
  if (const auto ratio = lobe.aspect_ratio())
    out.add("Str", "1", "texture aspect ratio, fastest over slowest decay",
            {*ratio, *ratio * relative, Interval::of_ratio(*ratio, half_width_95 * relative, 1)});
  if (lobe.ellipse) out.add(ellipse_table, *lobe.ellipse, words);
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
  out.add(texture_table, texture_direction(psd, sample.grid()),
          {.why = "no value: the field has too few wave numbers in all directions"});
  return std::move(out).told(sample.size());
}

}  // namespace asperity
