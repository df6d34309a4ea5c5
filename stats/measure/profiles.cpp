// Means over the profiles along x or along y.
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/measure/groups.hpp"

namespace asperity {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double least_profiles = 5;  // independent ones, below which no errors are given

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

}  // namespace

Parameters profile_averages(const Sample& sample, const MeasureOptions& options) {
  const double cutoff = options.preparation.long_cutoff;
  const std::string prefix = std::isnan(cutoff) ? "P" : "R";
  const std::string axis = options.profiles == Axis1D::x ? "x" : "y";
  if ((axis == "x" ? sample.grid().shape.nx : sample.grid().shape.ny) < 2)
    throw DataError(sample.surface().variable,
                    "a profile along " + axis + " needs two points, but there is only one");
  const ProfileAverages averages = sample.profiles(options.profiles, std::isnan(cutoff) ? unlimited : cutoff);
  const bool few = averages.independent < least_profiles;
  const std::string why = "no standard error can be given: profiles_eff = " + rounded(averages.independent) +
                          " is below " + shortest(least_profiles);
  ParameterList out(sample.surface().units);
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto i = static_cast<Index>(k);
    if (i == profile_dq && sample.surface().units != "m") continue;
    const auto& [name, unit, meaning] = table[k];
    const std::string symbol = prefix + name;
    out.add(symbol, unit, meaning, {averages.mean[i], few ? unknown : averages.standard_error[i]},
            {.why = "no value: no profile has this parameter", .why_no_error = few ? why : ""});
    out.add(symbol + "_spread", unit, "standard deviation of {} over the profiles", {averages.spread[i]},
            {.meaning = symbol});
  }
  out.add("profiles", "1", "number of profiles along {}", {averages.profiles}, {.meaning = axis});
  out.add("profiles_eff", "1", "effective number of independent profiles", {averages.independent});
  return std::move(out).all();
}

}  // namespace asperity
