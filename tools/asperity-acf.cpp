// The autocorrelation of a surface beside the one asked for, and its lengths.
#include <cmath>
#include <limits>
#include <numbers>

#include "cli/table.hpp"
#include "measured.hpp"
#include "stats/acf_error.hpp"
#include "stats/acf_length.hpp"

using namespace asperity;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct Options {
  bool absolute = false, biased = false, lengths = false, profiles = false, dataset = false;
  Shape max_lag;
};

/// The estimate, normalised, and its errors.
struct Estimate {
  LagField rho;
  AcfError error;
  double variance;  ///< R(0,0)
  bool biased;

  static Estimate of(const cli::Measured& measured, const AcfParameters& parameters) {
    const LagField acf = estimate_autocorrelation(measured.heights, measured.grid, parameters);
    const LagField known = measured.drawn ? *measured.drawn : significant_lags(acf, measured.grid);
    return {acf.normalised(), AcfError(known, measured.grid), acf(0, 0), parameters.biased};
  }
  double standard_error(const Grid& grid, Index p, Index q, bool absolute) const {
    return (biased ? overlap(grid, p, q) : 1) * (absolute ? error.absolute(p, q) : error.normalised(p, q));
  }
};

// ---- the two profiles ----

void add_profile(cli::Table& table, const cli::Measured& measured, const Estimate& estimate, bool absolute,
                 bool x) {
  const Index lags = x ? estimate.rho.max_p() : estimate.rho.max_q();
  const double spacing = x ? measured.grid.dx : measured.grid.dy, scale = absolute ? estimate.variance : 1;
  for (Index lag = 0; lag <= lags; ++lag) {
    const Index p = x ? lag : 0, q = x ? 0 : lag;
    std::vector<cli::Cell> row{x ? "x" : "y", static_cast<double>(lag) * spacing, scale * estimate.rho(p, q),
                               scale * estimate.standard_error(measured.grid, p, q, absolute)};
    if (measured.target) row.push_back(scale * (*measured.target)(p, q));
    table.rows.push_back(std::move(row));
  }
}

cli::Table profiles(const cli::Measured& measured, const Estimate& estimate, bool absolute) {
  const std::string unit = absolute ? measured.units_to(2) : "1";
  cli::Table table{{{"direction", ""}, {"lag", "m"}, {"acf", unit}, {"standard_error", unit}}, {}};
  if (measured.target) table.columns.push_back({"target", unit});
  for (const bool x : {true, false}) add_profile(table, measured, estimate, absolute, x);
  return table;
}

// ---- lengths ----

struct Level {
  double value;
  std::string tag, text;
};
const Level levels[] = {{0.1, "10", "10 %"}, {1 / std::numbers::e, "e", "1/e"}};

/// Along x and y, then their ratio; only those that the lags reach.
struct Lengths {
  std::optional<Crossing> x, y;

  Lengths(const LagField& rho, double level)
      : x(first_crossing(rho.along_x(), level)), y(first_crossing(rho.along_y(), level)) {}
  bool complete() const { return x && y; }
};

using Errors = std::array<double, 2>;

Errors errors_of(const Lengths& lengths, const Estimate& estimate, const Grid& grid) {
  Errors out{unknown, unknown};
  if (const auto& c = lengths.x)
    out[0] = estimate.standard_error(grid, std::lround(c->lag), 0, false) / -c->slope;
  if (const auto& c = lengths.y)
    out[1] = estimate.standard_error(grid, 0, std::lround(c->lag), false) / -c->slope;
  return out;
}

void add_lengths(cli::Quantities& out, const std::string& of, const Level& level, const Lengths& lengths,
                 const Errors& errors, const Grid& grid) {
  const std::string name = of + "length_" + level.tag, where = "where the ACF has fallen to " + level.text;
  if (lengths.x) out.rows.push_back({name + "_x", lengths.x->lag * grid.dx, "m", errors[0] * grid.dx, where});
  if (lengths.y) out.rows.push_back({name + "_y", lengths.y->lag * grid.dy, "m", errors[1] * grid.dy, where});
  if (!lengths.complete()) return;
  const double ratio = lengths.x->lag * grid.dx / (lengths.y->lag * grid.dy);
  const double error = ratio * std::hypot(errors[0] / lengths.x->lag, errors[1] / lengths.y->lag);
  out.rows.push_back(
      {of + "gamma_" + level.tag, ratio, "1", error, "ellipticity, length in x over length in y"});
}

cli::Quantities lengths_of(const cli::Tool& tool, const cli::Measured& measured, const Estimate& estimate) {
  cli::Quantities out;
  for (const Level& level : levels) {
    const Lengths lengths(estimate.rho, level.value);
    if (!lengths.complete())
      tool.warn("the ACF stays above " + level.text + " up to the longest lag; see --max-lag");
    add_lengths(out, "", level, lengths, errors_of(lengths, estimate, measured.grid), measured.grid);
    if (measured.target)
      add_lengths(out, "target_", level, Lengths(*measured.target, level.value), {unknown, unknown},
                  measured.grid);
  }
  return out;
}

