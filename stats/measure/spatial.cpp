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

void add_lobe(ParameterList& out, const LagField& acf, const Grid& grid, double level,
              const LengthErrors* errors) {
  const CentralLobe lobe = central_lobe(acf, grid, level);
  const Words words{.meaning = shortest(level), .why_no_error = errors ? no_level : ""};
  auto of_lobe = [grid, level](auto value) {
    return
        [=](const LagField& rho) -> std::optional<double> { return value(central_lobe(rho, grid, level)); };
  };
  std::optional<Estimate> aspect;
  if (const auto ratio = lobe.aspect_ratio()) {
    auto of_reaches = [](const CentralLobe& l) {
      return l.r_min && !l.r_max ? std::optional(0.0) : l.aspect_ratio();
    };
    aspect = errors ? errors->ratio(*ratio, of_lobe(of_reaches), 0, 1) : Estimate{*ratio};
  }
  auto add_reach = [&](const char* length, const char* meaning, const char* direction,
                       const char* of_direction, std::optional<Reach> CentralLobe::*which,
                       auto error_of_length) {
    if (!(lobe.*which)) return;
    const Reach& reach = *(lobe.*which);
    out.add(length, "m", meaning, errors ? (errors->*error_of_length)(level, reach) : Estimate{reach.length},
            words);
    auto axis = of_lobe(
        [which](const CentralLobe& l) { return l.*which ? std::optional((l.*which)->angle) : std::nullopt; });
    const double between_lags = std::max(grid.dx, grid.dy) / reach.length;
    out.add(direction, "rad", of_direction,
            errors && aspect ? errors->axis(reach.angle, axis, *aspect, between_lags) : Estimate{reach.angle},
            {.why_no_error = errors && aspect ? no_direction : ""});
  };
  add_reach("Sal", "autocorrelation length: the fastest decay of the ACF to {}", "Sal_direction",
            "direction of the fastest decay, from +x towards +y", &CentralLobe::r_min, &LengthErrors::r_min);
  add_reach("slowest_decay", "length of the slowest decay of the ACF to {}", "slowest_direction",
            "direction of the slowest decay, the lay", &CentralLobe::r_max, &LengthErrors::r_max);
  if (aspect)
    out.add("Str", "1", "texture aspect ratio, fastest over slowest decay", *aspect,
            {.why_no_error = errors ? no_level : ""});
  if (lobe.ellipse)
    add_ellipse(out, *lobe.ellipse, grid, level, words.meaning, {"gamma", "gamma_direction"}, errors);
}

}  // namespace

Parameters lobe_lengths(const LagField& rho, const Grid& grid, double level) {
  ParameterList out("1");
  add_lobe(out, rho, grid, level, nullptr);
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
  add_lobe(out, acf.rho, acf.grid(), options.sal_level, errors ? &*errors : nullptr);
  const LagField psd = power_spectrum(z, sample.grid(), default_windows(sample.grid()), sample.threads());
  out.add(texture_table, texture_direction(psd, sample.grid()),
          {.why = "no value: the field has too few wave numbers"});
  return std::move(out).with_known_errors(sample.size());
}

}  // namespace asperity
