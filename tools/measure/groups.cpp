#include "tools/measure/groups.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "stats/spatial/acf_length.hpp"
#include "stats/spectrum/spectrum.hpp"
#include "stats/uncertainty/acf_error.hpp"
#include "stats/uncertainty/length_interval.hpp"
#include "stats/uncertainty/moment_interval.hpp"
#include "tools/cli/quantity.hpp"
#include "tools/cli/series.hpp"
#include "tools/measure/rows.hpp"

namespace asperity::cli {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double least_profiles = 5;  // independent ones, with which errors can be told
constexpr std::array group_names{"height", "gaussianity", "material", "hybrid", "spatial", "all"};

std::vector<double> shares(const std::string& option, const std::string& list) {
  std::vector<double> out;
  for (const std::string& word : split(list, ',')) {
    double value = unknown;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !(value >= 0 && value <= 1))
      throw UsageError(option, "value \"" + word + "\" is not a number from 0 to 1");
    if (std::ranges::find(out, value) != out.end())
      throw UsageError(option, "value \"" + word + "\" is given twice");
    out.push_back(value);
  }
  return out;
}

// Errors that too few independent points cannot tell.
Rows told(Rows rows, const std::string& untold) {
  if (untold.empty()) return rows;
  for (Quantities::Row& row : rows)
    if (!std::isnan(row.standard_error)) row.standard_error = unknown, row.why = untold;
  return rows;
}

// How the level in a direction strays: SE[ρ]/|dρ/dr|.
double length_error(const LagField& rho, const Grid& grid, const AcfError& error, const Reach& reach,
                    double level) {
  const auto crossing = first_crossing(rho, grid, reach.angle, level);
  if (!crossing) return unknown;
  const auto [p, q] = nearest_lag(grid, reach.angle, reach.length);
  return error.normalised(p, q) / -crossing->slope;
}

void add_lobe(Rows& out, const CentralLobe& lobe, const LagField& rho, const Grid& grid,
              const AcfError& error, const LengthIntervals& intervals, const StatsOptions& options) {
  const std::string level = shortest(options.acf_level);
  double relative = 0;
  auto length = [&](const Reach& reach) {
    const double e = length_error(rho, grid, error, reach, options.acf_level);
    relative = std::hypot(relative, e / reach.length);
    return e;
  };
  if (lobe.r_min) {
    out.push_back({"Sal", lobe.r_min->length, "m", length(*lobe.r_min),
                   "autocorrelation length, of the fastest decay to " + level,
                   intervals.r_min(options.acf_level)});
    out.push_back({"Sal_direction", lobe.r_min->angle, "rad", unknown, "of that decay, from +x towards +y"});
  }
  if (lobe.r_max) {
    out.push_back({"slowest_decay", lobe.r_max->length, "m", length(*lobe.r_max),
                   "length of the slowest decay to " + level, intervals.r_max(options.acf_level)});
    out.push_back({"slowest_direction", lobe.r_max->angle, "rad", unknown, "of that decay, the lay"});
  }
  if (const auto ratio = lobe.aspect_ratio())
    out.push_back({"Str", *ratio, "1", *ratio * relative, "texture aspect ratio, fastest over slowest decay",
                   Interval::of_ratio(*ratio, half_width_95 * relative, 1)});
  if (lobe.ellipse) {
    out.push_back({"gamma", lobe.ellipse->gamma(), "1", unknown,
                   "ellipticity of the ACF's contour at " + level + ", long axis over short"});
    out.push_back({"gamma_direction", lobe.ellipse->major.angle, "rad", unknown, "of its long axis"});
  }
}

constexpr std::array<std::array<const char*, 2>, profile_parameters_count> profile_names{
    {{"a", "arithmetic mean height"},
     {"q", "root mean square height"},
     {"sk", "skewness, 0 for a Gaussian"},
     {"ku", "kurtosis, 3 for a Gaussian"},
     {"p", "peak height, mean over the sections"},
     {"v", "valley depth, mean over the sections"},
     {"z", "maximum height, mean over the sections"},
     {"t", "total height of the profile"},
     {"dq", "root mean square slope, by seven points"},
     {"Sm", "mean spacing of profile elements"}}};

