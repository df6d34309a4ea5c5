// The autocorrelation of a surface beside its target, and its lengths.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/error.hpp"
#include "core/words.hpp"
#include "dataset/layout.hpp"
#include "stats/measure/acf_estimate.hpp"
#include "stats/sample/moments.hpp"
#include "stats/spatial/acf.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/quantity.hpp"
#include "tools/cli/table.hpp"
#include "tools/measure/field_options.hpp"
#include "tools/surface/marginal_dataset.hpp"

using namespace asperity;

namespace {

struct Options {
  bool absolute = false, biased = false;
  std::vector<std::string> further = {};  ///< of --add
  Shape max_lag;
  std::string levels = "0.1,1/e", direction;
  cli::ResultOption result{{"profiles", "lengths"}};

  bool adds(const std::string& name) const { return std::ranges::find(further, name) != further.end(); }
  void check(cli::Tool& tool) const {
    result.check(tool);
    if (adds("acf_quantiles") && !result.dataset())
      throw cli::UsageError("add", "acf_quantiles needs --result dataset");
    if (adds("structure_function") && result.result == "lengths")
      throw cli::UsageError("add", "structure_function needs --result dataset or --result profiles");
    for (const char* option : {"levels", "direction"})
      if (tool.given(std::string("--") + option) && result.result == "profiles")
        throw cli::UsageError(option, "needs --result dataset or --result lengths");
    if (absolute && result.result == "lengths")
      throw cli::UsageError("absolute", "needs --result dataset or --result profiles");
  }
};

/// The ACF, and what --add names.
struct Result {
  AcfEstimate estimate;
  std::optional<LagField> target = {};     ///< normalised
  std::optional<LagField> structure = {};  ///< in units squared
  std::optional<MeasuredHeights> quantiles = {};
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

Parameters lengths_of(const cli::Tool& tool, const Result& result, const Options& what) {
  std::optional<double> direction;
  if (!what.direction.empty()) direction = cli::parse_angle("direction", what.direction);
  const std::vector<AcfLevel> levels = levels_of(what.levels);
  const Parameters out = acf_lengths(result.estimate, levels, direction, result.target);
  for (const AcfLevel& level : levels)
    if (std::ranges::find(out, "gamma_" + level.tag, &Parameter::name) == out.end())
      tool.warn("in some direction the ACF does not fall to " + level.text +
                " within the lags; increase --max-lag");
  warn_of_few(tool, result.estimate.size);
  const Grid& grid = result.estimate.basis.pairs.grid();
  for (const Parameter& row : out)
    if (row.name.starts_with("length_") && !cli::warn_of_length(tool, row.name, row.value, grid)) break;
  return out;
}

// ---- the two profiles ----

void add_profile(cli::Table& table, const Surface& surface, const Result& result, bool absolute, bool x) {
  const AcfEstimate& estimate = result.estimate;
  const Index lags = x ? estimate.rho.max_p() : estimate.rho.max_q();
  const double spacing = x ? surface.grid.dx : surface.grid.dy, scale = absolute ? estimate.variance : 1;
  for (Index lag = 0; lag <= lags; ++lag) {
    const Index p = x ? lag : 0, q = x ? 0 : lag;
    const double value = scale * estimate.rho(p, q), error = scale * estimate.standard_error(p, q, absolute);
    const Interval ends = Interval::about(value, half_width_95 * error);
    std::vector<cli::Cell> row{x ? "x" : "y", static_cast<double>(lag) * spacing, value, error, ends.low,
                               ends.high};
    if (result.target) row.push_back(scale * (*result.target)(p, q));
    if (result.structure) row.push_back((*result.structure)(p, q));
    table.rows.push_back(std::move(row));
  }
}

cli::Table profiles(const Surface& surface, const Result& result, bool absolute) {
  const std::string unit = absolute ? cli::unit_to(surface.units, 2) : "1";
  cli::Table table{{{"direction", ""},
                    {"lag", "m"},
                    {"acf", unit, cli::Holds::unknown},
                    {"standard_error", unit, cli::Holds::unknown},
                    {"low_95", unit, cli::Holds::open},
                    {"high_95", unit, cli::Holds::open}},
                   {}};
  if (result.target) table.columns.push_back({"target", unit, cli::Holds::unknown});
  if (result.structure)
    table.columns.push_back({"structure_function", cli::unit_to(surface.units, 2), cli::Holds::unknown});
  for (const bool x : {true, false}) add_profile(table, surface, result, absolute, x);
  return table;
}

// ---- the dataset ----

MeasuredHeights quantiles_of(const Field& heights) {
  std::vector<double> sample(heights.data(), heights.data() + heights.size());
  std::erase_if(sample, [](double z) { return std::isnan(z); });
  return MeasuredHeights::of(std::move(sample));
}

void add_to(Dataset& data, const Surface& surface, const Result& result, const Parameters& lengths,
            const std::string& variable, bool absolute) {
  cli::drop_results(data, "acf", variable);
  data.attributes.set("acf_variable", variable);
  const Grid& grid = surface.grid;
  const AcfEstimate& estimate = result.estimate;
  const double scale = absolute ? estimate.variance : 1;
  const std::string units = absolute ? cli::unit_to(surface.units, 2) : "1";
  const Axis lag_x{"lag_x", 0, grid.dx, "m", "lag in x"},
      lag_y{"lag_y", -estimate.rho.max_q(), grid.dy, "m", "lag in y"};
  set_table(data, "acf", scale * estimate.rho.half_plane(), lag_x, lag_y,
            {units, "autocorrelation estimated from the field"}, Missing::not_a_number);
  if (result.structure)
    set_table(data, "structure_function", result.structure->half_plane(), lag_x, lag_y,
              {cli::unit_to(surface.units, 2), "mean square difference of two points a lag apart"},
              Missing::not_a_number);
  const Moments height = moments(surface.heights);
  data.attributes.set("acf_skewness", height.ssk);
  data.attributes.set("acf_kurtosis", height.sku);
  if (result.quantiles) cli::set_quantiles(data, "acf_quantiles", *result.quantiles);
  // In m2: of heights only.
  if (surface.units == "m") data.attributes.set("acf_variance", estimate.variance);
  cli::check_finite(lengths);
  for (const Parameter& length : lengths) data.attributes.set("acf_" + length.name, length.value);
}

Result estimate(const Surface& surface, const Options& what, Shape max_lag, int threads) {
  Result out{AcfEstimate::of(surface, {.max_lag = max_lag, .biased = what.biased, .threads = threads})};
  if (what.adds("structure_function"))
    out.structure = structure_function(surface.heights, surface.grid, max_lag, threads);
  if (what.adds("acf_quantiles")) out.quantiles = quantiles_of(surface.heights);
  return out;
}

// ---- the command line ----

void declare_estimate(cli::Tool& tool, Options& what) {
  tool.counts("--max-lag", what.max_lag, 0, "Longest lags in x and y, in samples. Default: half the field",
              "Estimate");
  tool.flag("--biased", what.biased, "Divide by all points instead of the overlapping pairs", "Estimate");
  tool.flag("--absolute", what.absolute,
            "R in units squared instead of R / R(0,0); the target is scaled alike", "Estimate");
  tool.words("--add", what.further, {"structure_function", "acf_quantiles"},
             "Add structure_function or acf_quantiles. structure_function: mean square difference of two "
             "points a lag apart, in the dataset and the profiles; acf_quantiles: distribution of the "
             "heights for asperity-generate --marginal measured, in the dataset",
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
  tool.input();
  tool.table();
  tool.output();
  tool.threads();
  tool.essential({"--result", "--variable", "--remove-form", "--lambda-s", "--lambda-c", "--levels",
                  "--direction", "--max-lag", "--biased", "--add", "--json", "--output"});
  tool.example(
      "asperity-generate --shape 128x128 --size 3mm --rq 0.4um --length 17px,4px | asperity-acf --result "
      "lengths");
  tool.accuracy(
      "The estimate equals the direct sum over pairs to round-off. Standard errors are Bartlett's for a "
      "Gaussian field; the errors of neighbouring lags are strongly correlated. Subtracting the field's mean "
      "lowers all lags by the variance of that mean, R(0,0) / N_eff_mean (asperity-stats). Lengths are "
      "interpolated in ln R, which is exact for an exponential. With missing points only pairs of two "
      "measured points count; a lag without such a pair is NaN.");
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
      "standard errors and the target if the dataset has one (acf_target).");
  cli::FieldOptions options;
  Options what;
  options.declare(tool);
  declare(tool, what);

  return tool.run(argc, argv, [&] {
    what.check(tool);
    Dataset data = tool.read();
    const Surface surface = options.read(tool, data);
    const Shape max_lag = tool.given("--max-lag") ? what.max_lag : default_max_lag(surface.grid);
    Result result = estimate(surface, what, max_lag, tool.thread_count());
    if (options.variable == "heights")
      result.target = cli::carried_correlation(data, "acf_target", surface.grid);
    if (what.result.dataset()) {
      const cli::Inventory before(data);
      add_to(data, surface, result, lengths_of(tool, result, what), options.variable, what.absolute);
      before.tell(tool, data, "acf");
      tool.write(data);
    } else if (what.result.result == "lengths") {
      cli::print(tool, lengths_of(tool, result, what));
    } else {
      warn_of_few(tool, result.estimate.size);
      cli::print(tool, profiles(surface, result, what.absolute));
    }
    return cli::done;
  });
}
