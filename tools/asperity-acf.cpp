// The autocorrelation of a surface, its target, and its lengths.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/measure/acf_estimate.hpp"
#include "stats/sample/moments.hpp"
#include "stats/spatial/acf.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/quantity.hpp"
#include "tools/measure/acf_result.hpp"
#include "tools/measure/field_options.hpp"

using namespace asperity;

namespace {

struct Options {
  bool absolute = false, biased = false, tapered = false;
  std::vector<std::string> further = {};  ///< of --add
  Shape max_lag;
  std::string levels = "0.1,1/e", direction;
  cli::ResultOption result{{"profiles", "lengths"}};

  bool adds(const std::string& name) const { return std::ranges::find(further, name) != further.end(); }
  void check(cli::Tool& tool) const {
    result.check(tool);
    if (adds("acf_quantiles") && !result.dataset())
      throw cli::UsageError("add", "acf_quantiles needs --result dataset");
    if (adds("acf_error") && !result.dataset())
      throw cli::UsageError("add", "acf_error needs --result dataset");
    if (adds("structure_function") && result.result == "lengths")
      throw cli::UsageError("add", "structure_function needs --result dataset or --result profiles");
    if (tapered && (biased || !result.dataset() || adds("acf_error")))
      throw cli::UsageError("taper",
                            "gives the table that twins are drawn with, without errors: needs --result "
                            "dataset, and goes without --biased and --add acf_error");
    for (const char* option : {"levels", "direction"})
      if (tool.given(std::string("--") + option) && result.result == "profiles")
        throw cli::UsageError(option, "needs --result dataset or --result lengths");
    if (absolute && result.result == "lengths")
      throw cli::UsageError("absolute", "needs --result dataset or --result profiles");
  }
};

// ---- lengths ----

AcfLevel level_of(const std::string& word) {
  if (word == "1/e") return {1 / std::numbers::e, "e", "1/e"};
  const double value = to_number<double>(word).value_or(NAN), percent = std::round(1e12 * value) / 1e10;
  if (!(value > 0 && value < 1))
    throw cli::UsageError("levels", "'" + word + "' is not 1/e or a number between 0 and 1");
  return {value, shortest(percent), shortest(percent) + " %"};
}

std::vector<AcfLevel> levels_of(const std::string& list) {
  std::vector<AcfLevel> out;
  for (const std::string& word : cli::split(list, ',')) {
    const AcfLevel level = level_of(word);
    if (std::ranges::find(out, level.tag, &AcfLevel::tag) != out.end())
      throw cli::UsageError("levels", "'" + word + "' is given twice");
    out.push_back(level);
  }
  return out;
}

// What the lengths found, of one surface or the means of several, have to be doubted for.
void warn_of_lengths(const cli::Tool& tool, const Options& what, const Parameters& lengths, const Grid& grid,
                     const AcfEstimate* estimate = nullptr) {
  // Holes such as a checkerboard's leave no pair of neighbours.
  if (estimate != nullptr && estimate->rho.within({1, 1}).half_plane().isNaN().any()) {
    tool.warn(
        "no two neighbouring points are both measured: the ACF at lag 1 is unknown, and so are lengths");
    return warn_of_few(tool, estimate->size);
  }
  for (const AcfLevel& level : levels_of(what.levels))
    if (std::ranges::find(lengths, "gamma_" + level.tag, &Parameter::name) == lengths.end())
      tool.warn("in some direction the ACF does not fall to " + level.text +
                " within the lags; increase --max-lag");
  if (estimate != nullptr && !what.tapered) warn_of_few(tool, estimate->size);
  for (const Parameter& row : lengths)
    if (row.name.starts_with("length_") && !cli::warn_of_length(tool, row.name, row.value, grid)) break;
}

std::optional<double> direction_of(const Options& what) {
  return what.direction.empty() ? std::nullopt : std::optional(cli::parse_angle("direction", what.direction));
}

Parameters lengths_of(const cli::AcfResult& result, const Options& what) {
  return acf_lengths(result.estimate, levels_of(what.levels), direction_of(what), result.target,
                     result.lengths);
}

PooledOptions pooled_lengths(const Options& what) {
  return {.of_acf = [levels = levels_of(what.levels), direction = direction_of(what)](const LagField& rho,
                                                                                      const Grid& grid) {
    return acf_lengths(rho, grid, levels, direction);
  }};
}

// ---- the ACF ----

cli::AcfResult estimate(const cli::Tool& tool, const Options& what, const Surface& surface) {
  const Shape longest = what.tapered ? longest_lags(surface.grid) : default_max_lag(surface.grid),
              max_lag = tool.given("--max-lag") ? what.max_lag : longest;
  const int threads = tool.thread_count();
  cli::AcfResult out = what.tapered
                           ? cli::tapered_acf(surface, max_lag, threads)
                           : cli::AcfResult{AcfEstimate::of(
                                 surface, {.max_lag = max_lag, .biased = what.biased, .threads = threads})};
  if (what.result.dataset()) out.moments = moments(surface.heights, "heights");
  auto errors = [&](bool along_x) {
    return profile_errors(out.estimate, surface.heights, along_x, what.absolute, threads);
  };
  if (what.result.result == "profiles") out.profiles = {errors(true), errors(false)};
  if (what.result.result == "lengths" && out.estimate.size.gives_errors())
    out.lengths.emplace(out.estimate, surface.heights,
                        std::ranges::min(levels_of(what.levels), {}, &AcfLevel::value).value, threads);
  if (what.adds("structure_function"))
    out.structure = structure_function(surface.heights, surface.grid, max_lag, threads);
  if (what.adds("acf_quantiles")) out.quantiles = cli::quantiles_of(surface.heights);
  if (what.adds("acf_error")) out.errors = acf_errors(out.estimate, surface.heights, what.absolute, threads);
  return out;
}

cli::AcfResult measured(const cli::Tool& tool, const Options& what, const Surface& surface,
                        const Dataset& data) {
  cli::AcfResult out = estimate(tool, what, surface);
  if (surface.variable == "heights") out.target = cli::carried_correlation(data, "acf_target", surface.grid);
  return out;
}

// What one of several adds to their pool. The window of a tapered surface takes more than a mean does:
// nothing is put back.
void set_sums(cli::AcfResult& result, const Options& what, const Surface& surface, int threads) {
  const Moments of_heights = moments(surface.heights, surface.variable);
  const double least = std::ranges::min(levels_of(what.levels), {}, &AcfLevel::value).value;
  const double taken = what.tapered ? 0 : taken_from(surface, result.estimate, of_heights, threads);
  result.sums.emplace(of_heights, surface.grid, taken).set_acf(result.estimate, least);
  result.area = measured_area(surface.heights, surface.grid);
}

cli::AcfContent content(const Surface& surface, const Options& what) {
  return {surface.variable, surface.units, what.absolute, what.tapered ? cli::taper_of(surface.grid) : ""};
}

// One surface: its dataset or lengths, with errors by theory.
void measure_one(cli::Tool& tool, const cli::FieldOptions& field, const Options& what, Dataset data) {
  const Surface surface = field.read(tool, data);
  const cli::AcfResult result = measured(tool, what, surface, data);
  const Parameters lengths = lengths_of(result, what);
  warn_of_lengths(tool, what, lengths, surface.grid, &result.estimate);
  cli::warn_of_taper(tool, surface, result);
  if (!what.result.dataset()) return cli::print(tool, lengths);
  const cli::Inventory before(data);
  add_acf(data, result, lengths, content(surface, what));
  before.tell(tool, data, "acf");
  tool.write(data);
}

// Of the lengths that all surfaces have.
Parameters mean_lengths(const std::vector<EnsembleParameter>& lengths, int surfaces) {
  Parameters out;
  for (const EnsembleParameter& length : lengths)
    if (length.surfaces == surfaces)
      out.push_back({length.name, length.mean, length.unit, length.standard_error, ""});
  return out;
}

// Several: pooled.
void measure_several(cli::Tool& tool, const cli::FieldOptions& field, const Options& what,
                     cli::EnsembleInput& surfaces, const cli::Several& several) {
  if (what.adds("acf_quantiles"))
    throw cli::UsageError("add", "acf_quantiles are those of one surface, but INPUT names several");
  struct One {
    cli::AcfResult result;
    Parameters lengths;
    cli::AcfContent content;
  };
  std::optional<cli::AcfEnsemble> mean;
  surfaces.for_each(
      tool,
      [&](const cli::EnsembleMember& member) {
        const Surface surface = field.read(tool, member.data);
        cli::AcfResult result = measured(tool, what, surface, member.data);
        set_sums(result, what, surface, tool.thread_count());
        Parameters lengths = lengths_of(result, what);
        return One{std::move(result), std::move(lengths), content(surface, what)};
      },
      [&](const One& one, const std::string&) {
        if (!mean) mean.emplace(one.content, pooled_lengths(what));
        mean->add(one.result, one.lengths, what.result.dataset());
      },
      several);
  const std::vector<EnsembleParameter> lengths = mean->lengths();
  warn_of_lengths(tool, what, mean_lengths(lengths, mean->surfaces()), mean->grid());
  if (what.tapered)
    tool.note(
        "twins of the mean of several surfaces have Gaussian heights, unless asperity-generate --marginal "
        "says otherwise");
  cli::warn_of_lays(tool, lengths);
  cli::tell_weights(tool, mean->weights());
  cli::tell_interval(tool, mean->surfaces(), PooledMaps::most_degrees);
  if (!what.result.dataset()) return cli::print(tool, cli::ensemble_table(lengths));
  Dataset data = mean->dataset();
  tool.write(data);
}

// Of one surface with errors by theory, of several pooled.
int print_profiles(const cli::Tool& tool, const cli::FieldOptions& field, const Options& what,
                   cli::EnsembleInput& surfaces, const cli::Several& several) {
  struct One {
    cli::AcfResult result;
    cli::Table table;
  };
  cli::EnsembleTable mean([](const cli::Table&) {
    return cli::EnsembleTable::Content{
        .keys = {"direction", "lag"}, .value = "acf", .others = {"structure_function"}, .means = {"target"}};
  });
  cli::PooledAcf pooled;
  AreaWeights weights;
  const bool alone = surfaces.resolve(tool) == 1;
  const int code = surfaces.for_each(
      tool,
      [&](const cli::EnsembleMember& member) {
        const Surface surface = field.read(tool, member.data);
        cli::AcfResult result = measured(tool, what, surface, member.data);
        if (alone) warn_of_few(tool, result.estimate.size);
        if (!alone) set_sums(result, what, surface, tool.thread_count());
        cli::Table table = acf_profiles(result, content(surface, what));
        return One{std::move(result), std::move(table)};
      },
      [&](const One& one, const std::string& name) {
        if (alone) return cli::print(tool, one.table);
        const double weight = weights.of(one.result.area, one.result.enough());
        mean.add(one.table, name, weight), pooled.add(one.result, weight);
      },
      several);
  cli::tell_weights(tool, weights);
  if (!alone)
    mean.print(tool, cli::profiles_of(pooled.values(what.absolute)),
               (weights.give_errors() ? 1.0 : unknown) * cli::profiles_of(pooled.errors(what.absolute)));
  return code;
}

int measure(cli::Tool& tool, const cli::FieldOptions& field, Options& what, cli::EnsembleInput& surfaces) {
  what.check(tool);
  const std::string& result = what.result.result;
  const bool lengths = result == "lengths", own_lags = !tool.given("--max-lag");
  const cli::Several several{
      .variable = field.variable,
      .of_sizes = "each surface counts by its measured area",
      .of_spacings =
          lengths
              ? "correlations are pooled at the coarsest spacing and the lags that all have, by measured area"
              : "",
      .on_one_grid = !lengths && own_lags ? "the mean at each lag, unless --max-lag gives the lags," : ""};
  if (result == "profiles") return print_profiles(tool, field, what, surfaces, several);
  if (surfaces.resolve(tool) == 1)
    measure_one(tool, field, what, surfaces.only(tool));
  else
    measure_several(tool, field, what, surfaces, several);
  return cli::done;
}

// ---- the command line ----

void declare_estimate(cli::Tool& tool, Options& what) {
  tool.counts("--max-lag", what.max_lag, 0, "Longest lags in x and y, in samples. Default: half the field",
              "Estimate");
  tool.flag("--biased", what.biased, "Divide by all points instead of the overlapping pairs", "Estimate");
  tool.flag(
      "--taper", what.tapered,
      "Weight the heights with Tukey's window. The table that asperity-generate --acf draws twins with, and "
      "the "
      "distribution of the heights. The window is a raised cosine over a fifth of the side at each end. The "
      "table is "
      "positive definite and has no cusp at lag zero, so that twins have the slopes and summits of the "
      "surface. The "
      "outer part of the surface counts less, and a correlation at a tenth of a side comes out 7 % smaller. "
      "All "
      "lags by default; fewer are cut off smoothly. Not for --biased or errors",
      "Estimate");
  tool.flag("--absolute", what.absolute,
            "R in units squared instead of R / R(0,0); the target is scaled alike", "Estimate");
  tool.words("--add", what.further, {"structure_function", "acf_error", "acf_quantiles"},
             "Add structure_function, acf_error or acf_quantiles. structure_function: mean square difference "
             "of two points a lag apart, in the dataset and the profiles; acf_error: standard errors of acf, "
             "in the dataset (that of several surfaces has them), in memory of some thirty times the lags; "
             "acf_quantiles: distribution of the heights "
             "for asperity-generate --marginal measured, in the dataset",
             "Result");
  tool.text("--levels", what.levels, "LEVEL,...", "Levels of R / R(0,0) at which lengths are measured",
            "Lengths");
  cli::direction_option(tool, what.direction, "Lengths");
}

void declare(cli::Tool& tool, Options& what) {
  what.result.declare(
      tool,
      "Write the dataset, or print profiles or lengths. dataset: with the ACF added; profiles: "
      "R(p,0) and R(0,q) with standard errors; lengths: with intervals, and the ellipticity");
  declare_estimate(tool, what);
  tool.table();
  tool.output();
  tool.threads();
  tool.essential({"--result", "--variable", "--remove-form", "--lambda-s", "--lambda-c", "--levels",
                  "--direction", "--max-lag", "--taper", "--add", "--json", "--output"});
  tool.example(
      "asperity-generate --shape 128x128 --size 3mm --rq 0.4um --length 17px,4px | asperity-acf --result "
      "lengths");
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-acf",
      "Measures the autocorrelation function (ACF) of a surface and adds it to the dataset: acf over lag_x "
      ">= 0 and lag_y of both signs, as asperity-kernel --acf - reads it. Attributes hold its R(0,0) "
      "(acf_variance), the skewness and kurtosis of the heights (acf_skewness, acf_kurtosis), and the "
      "lengths at which it first falls to 10 % and 1/e or to --levels (acf_length_10_x and so on). --result "
      "lengths prints these lengths; --result profiles prints the two profiles, one row per lag, with "
      "standard errors and the target if the dataset has one (acf_target). Several surfaces are pooled: each "
      "result is that of their common ACF, with what means or forms took put back, its standard error, the "
      "spread between the surfaces, and the spread expected from their errors. A 95 % interval is Student's "
      "t "
      "of surfaces - 1 degrees of freedom, 39 at most, times the standard error on either side. The dataset "
      "then holds acf, acf_error and the attributes, but no heights.");
  cli::EnsembleInput inputs;
  cli::FieldOptions options;
  Options what;
  inputs.declare(tool);
  options.declare(tool);
  declare(tool, what);

  return tool.run(argc, argv, [&] { return measure(tool, options, what, inputs); });
}
