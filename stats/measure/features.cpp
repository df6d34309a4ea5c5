// Hills, dales, peaks and pits.
#include "stats/feature/features.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/measure/groups.hpp"

namespace asperity {
namespace {

constexpr std::size_t least_features = 10;  // that an error needs

struct FeatureSample {
  Features features = {};
  std::optional<LocalMeans> means = {};  ///< none: no errors are asked for
  std::string plateaus = {};             ///< why what counts peaks has no error; "" if they are points
};

template <bool of_dales>
const Features::Kind& kind_in(const Features& features) {
  return of_dales ? features.dales() : features.hills();
}

// By the number of features that the mean is of.
Estimate mean_over(const FeatureSample& of, bool of_dales, Features::Figure figure, std::size_t number,
                   const char* what) {
  const Features::Kind& kind = of_dales ? of.features.dales() : of.features.hills();
  const double value = kind.figures(of.features.area()).*figure;
  const bool of_peaks = figure == &FeatureFigures::density || figure == &FeatureFigures::curvature;
  if (of_peaks && !of.plateaus.empty()) return {.value = value, .why = of.plateaus};
  if (!of.means || !std::isfinite(value)) return {value};
  if (number < least_features)
    return {.value = value,
            .why = "no standard error: " + counted(static_cast<Index>(number), what) +
                   ", and an error needs " + std::to_string(least_features)};
  const WaveError error = of.means->error(
      [&](const Eigen::VectorXd& means) { return of.features.figures(means, of_dales).*figure; });
  if (!(error.error > 0 && value > 0)) return {value, error.error};
  const double width = error.half_width() / value;
  return {value, error.error, Interval::of(value, value * std::exp(-width), value * std::exp(width))};
}

template <bool of_dales>
Estimate density(const FeatureSample& of) {
  const Features::Kind& kind = kind_in<of_dales>(of.features);
  return mean_over(of, of_dales, &FeatureFigures::density, kind.peaks(), of_dales ? "pit" : "peak");
}

// Noise makes peaks of low local height, and curvatures of its own at the others.
template <bool of_dales>
Estimate curvature(const FeatureSample& of) {
  const Features::Kind& kind = kind_in<of_dales>(of.features);
  Estimate out = mean_over(of, of_dales, &FeatureFigures::curvature, kind.peaks(), of_dales ? "pit" : "peak");
  if (2 * kind.all.size() < kind.unpruned && std::isfinite(out.value) && out.why.empty())
    out.why = "rough: " + std::to_string(kind.unpruned - kind.all.size()) + " of " +
              counted(static_cast<Index>(kind.unpruned), of_dales ? "pit" : "peak") +
              " are lower than the pruning, as of noise, which the curvature of the others has too: smooth "
              "it by lambda-s";
  return out;
}

template <bool of_dales, Features::Figure figure>
Estimate of_closed(const FeatureSample& of) {
  return mean_over(of, of_dales, figure, kind_in<of_dales>(of.features).closed(),
                   of_dales ? "closed dale" : "closed hill");
}

Estimate five(double value, std::size_t number) {
  if (std::isnan(value)) return {value};
  return {.value = value,
          .why = number < 5 ? "no standard error: there are " + std::to_string(number)
                            : "no standard error: five features decide it"};
}
template <bool of_dales>
Estimate five_of(const FeatureSample& of) {
  const Features::Kind& kind = kind_in<of_dales>(of.features);
  return five(kind.five(), kind.peaks());
}
Estimate ten(const FeatureSample& of) {
  const Features::Kind &hills = of.features.hills(), &dales = of.features.dales();
  return five(hills.five() + dales.five(), std::min(hills.peaks(), dales.peaks()));
}

constexpr Definition<FeatureSample> feature_table[] = {
    {"Spd", "m-2", "peaks per area, {}", density<false>},
    {"Svd", "m-2", "pits per area, {}", density<true>},
    {"Spc", "m-1", "mean curvature at peaks, {}", curvature<false>},
    {"Svc", "m-1", "mean curvature at pits, {}", curvature<true>},
    {"S5p", of_field, "mean height of the five highest peaks above the mean, {}", five_of<false>},
    {"S5v", of_field, "mean depth of the five deepest pits below the mean, {}", five_of<true>},
    {"S10z", of_field, "S5p + S5v, {}", ten},
    {"Sha", "m2", "mean area of closed hills above the median, {}", of_closed<false, &FeatureFigures::area>},
    {"Sda", "m2", "mean area of closed dales below the median, {}", of_closed<true, &FeatureFigures::area>},
    {"Shv", "m3", "mean volume of closed hills above the median, {}",
     of_closed<false, &FeatureFigures::volume>},
    {"Sdv", "m3", "mean volume of closed dales below the median, {}",
     of_closed<true, &FeatureFigures::volume>}};

}  // namespace

std::string feature_symbols() { return symbols_of(feature_table); }

Parameters feature_parameters(const Sample& sample, const MeasureOptions& options) {
  const auto& [bound, of_sz] = options.pruning;
  if (!(bound >= 0 && bound < (of_sz ? 1 : std::numeric_limits<double>::infinity())))
    throw ParameterError("pruning",
                         "'" + shortest(bound) + "' is " +
                             (of_sz ? "no share of Sz, from 0 to below 1" : "no height, from 0 m on"));
  const Surface& surface = sample.surface();
  FeatureSample of;
  Words words{
      .meaning = "pruned at " + (of_sz ? in_digits(100 * bound, 3) + " % of Sz" : in_digits(bound, 3) + " m"),
      .why = "no value: none is closed",
      .why_no_error = of_sz ? "no standard error: Sz grows with the field, prune at a height"
                            : "no standard error: it is the same all over the field"};
  try {
    if (surface.units != "m")
      throw DataError(surface.variable, "features need heights in m, not in " + surface.units);
    of.features =
        Features(surface.heights, sample.grid(), options.pruning, sample.round_off(), sample.threads());
    if (const CountedSummits& all = sample.summits(); all.plateaus > 0.01 * all.count)
      of.plateaus = "no standard error: " + shortest(all.plateaus) + " of " + shortest(all.count) +
                    " summits are plateaus of equal heights, which smoothing by lambda-s makes points";
    if (sample.needs_errors() && !of_sz) of.means = of.features.means(sample.extent(), sample.threads());
  } catch (const DataError& error) {
    words.why = error.what();
  }
  ParameterList out(surface.units);
  out.add(feature_table, of, words);
  return std::move(out).with_known_errors(sample.size());
}

}  // namespace asperity
