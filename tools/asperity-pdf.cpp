// The distribution of heights, compared with the Gaussian of the same mean and rms height.
#include <algorithm>
#include <cmath>
#include <variant>

#include "stats/height/distribution.hpp"
#include "stats/height/kernel_density.hpp"
#include "tools/cli/ensemble_table.hpp"
#include "tools/measure/field_options.hpp"
#include "tools/measure/height_tables.hpp"

using namespace asperity;

namespace {

constexpr int most_points = 1 << 20;  // as many as a side of a field may have

struct Options {
  std::string estimate = "histogram";
  int bins = 0, points = 0;
  double bandwidth = NAN;  // in Sq

  void declare(cli::Tool& tool) {
    const std::string group = "Estimate";
    tool.choice(
        "--estimate", estimate, {"histogram", "kernel", "quantiles"},
        "Estimate of the distribution. histogram: counts in bins; kernel: density by a Gaussian kernel; "
        "quantiles: heights and those of a Gaussian, for a Q-Q plot",
        group);
    const cli::Bounds rows(0, most_points, "more than the longest table has");
    tool.integer("--bins", bins, rows,
                 "Number of bins of equal width; 0: by Scott's rule, a width of 3.49 Sq / N^(1/3)", group);
    tool.number("--bandwidth", bandwidth,
                "Standard deviation of the kernel, in Sq. Default: Silverman's rule, 1.06 / N^(1/5)", group);
    tool.integer("--rows", points, rows, "Rows of the kernel's curve or of quantiles; 0: 256 and 99", group);
  }

  void check(const cli::Tool& tool) const {
    auto check_estimate = [&](const char* option, bool fits, const char* to) {
      if (tool.given(std::string("--") + option) && !fits)
        throw cli::UsageError(option, std::string("needs --estimate ") + to);
    };
    check_estimate("bins", estimate == "histogram", "histogram");
    check_estimate("bandwidth", estimate == "kernel", "kernel");
    check_estimate("rows", estimate != "histogram", "kernel or --estimate quantiles");
  }
};

// The values to count: a whole field, or a part of its cells, whose values are bounded and not Gaussian.
using Counted = std::variant<Surface, cli::CountedCells>;

// What bins and bandwidths follow from: the values of one surface or of several.
struct Values {
  HeightRange range = {INFINITY, -INFINITY};
  double points = 0, squares = 0;  // the sum of N Sq²

  static Values of(const Counted& counted) {
    const auto* part = std::get_if<cli::CountedCells>(&counted);
    const Field& field = part ? part->values : std::get<Surface>(counted).heights;
    const HeightRange own = height_range(field);
    const double n = static_cast<double>((!field.isNaN()).count()),
                 mean = field.isNaN().select(0, field).sum() / n;
    return {{part ? 0 : own.lowest, own.highest}, n, field.isNaN().select(0, field - mean).square().sum()};
  }
  void add(const Values& more) {
    range = {std::min(range.lowest, more.range.lowest), std::max(range.highest, more.range.highest)};
    points += more.points;
    squares += more.squares;
  }
  double sq() const { return std::sqrt(squares / points); }
  Moments moments() const { return {.sq = sq(), .sp = range.width()}; }
};

// In metres.
double bandwidth_for(const Options& what, const Values& of) {
  if (std::isnan(what.bandwidth)) return silverman_bandwidth(of.moments(), of.points);
  const double range = of.range.width() / of.sq(), least = least_bandwidth * range;
  const std::string given = "'" + cli::shortest(what.bandwidth) + "' is ";
  if (!(what.bandwidth >= least && std::isfinite(what.bandwidth)))
    throw cli::UsageError("bandwidth", given + "not finite or is below " + cli::shortest(least) +
                                           " Sq, 1e-5 of the range of heights");
  if (what.bandwidth > range)
    throw cli::UsageError("bandwidth", given + "above " + cli::shortest(range) +
                                           " Sq, the range of heights: only the kernel would show");
  return what.bandwidth * of.sq();
}

int bins_for(const Options& what, const Values& of) {
  if (what.bins > of.points)
    throw cli::UsageError("bins", "'" + std::to_string(what.bins) + "' is above the number of points, " +
                                      cli::shortest(of.points));
  if (what.bins) return what.bins;
  return of.squares > 0 ? scott_bins(of.moments(), of.points) : 1;
}

void check(const cli::Tool& tool, const cli::CountedCells& part, const Options& what) {
  for (const char* option : {"remove-form", "lambda-s", "lambda-c", "correlation"})
    if (tool.given(std::string("--") + option))
      throw cli::UsageError(option, "is for whole fields: leave it out, " + part.variable +
                                        " is counted as it is, on the cells that are " + part.which);
  if (what.estimate == "kernel")
    throw cli::UsageError("estimate", "'kernel' smooths " + part.variable +
                                          " beyond its bound at 0: use histogram or quantiles");
}

// What is counted of a surface, and how.
struct Counting {
  const cli::Tool& tool;
  const cli::FieldOptions& field;
  const Options& what;

