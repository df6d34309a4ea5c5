// Means and spreads over the profiles along x or along y.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/filter/missing.hpp"
#include "stats/measure/groups.hpp"

namespace asperity {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

struct Definition1D {
  const char* symbol;
  std::string_view unit;
  const char* meaning;
  double least = 0, most = no_limit;
};

// In the order of ProfileParameters.
constexpr std::array<Definition1D, profile_parameters_count> table{
    {{"a", of_field, "arithmetic mean height"},
     {"q", of_field, "root mean square height"},
     {"sk", "1", "skewness, 0 for a Gaussian", -no_limit},
     {"ku", "1", "kurtosis, 3 for a Gaussian", 1},
     {"p", of_field, "peak height, mean over the section lengths"},
     {"v", of_field, "pit depth, mean over the section lengths"},
     {"z", of_field, "maximum height, mean over the section lengths"},
     {"t", of_field, "total height of the profile"},
     {"dq", "1", "root mean square slope, from seven points"},
     {"Sm", "m", "mean profile element spacing"},
     {"c", of_field, "mean profile element height"},
     {"k", of_field, "core height"},
     {"pk", of_field, "reduced peak height"},
     {"vk", of_field, "reduced pit depth"},
     {"mr1", "1", "material ratio where the core begins", 0, 1},
     {"mr2", "1", "material ratio where the core ends", 0, 1},
     {"pkx", of_field, "maximum peak height above the core"},
     {"vkx", of_field, "maximum pit depth below the core"},
     {"ak1", of_field, "area of the reduced peaks, mr1 pk / 2, per length"},
     {"ak2", of_field, "area of the reduced pits, (1 - mr2) vk / 2, per length"},
     {"mc_p", of_field, "inverse material ratio at {}", -no_limit},
     {"mc_q", of_field, "inverse material ratio at {}", -no_limit},
     {"dc", of_field, "height difference mc_p - mc_q"},
     {"5p", of_field, "mean height of the five highest peaks, pruned at 5 % of z"},
     {"5v", of_field, "mean depth of the five deepest pits, pruned at 5 % of z"},
     {"10z", of_field, "5p + 5v"}}};

// With Student's interval: of the logarithm, where the parameter is positive, `least` at least.
Estimate with_error(double value, const WaveError& of, double least, double most) {
  if (!std::isfinite(of.error)) return {value};
  if (least < 0) return {value, of.error, Interval::about(value, of.half_width())};
  const Interval ends = Interval::of_ratio(value, of.half_width() / value);
  return {value, of.error,
          Interval::of(value, std::max(ends.low, std::min(least, value)), std::min(ends.high, most))};
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

// The material ratio at a height above the mean of each profile.
SequenceMean ratio_of_profiles(const Sample& sample, Axis1D along, double c, double independent) {
  const Field& z = sample.surface().heights;
  const bool x = along == Axis1D::x;
  auto ratio = [&](Index i) {
    const Field profile = x ? Field(z.col(i)) : Field(z.row(i));
    const ValidSum sum = sum_of_valid(profile);
    return sum.count < 2 ? unknown : MaterialRatioCurve(profile).ratio(sum.sum / sum.count + c);
  };
  return sequence_mean(Eigen::ArrayXd::NullaryExpr(x ? z.cols() : z.rows(), ratio), independent,
                       x ? sample.grid().periodic.y : sample.grid().periodic.x);
}

// Those of a spread that is round-off have no error.
SequenceMean without_round_off(SequenceMean of, double scale) {
  if (constexpr double rounding = 1e-12; !(of.spread > rounding * scale)) {
    of.of_mean.error = of.of_spread.error = unknown;
    of.spread *= 0;
  }
  return of;
}

// The mean, and the spread.
void add_rows(ParameterList& out, const std::string& symbol, const Definition1D& row, const SequenceMean& of,
              Words words) {
  out.add(symbol, row.unit, row.meaning, with_error(of.mean, of.of_mean, row.least, row.most), words);
  words.meaning = symbol;
  out.add(symbol + "_spread", row.unit, "standard deviation of {} over the profiles", spread_of(of), words);
}

std::string axis_of(const Sample& sample, const MeasureOptions& options) {
  const bool x = options.profiles == Axis1D::x;
  const std::string axis = x ? "x" : "y";
  if ((x ? sample.grid().shape.nx : sample.grid().shape.ny) < 2)
    throw DataError(sample.surface().variable,
                    "a profile along " + axis + " needs two points, but there is only one");
  return axis;
}

}  // namespace

Parameters profile_averages(const Sample& sample, const MeasureOptions& options) {
  const double cutoff = options.preparation.longer.wavelength;
  const std::string prefix = std::isnan(cutoff) ? "P" : "R";
  const std::string axis = axis_of(sample, options);
  const ProfileAverages averages =
      sample.profiles(options.profiles, std::isnan(cutoff) ? no_limit : cutoff, options.material_ratios);
  ParameterList out(sample.surface().units);
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto i = static_cast<Index>(k);
    if (i == profile_dq && sample.surface().units != "m") continue;
    SequenceMean of = without_round_off(averages.of[k], i == profile_sk ? 1 : std::abs(averages.of[k].mean));
    const std::string why =
        i < profile_5p ? "no value: no profile has this parameter" : "no value: no profile has five of them";
    std::string no_error = why_no_profile_error(of);
    const double step = sample.surface().step, spacing = axis == "x" ? sample.grid().dx : sample.grid().dy;
    // Of heights rounded to steps s, (2) of stats/profile/profile.hpp squared is larger by 0.098 s²/Δ².
    if (const std::string steps = steps_in_slopes(step, 0.098 * std::pow(step / spacing / of.mean, 2));
        i == profile_dq && !steps.empty())
      of.of_mean.error = of.of_spread.error = unknown, no_error = "no standard error: " + steps;
    add_rows(out, prefix + table[k].symbol, table[k], of,
             {.meaning = shortest(options.material_ratios[i == profile_mc_q ? 1 : 0]),
              .why = why,
              .why_no_error = no_error});
  }
  for (const auto& [c, text] : options.material_heights) {
    const SequenceMean of = without_round_off(
        ratio_of_profiles(sample, options.profiles, c, averages.independent / averages.profiles), 1);
    add_rows(out, prefix + "mr_" + text, {"", "1", "material ratio at {} above the mean", 0, 1}, of,
             {.meaning = text,
              .why = "no value: no profile has this parameter",
              .why_no_error = why_no_profile_error(of)});
  }
  out.add("profiles", "1", "number of profiles along {}", {averages.profiles}, {.meaning = axis});
  out.add("profiles_eff", "1", "effective number of independent profiles", {averages.independent},
          {.why_no_error = sample.basis().estimated
                               ? "no standard error: it rests on lags at which noise hides the correlation"
                               : ""});
  return std::move(out).all();
}

}  // namespace asperity