// ---- the dataset ----

// What an earlier run measured.
void forget_acf(Dataset& data) {
  data.erase("acf");
  std::vector<std::string> stale;
  for (const Attribute& a : data.attributes)
    if (a.name.starts_with("acf_")) stale.push_back(a.name);
  for (const std::string& name : stale) data.attributes.erase(name);
}

void add_to(Dataset& data, const cli::Measured& measured, const Estimate& estimate,
            const cli::Quantities& lengths, bool absolute) {
  forget_acf(data);
  const Grid& grid = measured.grid;
  const double scale = absolute ? estimate.variance : 1;
  const std::string units = absolute ? measured.units_to(2) : "1";
  set_table(data, "acf", scale * estimate.rho.half_plane(), {"lag_x", 0, grid.dx, "m", "lag in x"},
            {"lag_y", -estimate.rho.max_q(), grid.dy, "m", "lag in y"},
            {units, "autocorrelation estimated from the field"});
  // In m2; of a field that is no height there is none.
  if (measured.units == "m") data.attributes.set("acf_variance", estimate.variance);
  for (const auto& row : lengths.rows) data.attributes.set("acf_" + row.name, row.value);
}

// ---- the command line ----

void declare(cli::Tool& tool, Options& what) {
  tool.counts("--max-lag", what.max_lag, 0, "Longest lags, in samples; half the field unless given",
              "Estimate");
  tool.flag("--biased", what.biased, "Divide by all points instead of the overlapping pairs", "Estimate");
  tool.flag("--absolute", what.absolute,
            "R in units squared instead of R / R(0,0); the target is scaled alike", "Estimate");
  CLI::Option* lengths =
      tool.flag("--lengths", what.lengths, "Print the lengths and the ellipticity", "Result");
  CLI::Option* profiles =
      tool.flag("--profiles", what.profiles,
                "Print the two profiles R(p,0) and R(0,q); so do --json alone and a terminal", "Result")
          ->excludes(lengths);
  tool.flag("--dataset", what.dataset, "Write the dataset with the ACF added, as into a pipe or a file",
            "Result")
      ->excludes(lengths)
      ->excludes(profiles);
  tool.input();
  tool.table();
  tool.output();
  tool.threads();
  tool.example(
      "asperity-generate --shape 128x128 --size 3mm --rq 0.4um --length 17px,4px | asperity-acf --lengths");
  tool.accuracy(
      "The estimate is that of the direct sum over pairs to round-off. Standard errors are Bartlett's for a "
      "Gaussian "
      "field; those of neighbouring lags are strongly correlated. The subtracted mean lowers all lags by its "
      "own "
      "variance, R(0,0) / N_eff_mean (asperity-stats). Lengths are interpolated in ln R, exact for an "
      "exponential.");
}

// A dataset is binary: on a terminal, and as JSON, the profiles stand for it.
bool prints_profiles(const cli::Tool& tool, const Options& what) {
  if (what.dataset && tool.json())
    throw cli::UsageError("json", "prints profiles or lengths, and does not go together with --dataset");
  return what.profiles || tool.json() || (!what.dataset && tool.output_is_terminal());
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-acf",
      "The autocorrelation of a surface. Passes the dataset on with the whole ACF over lag_x >= 0 and lag_y "
      "of both "
      "signs, as asperity-kernel --acf - reads it, its R(0,0) as the attribute acf_variance, and the lengths "
      "at which "
      "it first falls to 10 % and to 1/e as acf_length_10_x and so on. Or prints these lengths; or, as on a "
      "terminal, "
      "the two profiles with standard errors, a row a lag, beside the target where the dataset carries one "
      "(acf_target).");
  cli::MeasuredOptions options;
  Options what;
  options.declare(tool);
  declare(tool, what);

  return tool.run(argc, argv, [&] {
    Dataset data = tool.read();
    const cli::Measured measured = cli::measure(data, options, tool.thread_count());
    const Shape max_lag = tool.given("--max-lag") ? what.max_lag : default_max_lag(measured.grid);
    const Estimate estimate =
        Estimate::of(measured, {.max_lag = max_lag, .biased = what.biased, .threads = tool.thread_count()});

    if (what.lengths) {
      tool.write_text(render(lengths_of(tool, measured, estimate), tool.json(), tool.output_is_terminal()));
    } else if (prints_profiles(tool, what)) {
      tool.write_text(
          render(profiles(measured, estimate, what.absolute), tool.json(), tool.output_is_terminal()));
    } else {
      add_to(data, measured, estimate, lengths_of(tool, measured, estimate), what.absolute);
      tool.write(data);
    }
    return cli::done;
  });
}
