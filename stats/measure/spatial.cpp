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

void add_lobe(ParameterList& out, const LobeEstimates& lobe, double level, bool with_errors) {
  const Words words{.meaning = shortest(level), .why_no_error = with_errors ? no_level : ""};
  auto add = [&](const char* name, const char* unit, const char* meaning,
                 const std::optional<Estimate>& estimate) {
    if (estimate) out.add(name, unit, meaning, *estimate, unit == std::string("rad") ? Words{} : words);
  };
  add("Sal", "m", "autocorrelation length: the fastest decay of the ACF to {}", lobe.r_min);
  add("Sal_direction", "rad", "direction of the fastest decay, from +x towards +y", lobe.r_min_axis);
  add("slowest_decay", "m", "length of the slowest decay of the ACF to {}", lobe.r_max);
  add("slowest_direction", "rad", "direction of the slowest decay, the lay", lobe.r_max_axis);
  add("Str", "1", "texture aspect ratio, fastest over slowest decay", lobe.aspect_ratio);
  add_ellipse(out, lobe, words.meaning, {"gamma", "gamma_direction"}, with_errors);
}

// Aligned scan lines have lost waves across them, by an amount of which no error tells.
void mark_aligned(Parameters& all) {
  for (Parameter& p : all) {
    p.standard_error = unknown, p.interval.reset();
    if (std::isfinite(p.value))
      p.why = "no error: the scan lines were aligned, which takes waves of the surface across them";
  }
}

// Of every other line or a checkerboard, whose transform folds waves back too.
bool knows_neighbours(const LagField& rho, const Grid& grid) {
  return !(grid.shape.nx > 1 && std::isnan(rho(1, 0))) && !(grid.shape.ny > 1 && std::isnan(rho(0, 1)));
}

void mark_unknown(Parameters& all) {
  for (Parameter& p : all) {
    p.value = p.standard_error = unknown, p.interval.reset();
    p.why = "no value: no two neighbouring points along an axis are both measured";
  }
}

}  // namespace

Parameters lobe_lengths(const LagField& rho, const Grid& grid, double level) {
  ParameterList out("1");
  add_lobe(out, lobe_estimates(rho, grid, level), level, false);
  return std::move(out).all();
}

AcfEstimate AcfEstimate::of(const Sample& sample) {
  const ErrorBasis& basis = sample.basis();
  const AcfParameters half{.max_lag = default_max_lag(sample.grid()), .threads = sample.threads()};
  return {basis.estimated ? basis.correlation
                          : estimate_autocorrelation(sample.surface().heights, basis.pairs, half),
          basis};
}

Parameters spatial_parameters(const Sample& sample, const MeasureOptions& options) {
  const Field& z = sample.surface().heights;
  ParameterList out(sample.surface().units);
  const AcfEstimate acf = AcfEstimate::of(sample);
  std::optional<LengthErrors> errors;
  if (sample.needs_errors() && acf.size.gives_errors())
    errors.emplace(acf, z, options.sal_level, sample.threads());
  const LobeEstimates lobe =
      errors ? errors->lobe(options.sal_level) : lobe_estimates(acf.rho, acf.grid(), options.sal_level);
  add_lobe(out, lobe, options.sal_level, errors.has_value());
  const TextureDirection texture =
      errors ? errors->texture() : texture_direction(z, sample.grid(), sample.threads());
  const Words few{.why = "no value: the field has too few wave numbers"};
  const bool enough = std::isfinite(texture.angle);
  out.add("Std", "rad", "texture direction: that of the largest power, at right angles to the lay",
          enough && lobe.texture ? *lobe.texture : Estimate{texture.angle}, few);
  out.add("Std_contrast", "1", "largest power over directions divided by the mean, 1 for no texture",
          {texture.contrast}, few);
  Parameters all = std::move(out).with_known_errors(sample.size());
  if (sample.surface().aligned > 0) mark_aligned(all);
  if (!knows_neighbours(acf.rho, sample.grid())) mark_unknown(all);
  return all;
}

}  // namespace asperity
