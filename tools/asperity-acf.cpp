// The autocorrelation of a surface beside the one asked for, and its lengths.
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
  bool absolute = false, biased = false, structure = false, lengths = false, profiles = false,
       dataset = false, quantiles = false;
  Shape max_lag;
  std::string levels = "0.1,1/e", direction;
};

/// What goes out: the ACF, and the structure function where it was asked for.
struct Result {
  AcfEstimate estimate;
  std::optional<LagField> target = {};     ///< the correlation asked for, normalised
  std::optional<LagField> structure = {};  ///< in units squared
  std::optional<MeasuredHeights> quantiles = {};
};

// ---- lengths ----

AcfLevel level_of(const std::string& word) {
  if (word == "1/e") return {1 / std::numbers::e, "e", "1/e"};
  const double value = to_number<double>(word).value_or(NAN), percent = std::round(1e12 * value) / 1e10;
  if (!(value > 0 && value < 1))
    throw cli::UsageError("levels", "value \"" + word + "\" is neither a number between 0 and 1 nor 1/e");
  return {value, shortest(percent), shortest(percent) + " %"};
}

std::vector<AcfLevel> levels_of(const std::string& list) {
  std::vector<AcfLevel> out;
  for (const std::string& word : cli::split(list, ',')) {
    const AcfLevel level = level_of(word);
    if (std::ranges::find(out, level.tag, &AcfLevel::tag) != out.end())
      throw cli::UsageError("levels", "value \"" + word + "\" is given twice");
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
      tool.warn("no lag has an ACF of " + level.text + " or less in some direction; see --max-lag");
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
  // In m2; of a field that is no height there is none.
  if (surface.units == "m") data.attributes.set("acf_variance", estimate.variance);
  cli::check_finite(lengths);
  for (const Parameter& length : lengths) data.attributes.set("acf_" + length.name, length.value);
}

Result estimate(const Surface& surface, const Options& what, Shape max_lag, int threads) {
  Result out{AcfEstimate::of(surface, {.max_lag = max_lag, .biased = what.biased, .threads = threads})};
  if (what.structure) out.structure = structure_function(surface.heights, surface.grid, max_lag, threads);
  if (what.quantiles) out.quantiles = quantiles_of(surface.heights);
  return out;
}

// ---- the command line ----

void declare_estimate(cli::Tool& tool, Options& what) {
  tool.counts("--max-lag", what.max_lag, 0, "Longest lags, in samples; half the field unless given",
              "Estimate");
  tool.flag("--biased", what.biased, "Divide by all points instead of the overlapping pairs", "Estimate");
  tool.flag("--absolute", what.absolute,
            "R in units squared instead of R / R(0,0); the target is scaled alike", "Estimate");
  tool.flag("--structure", what.structure,
            "Add the structure function, the mean square difference of two points a lag apart, to the "
            "profiles and the dataset",
            "Estimate");
  tool.text("--levels", what.levels, "LEVEL,...", "Levels of R / R(0,0) at which lengths are measured",
            "Lengths");
  tool.text("--direction", what.direction, "ANGLE",
            "Lengths in this direction too, from +x towards +y: 30deg", "Lengths");
}

void declare(cli::Tool& tool, Options& what) {
  declare_estimate(tool, what);
  const cli::Option quantiles = tool.flag(
      "--quantiles", what.quantiles,
      "Add the distribution of the heights to the dataset, for asperity-generate --marginal measured",
      "Estimate");
  const cli::Option lengths =
      tool.flag("--lengths", what.lengths, "Print the lengths and the ellipticity", "Result")
          .excludes(quantiles);
  const cli::Option profiles =
      tool.flag("--profiles", what.profiles,
                "Print the two profiles R(p,0) and R(0,q); so do --json alone and a terminal", "Result")
          .excludes(lengths)
          .excludes(quantiles);
  tool.flag("--dataset", what.dataset, "Write the dataset with the ACF added, as into a pipe or a file",
            "Result")
      .excludes(lengths)
      .excludes(profiles);
  tool.input();
  tool.table();
  tool.output();
  tool.threads();
  tool.example(
      "asperity-generate --shape 128x128 --size 3mm --rq 0.4um --length 17px,4px | asperity-acf --lengths");
  tool.accuracy(
      "The estimate is that of the direct sum over pairs to round-off. Standard errors are Bartlett's for a "
      "Gaussian field; those of neighbouring lags are strongly correlated. The subtracted mean lowers all "
      "lags by its own variance, R(0,0) / N_eff_mean (asperity-stats). Lengths are interpolated in ln R, "
      "exact for an exponential. With missing points pairs are counted of which both are there; a lag "
      "without any is not a number.");
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-acf",
      "The autocorrelation of a surface. Passes the dataset on with the whole ACF over lag_x >= 0 and lag_y "
      "of both signs, as asperity-kernel --acf - reads it, its R(0,0) as the attribute acf_variance, "
      "skewness and kurtosis of the heights as acf_skewness and acf_kurtosis, and the lengths at which it "
      "first falls to 10 % and to 1/e, or other levels, as acf_length_10_x and so on. Or prints these "
      "lengths; or, as on a terminal, the two profiles with standard errors, a row a lag, beside the target "
      "where the dataset carries one (acf_target).");
  cli::FieldOptions options;
  Options what;
  options.declare(tool);
  declare(tool, what);

  return tool.run(argc, argv, [&] {
    const bool dataset =
        cli::writes_dataset(tool, what.lengths || what.profiles, what.dataset, "profiles or lengths");
    Dataset data = tool.read();
    const Surface surface = options.read(tool, data);
    const Shape max_lag = tool.given("--max-lag") ? what.max_lag : default_max_lag(surface.grid);
    Result result = estimate(surface, what, max_lag, tool.thread_count());
    if (options.variable == "heights")
      result.target = cli::carried_correlation(data, "acf_target", surface.grid);
    if (dataset) {
      const cli::Inventory before(data);
      add_to(data, surface, result, lengths_of(tool, result, what), options.variable, what.absolute);
      before.tell(tool, data, "acf");
      tool.write(data);
    } else if (what.lengths) {
      cli::print(tool, lengths_of(tool, result, what));
    } else {
      warn_of_few(tool, result.estimate.size);
      cli::print(tool, profiles(surface, result, what.absolute));
    }
    return cli::done;
  });
}
