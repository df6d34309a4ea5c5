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

constexpr Definition<TextureDirection> texture_table[] = {
    {"Std", "rad", "texture direction: that of the largest power, at right angles to the lay",
     value_of<&TextureDirection::angle>},
    {"Std_contrast", "1", "largest power over directions divided by the mean, 1 for no texture",
     value_of<&TextureDirection::contrast>}};

void add_lobe(ParameterList& out, const AcfEstimate& acf, double level) {
  const Grid& grid = acf.basis.pairs.grid();
  const CentralLobe lobe = central_lobe(acf.rho, grid, level);
  const Words words{.meaning = shortest(level)};
  double relative = 0;  // error of Str
  auto add_length = [&](const char* symbol, const char* meaning, const Reach& reach,
                        const Interval& interval) {
    const auto crossing = first_crossing(acf.rho, grid, reach.angle, level);
    const double error = crossing ? acf.length_error(reach.angle, reach.length, crossing->slope) : unknown;
    relative = std::hypot(relative, error / reach.length);
    out.add(symbol, "m", meaning, {reach.length, error, interval}, words);
  };
  if (lobe.r_min) {
    add_length("Sal", "autocorrelation length: the fastest decay of the ACF to {}", *lobe.r_min,
               acf.lengths.r_min(level));
    out.add("Sal_direction", "rad", "direction of the fastest decay, from +x towards +y",
            {lobe.r_min->angle});
  }
  if (lobe.r_max) {
    add_length("slowest_decay", "length of the slowest decay of the ACF to {}", *lobe.r_max,
               acf.lengths.r_max(level));
    out.add("slowest_direction", "rad", "direction of the slowest decay, the lay", {lobe.r_max->angle});
  }
  if (const auto ratio = lobe.aspect_ratio())
    out.add("Str", "1", "texture aspect ratio, fastest over slowest decay",
            {*ratio, *ratio * relative, Interval::of_ratio(*ratio, half_width_95 * relative, 1)});
  if (lobe.ellipse) {
    out.add("gamma", "1", "ellipticity of the ACF contour at {}, long over short axis",
            {lobe.ellipse->gamma()}, words);
    out.add("gamma_direction", "rad", "direction of the long axis of that contour",
            {lobe.ellipse->major.angle});
  }
}

}  // namespace

Parameters spatial_parameters(const Sample& sample, const MeasureOptions& options) {
  const Field& z = sample.surface().heights;
  const ErrorBasis& basis = sample.basis();
  if (z.size() == 0) throw DataError(sample.surface().variable, "spatial parameters need the whole field");
  const AcfParameters half{.max_lag = default_max_lag(sample.grid()), .threads = sample.threads()};
  ParameterList out(sample.surface().units);
  add_lobe(out, {basis.estimated ? basis.correlation : estimate_autocorrelation(z, basis.pairs, half), basis},
           options.sal_level);
  const LagField psd = power_spectrum(z, sample.grid(), default_windows(sample.grid()), sample.threads());
  out.add(texture_table, texture_direction(psd, sample.grid()),
          {.why = "no value: the field has too few wave numbers"});
  return std::move(out).with_known_errors(sample.size());
}

}  // namespace asperity
