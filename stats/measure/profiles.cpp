// Means and spreads over the profiles along x or along y.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/measure/groups.hpp"

namespace asperity {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

struct Definition1D {
  const char* symbol;
  std::string_view unit;
  const char* meaning;
};

// In the order of ProfileParameters.
constexpr std::array<Definition1D, profile_parameters_count> table{
    {{"a", of_field, "arithmetic mean height"},
     {"q", of_field, "root mean square height"},
     {"sk", "1", "skewness, 0 for a Gaussian"},
     {"ku", "1", "kurtosis, 3 for a Gaussian"},
     {"p", of_field, "peak height, mean over the section lengths"},
     {"v", of_field, "pit depth, mean over the section lengths"},
     {"z", of_field, "maximum height, mean over the section lengths"},
     {"t", of_field, "total height of the profile"},
     {"dq", "1", "root mean square slope, from seven points"},
     {"Sm", "m", "mean profile element spacing"}}};

// With Student's interval: of the logarithm, where the parameter is positive, `least` at least.
Estimate with_error(double value, const WaveError& of, double least) {
  if (!std::isfinite(of.error)) return {value};
  if (least < 0) return {value, of.error, Interval::about(value, of.half_width())};
  const Interval ends = Interval::of_ratio(value, of.half_width() / value);
  return {value, of.error, Interval::of(value, std::max(ends.low, std::min(least, value)), ends.high)};
}

Estimate spread_of(const SequenceMean& of) {
  if (!std::isfinite(of.of_spread.error)) return {of.spread};
  return {of.spread, of.of_spread.error,
          Interval::of_inverse(of.spread, of.of_spread.half_width() / of.spread)};
}

std::string why_no_profile_error(const SequenceMean& of) {
  if (of.independent >= SequenceMean::least_independent)
    return "no standard error: it is the same in all profiles";
  const std::string count = rounded(of.independent);
  return "no standard error can be given: " + count + (count == "1" ? " profile is" : " profiles are") +
         " independent, fewer than " + shortest(SequenceMean::least_independent);
}

}  // namespace

Parameters profile_averages(const Sample& sample, const MeasureOptions& options) {
  const double cutoff = options.preparation.longer.wavelength;
  const std::string prefix = std::isnan(cutoff) ? "P" : "R";
  const std::string axis = options.profiles == Axis1D::x ? "x" : "y";
  if ((axis == "x" ? sample.grid().shape.nx : sample.grid().shape.ny) < 2)
    throw DataError(sample.surface().variable,
                    "a profile along " + axis + " needs two points, but there is only one");
  const ProfileAverages averages = sample.profiles(options.profiles, std::isnan(cutoff) ? no_limit : cutoff);
  ParameterList out(sample.surface().units);
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto i = static_cast<Index>(k);
    if (i == profile_dq && sample.surface().units != "m") continue;
    const auto& [name, unit, meaning] = table[k];
    const std::string symbol = prefix + name;
    SequenceMean of = averages.of[k];
    if (constexpr double rounding = 1e-12; !(of.spread > rounding * (i == profile_sk ? 1 : of.mean))) {
      of.of_mean.error = of.of_spread.error = unknown;
      of.spread *= 0;
    }
    const std::string why = "no value: no profile has this parameter";
    std::string no_error = why_no_profile_error(of);
    const double step = sample.surface().step, spacing = axis == "x" ? sample.grid().dx : sample.grid().dy;
    // Of heights rounded to steps s, (2) of stats/profile/profile.hpp squared is larger by 0.098 s²/Δ².
    if (const std::string steps = steps_in_slopes(step, 0.098 * std::pow(step / spacing / of.mean, 2));
        i == profile_dq && !steps.empty())
      of.of_mean.error = of.of_spread.error = unknown, no_error = "no standard error: " + steps;
    const double least = i == profile_sk ? -no_limit : i == profile_ku ? 1 : 0;
    out.add(symbol, unit, meaning, with_error(of.mean, of.of_mean, least),
            {.why = why, .why_no_error = no_error});
    out.add(symbol + "_spread", unit, "standard deviation of {} over the profiles", spread_of(of),
            {.meaning = symbol, .why = why, .why_no_error = no_error});
  }
  out.add("profiles", "1", "number of profiles along {}", {averages.profiles}, {.meaning = axis});
  out.add("profiles_eff", "1", "effective number of independent profiles", {averages.independent},
          {.why_no_error = sample.basis().estimated
                               ? "no standard error: it rests on lags at which noise hides the correlation"
                               : ""});
  return std::move(out).all();
}

}  // namespace asperity