  Counted read(const Dataset& data) const {
    if (const auto part = cli::counted_cells(data, field.variable)) {
      check(tool, *part, what);
      tool.note(part->words());
      return *part;
    }
    return field.read(tool, data);
  }
  /// On the range of `values`, those of all surfaces; of one `alone` that has heights in steps, on these.
  cli::Table table(const cli::CountedCells& part, const Values& values, bool) const {
    const cli::Part of(part, tool.thread_count());
    if (what.estimate == "histogram")
      return cli::histogram_of(of, bins_for(what, values), values.range.highest);
    return cli::quantiles_of(of, quantiles());
  }
  cli::Table table(const Surface& surface, const Values& values, bool alone) const {
    const Sample of(surface, tool.thread_count());
    warn_of_few(tool, of.size());
    if (what.estimate == "quantiles") return cli::quantiles_of(of, quantiles());
    if (what.estimate == "kernel")
      return cli::density_of(of, bandwidth_for(what, values), what.points ? what.points : 256, values.range);
    Bins bins{bins_for(what, values), values.range};
    const HeightSteps steps = what.bins || !alone ? HeightSteps{} : height_steps(surface.heights);
    if (steps.step > 0) bins = bins_on_steps(steps, bins);
    return cli::histogram_of(of, bins.number, bins.range);
  }
  int quantiles() const { return what.points ? what.points : 99; }
};

// What of these tables has a mean over several surfaces.
cli::EnsembleTable::Content content_of(const cli::Table& one) {
  const std::string &first = one.columns[0].name, &second = one.columns[1].name;
  if (first != "share")  // a histogram, or a curve
    return {.keys = {first},
            .value = "density",
            .error = second == "count" ? "density_error" : "standard_error",
            .means = {"gaussian_density", "count", "gaussian", "share"}};
  if (second != "normal_quantile") return {.keys = {first}, .value = second};  // of a part of the cells
  return {.keys = {first, second}, .value = "height", .means = {"gaussian_height"}};
}

// Of one surface on its own range; of several on the range of all, which is found first.
int print_distribution(const cli::Tool& tool, const cli::FieldOptions& field, const Options& what,
                       cli::EnsembleInput& surfaces) {
  what.check(tool);
  const Counting counting{tool, field, what};
  const bool alone = surfaces.resolve(tool) == 1, needs_range = what.estimate != "quantiles";
  Values all;
  if (!alone && needs_range)
    surfaces.for_each(
        tool, [&](const cli::EnsembleMember& member) { return Values::of(counting.read(member.data)); },
        [&](const Values& own, const std::string&) { all.add(own); });
  const std::string words = "each surface counts alike";
  const cli::Several several{.variable = field.variable, .of_sizes = words, .of_spacings = words};
  return cli::print_table(tool, surfaces, several, &content_of, [&](const cli::EnsembleMember& member) {
    const Counted counted = counting.read(member.data);
    const Values values = alone && needs_range ? Values::of(counted) : all;
    return std::visit([&](const auto& of) { return counting.table(of, values, alone); }, counted);
  });
}

void document(cli::Tool& tool) {
  tool.essential({"--estimate", "--bins", "--bandwidth", "--rows", "--variable", "--remove-form",
                  "--lambda-c", "--correlation", "--json", "--output", "--from"});
  tool.example(
      "asperity-generate --shape 128x128 --size 3mm --rq 0.4um --length 17px,4px | asperity-pdf --bins 40");
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-pdf",
      "Prints the distribution of the heights, compared with the Gaussian of the same mean and Sq, with "
      "standard errors and 95 % intervals. histogram: one row per bin with its centre, its count, the count "
      "expected for the Gaussian, the misfit (their difference divided by the standard error it has for "
      "Gaussian heights), and the same as densities. kernel: the density by a Gaussian kernel, and the "
      "Gaussian smoothed by that kernel. quantiles: heights and those of the Gaussian, which are a straight "
      "line over the normal quantile. Of a contact, the pressure is counted on the cells in contact and the "
      "gap on the open ones, without a Gaussian; share is that of all cells. For several surfaces, quantiles "
      "and densities are means over them, on bins or heights that all have in common, with the standard "
      "error by their spread, of surfaces - 1 degrees of freedom of Student's t, and the spread expected "
      "from "
      "the errors of the single surfaces.");
  cli::EnsembleInput inputs;
  cli::FieldOptions options;
  Options what;
  options.declare(tool);
  what.declare(tool);
  inputs.declare(tool);
  tool.table();
  tool.threads();
  document(tool);

  return tool.run(argc, argv, [&] { return print_distribution(tool, options, what, inputs); });
}