std::string profile_unit(int parameter, const std::string& of_heights) {
  if (parameter == profile_sm) return "m";
  const bool pure = parameter == profile_sk || parameter == profile_ku || parameter == profile_dq;
  return pure ? "1" : of_heights;
}

}  // namespace

// ---- the command line ----

void StatsOptions::declare(Tool& tool) {
  tool.text(
      "--parameters", groups, "GROUP,...",
      "height (Sa, Sq, Ssk, Sku, Sp, Sv, Sz and effective sample sizes), gaussianity (the tests of "
      "Jarque-Bera, Kolmogorov-Smirnov, Anderson-Darling and Pearson, with p-values that allow for the "
      "correlation and naive ones that do not), material (Sk, Spk, Svk, Smr1, Smr2, Vmp, Vmc, Vvc, Vvv), "
      "hybrid (Sdq, Sdr, spectral moments, summits), spatial (Sal, Str, Std, ellipticity), or all; only what "
      "is asked for is computed",
      "Parameters");
  tool.choice(
      "--profile", profile, {"x", "y"},
      "Profile parameters of ISO 21920-2 in place of these, Pa, Pq, Psk, Pku, Pp, Pv, Pz, Pt, Pdq, PSm, "
      "or Ra and so on after --lambda-c, averaged over all profiles along x or y; each with its spread "
      "over them",
      "Parameters");
  tool.text("--quantiles", quantiles, "P,...",
            "Heights below which these shares of the surface lie, 0.5 the median", "Parameters");
  tool.numbers_pair("--material-ratio", material_ratios,
                    "Shares p,q that bound the core in Vmp, Vmc, Vvc, Vvv, and of Smc_p, Smc_q",
                    "Parameters");
  tool.number("--acf-level", acf_level, "Level of R / R(0,0) to which Sal and Str are measured",
              "Parameters");
  tool.memory(
      "Largest memory for the field. A file of more than an eighth of it is read in strips, above any "
      "--level, for all but spatial and the filters, which need the whole field and are refused if the bound "
      "was given. The order of the heights takes 25 MB more. Errors then rest on the correlation within the "
      "strips, where the dataset carries none");
  tool.text("--direction", direction, "ANGLE",
            "Spectral moments in this direction too, from +x towards +y: 30deg", "Parameters");
}

void StatsOptions::check(const Tool& tool) const {
  auto belongs = [&](const std::string& option, const char* group) {
    if (tool.given("--" + option) && !asks_for(group))
      throw UsageError(option, std::string("belongs to --parameters ") + group + ", which is not asked for");
  };
  for (const char* areal : {"parameters", "quantiles", "material-ratio", "acf-level", "direction"})
    if (!profile.empty() && tool.given(std::string("--") + areal))
      throw UsageError(areal, "is of the surface, and does not go together with --profile");
  belongs("material-ratio", "material");
  belongs("acf-level", "spatial");
  belongs("direction", "hybrid");
  if (!direction.empty()) parse_angle("direction", direction);
}

std::string StatsOptions::needs_whole_field(const Tool& tool) const {
  if (asks_for("spatial")) return "--parameters spatial";
  for (const char* filter : {"--lambda-s", "--lambda-c"})
    if (tool.given(filter)) return filter;
  return "";
}

bool StatsOptions::asks_for(const std::string& group) const {
  bool asked = false;
  const std::vector<std::string> words = split(groups, ',');
  for (const std::string& word : words) {
    if (std::ranges::find(group_names, word) == group_names.end())
      throw UsageError("parameters",
                       "value \"" + word + "\" is not height, gaussianity, material, hybrid, spatial or all");
    if (std::ranges::count(words, word) > 1)
      throw UsageError("parameters", "value \"" + word + "\" is given twice");
    asked = asked || word == group || word == "all";
  }
  return asked;
}

bool StatsOptions::asks_for_nothing_else(const std::string& group) const {
  return groups == group && quantiles.empty();
}

// ---- groups ----

// Of Gaussian heights, or of those that the field was drawn with or evidently has.
struct MomentAccuracy {
  MomentErrors error;
  MomentIntervals interval;

  explicit MomentAccuracy(Sample& sample)
      : error(standard_errors(sample.moments(), sample.size())),
        interval(confidence_intervals(sample.moments(), sample.size())) {
    std::optional<Translation> heights = sample.measured().distribution;
    if (!heights) heights = evident_translation(sample.moments(), error);
    if (!heights) return;
    const TranslationErrors errors(*heights, sample.size_below(CorrelationMap(*heights)));
    error = errors.standard_errors(sample.moments().sq);
    interval = confidence_intervals(sample.moments(), errors, sample.size());
  }
};

Rows height_rows(Sample& sample) {
  const Moments& m = sample.moments();
  const EffectiveSampleSize& size = sample.size();
  const auto [error, interval] = MomentAccuracy(sample);
  const double level = sample.measured().level;
  const std::string& unit = sample.units();
  auto worth = [&](int k) { return std::isfinite(size.effective(k)) ? size.effective(k) : unknown; };
  Rows out{
      {"mean", level, unit, error.mean, "mean, subtracted from the heights below",
       Interval::about(level, (interval.mean.high - interval.mean.low) / 2)},
      {"Sa", m.sa, unit, error.sa, "arithmetic mean height", interval.sa},
      {"Sq", m.sq, unit, error.sq, "root mean square height", interval.sq},
      {"Ssk", m.ssk, "1", error.ssk, "skewness, 0 for a Gaussian", interval.ssk},
      {"Sku", m.sku, "1", error.sku, "kurtosis, 3 for a Gaussian", interval.sku},
      {"Sp", m.sp, unit, unknown, "highest peak of the whole field"},
      {"Sv", m.sv, unit, unknown, "deepest valley of the whole field"},
      {"Sz", m.sz(), unit, unknown, "maximum height Sp + Sv"},
      {"N", size.points(), "1", unknown, "points"},
      {"N_eff_mean", worth(1), "1", unknown, "independent points with the same error of the mean"},
      {"N_eff", worth(2), "1", unknown, "independent points with the same error of Sq"},
      {"N_eff_Ssk", worth(3), "1", unknown, "independent points with the same error of Ssk"},
      {"N_eff_Sku", worth(4), "1", unknown, "independent points with the same error of Sku"},
  };
  explain(out, out.size() - 4,
          "the correlation that was found sums to zero, and no number of points has that error");
  if (!sample.pairs().complete())
    out.push_back({"N_missing", static_cast<double>(sample.grid().shape.cells()) - size.points(), "1",
                   unknown, "missing points, left out of everything"});
  return told(std::move(out), untold(size));
}

Rows quantile_rows(Sample& sample, const StatsOptions& options) {
  const std::vector<double> asked = shares("quantiles", options.quantiles), heights = sample.quantiles(asked);
  Rows out;
  for (std::size_t i = 0; i < asked.size(); ++i)
    out.push_back({"quantile_" + shortest(asked[i]), heights[i], sample.units(),
                   material_height_error(1 - asked[i], sample.moments(), sample.size()),
                   "height below which this share of the surface lies"});
  return told(std::move(out), untold(sample.size()));
}

Rows gaussianity_rows(Sample& sample) {
  constexpr std::array symbols{"JB", "KS", "A2", "chi2"};
  const auto fits = sample.goodness_of_fit();
  const bool told = sample.size().tells_errors();
  Rows out;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const std::string symbol = symbols[i], test(fits[i].test);
    out.push_back({symbol, fits[i].statistic, "1", unknown, test + ", statistic"});
    out.push_back({symbol + "_p", told ? fits[i].p : unknown, "1", unknown,
                   test + ", p of a Gaussian field so correlated"});
    explain(out, out.size() - 1, untold(sample.size()));
    out.push_back({symbol + "_naive_p", fits[i].naive_p, "1", unknown,
                   test + ", p if heights were independent, for comparison"});
  }
  return out;
}

Rows material_rows(Sample& sample, const StatsOptions& options) {
  const MaterialRatioCurve curve = sample.material_ratio();
  const auto [p, q] = options.material_ratios;
  const VolumeParameters volume = curve.volumes(p, q);
  const CoreParameters core = curve.core();
  const std::string &unit = sample.units(), from = " at " + shortest(p), to = " at " + shortest(q);
  auto error = [&](double ratio) { return material_height_error(ratio, sample.moments(), sample.size()); };
  Rows out{
      {"Sk", core.sk, unit, unknown, "core height"},
      {"Spk", core.spk, unit, unknown, "reduced peak height"},
      {"Svk", core.svk, unit, unknown, "reduced dale height"},
      {"Smr1", core.smr1, "1", unknown, "material ratio where the core begins"},
      {"Smr2", core.smr2, "1", unknown, "material ratio where the core ends"},
      {"Smc_p", curve.height(p), unit, error(p), "inverse material ratio" + from},
      {"Smc_q", curve.height(q), unit, error(q), "inverse material ratio" + to},
      {"Vmp", volume.vmp, unit, unknown, "peak material volume per area"},
      {"Vmc", volume.vmc, unit, unknown, "core material volume per area"},
      {"Vvc", volume.vvc, unit, unknown, "core void volume per area"},
      {"Vvv", volume.vvv, unit, unknown, "dale void volume per area"},
  };
  return told(std::move(out), untold(sample.size()));
}

Rows profile_rows(Sample& sample, const StatsOptions& options, double section) {
  const bool filtered = !std::isnan(section), heights = sample.units() == "m";
  const Shape shape = sample.grid().shape;
  if ((options.profile == "x" ? shape.nx : shape.ny) < 2)
    throw DataError(sample.variable(),
                    "a profile along " + options.profile + " needs two points, and there is one");
  const ProfileAverages averages =
      sample.profiles(options.profile == "x" ? Axis1D::x : Axis1D::y, filtered ? section : unlimited);
  const bool few = averages.independent < least_profiles;
  const std::string why =
      "not told: profiles_eff = " + rounded(averages.independent) + " is below " + shortest(least_profiles);
  Rows out;
  for (int k = 0; k < profile_parameters_count; ++k) {
    if (k == profile_dq && !heights) continue;
    const auto [name, meaning] = profile_names[static_cast<std::size_t>(k)];
    const std::string symbol = (filtered ? "R" : "P") + std::string(name),
                      unit = profile_unit(k, sample.units());
    const double error = averages.standard_error[k];
    out.push_back({symbol, averages.mean[k], unit, few ? unknown : error, meaning, {}, few ? why : ""});
    explain(out, out.size() - 1, "no profile has one");
    out.push_back({symbol + "_spread", averages.spread[k], unit, unknown,
                   "standard deviation of " + symbol + " over the profiles"});
  }
  out.push_back({"profiles", averages.profiles, "1", unknown, "profiles along " + options.profile});
  out.push_back(
      {"profiles_eff", averages.independent, "1", unknown, "independent profiles with the same error"});
  return out;
}

Rows spatial_rows(const Tool& tool, WholeSample& sample, const StatsOptions& options) {
  const Grid& grid = sample.grid();
  const LagField rho = sample.acf().normalised();
  const AcfError error(
      sample.measured().drawn ? *sample.measured().drawn : significant_lags(sample.acf(), sample.pairs()),
      sample.pairs());
  const CentralLobe lobe = central_lobe(rho, grid, options.acf_level);
  if (!lobe.r_max)
    tool.warn("no lag within half the field has an ACF of " + shortest(options.acf_level) +
              " or less in some direction: Str has no value");
  if (lobe.r_min) warn_of_length(tool, "Sal", lobe.r_min->length, grid);
  Rows out;
  add_lobe(out, lobe, rho, grid, error, {sample.acf(), sample.pairs(), sample.measured().drawn}, options);
  const TextureDirection texture = texture_direction(
      power_spectrum(sample.heights(), grid, default_windows(grid), sample.threads()), grid);
  const std::size_t first = out.size();
  out.push_back({"Std", texture.angle, "rad", unknown,
                 "texture direction: most power runs this way, the lay across it"});
  out.push_back({"Std_contrast", texture.contrast, "1", unknown,
                 "power in that direction over its mean, 1 for no texture"});
  explain(out, first, "no value: the field has too few wave numbers in all directions");
  return told(std::move(out), untold(sample.size()));
}

std::string missing(const Rows& rows) {
  const auto valued = std::ranges::find_if(rows, [](const auto& row) { return std::isfinite(row.value); });
  return rows.empty() || valued != rows.end() ? "" : rows.front().why;
}

}  // namespace asperity::cli
