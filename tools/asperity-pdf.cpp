// The distribution of heights beside the Gaussian of the same mean and rms height.
#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "stats/height/distribution.hpp"
#include "stats/height/height_steps.hpp"
#include "stats/height/kernel_density.hpp"
#include "tools/cli/ensemble_input.hpp"
#include "tools/cli/ensemble_table.hpp"
#include "tools/cli/table.hpp"
#include "tools/cli/turns.hpp"
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
        "quantiles: heights beside those of a Gaussian, for a Q-Q plot",
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

// Of one surface on its own range; of several on the range of all, which is added up first, the mean of each
// row with an error by the spread between them.
class Distribution {
 public:
  Distribution(cli::Tool& tool, const cli::FieldOptions& field, const Options& what)
      : tool_(tool), field_(field), what_(what) {}

  bool needs_range() const { return what_.estimate != "quantiles"; }
  void add_range(const Dataset& data) {
    cli::in_turn([this, own = Values::of(read(data))] { values_.add(own); });
  }

  cli::Table table(const Dataset& data) {
    const Counted counted = read(data);
    alone_ = true;
    if (needs_range()) values_.add(Values::of(counted));
    return std::visit([&](const auto& of) { return table_of(of); }, counted);
  }
  void add(const cli::EnsembleMember& member) {
    cli::in_turn([this, name = member.name,
                  one = std::visit([&](const auto& of) { return table_of(of); }, read(member.data))] {
      if (!mean_) mean_.emplace(content_of(one));
      mean_->add(one, name);
    });
  }
  cli::Table mean() const { return mean_->table(); }

 private:
  Counted read(const Dataset& data) const {
    if (const auto part = cli::counted_cells(data, field_.variable)) {
      check(tool_, *part, what_);
      tool_.note(part->told());
      return *part;
    }
    return field_.read(tool_, data);
  }

  cli::Table table_of(const cli::CountedCells& part) const {
    const cli::Part of(part, tool_.thread_count());
    if (needs_range()) return cli::histogram_of(of, bins_for(what_, values_), values_.range.highest);
    return cli::quantiles_of(of, what_.points ? what_.points : 99);
  }
  cli::Table table_of(const Surface& surface) const {
    const Sample of(surface, false, tool_.thread_count());
    warn_of_few(tool_, of.size());
    if (what_.estimate == "kernel")
      return cli::density_of(of, bandwidth_for(what_, values_), what_.points ? what_.points : 256,
                             values_.range);
    if (what_.estimate == "histogram") {
      Bins bins{bins_for(what_, values_), values_.range};
      const HeightSteps steps = what_.bins || !alone_ ? HeightSteps{} : height_steps(surface.heights);
      if (steps.step > 0) bins = bins_on_steps(steps, bins);
      return cli::histogram_of(of, bins.number, bins.range);
    }
    return cli::quantiles_of(of, what_.points ? what_.points : 99);
  }

  static cli::EnsembleTable::Content content_of(const cli::Table& one) {
    const std::string &first = one.columns[0].name, &second = one.columns[1].name;
    if (first != "share")  // a histogram, or a curve
      return {.keys = {first},
              .value = "density",
              .error = second == "count" ? "density_error" : "standard_error",
              .means = {"gaussian_density", "count", "gaussian", "share"}};
    if (second != "normal_quantile") return {.keys = {first}, .value = second};  // of a part of the cells
    return {.keys = {first, second}, .value = "height", .means = {"gaussian_height"}};
  }

  cli::Tool& tool_;
  const cli::FieldOptions& field_;
  const Options& what_;
  Values values_ = {};
  bool alone_ = false;
  std::optional<cli::EnsembleTable> mean_ = {};
};

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
      "Prints the distribution of the heights beside the Gaussian of the same mean and Sq, with standard "
      "errors and 95 % intervals. histogram: one row per bin with its centre, its count, the count expected "
      "for the Gaussian, the misfit (their difference divided by the standard error it has for Gaussian "
      "heights), and the same as densities. kernel: the "
      "density by a Gaussian kernel beside the Gaussian smoothed by that kernel. quantiles: heights beside "
      "those of the Gaussian, which lie on a straight line against the normal quantile. Of a contact, the "
      "pressure is counted on the cells in contact and the gap on the open ones, beside no Gaussian; share "
      "is that of all cells. For several surfaces, quantiles and densities are means over them, on bins or "
      "heights that all have in common, with the standard error by their spread and the spread expected from "
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

  return tool.run(argc, argv, [&] {
    what.check(tool);
    Distribution distribution(tool, options, what);
    if (inputs.resolve(tool) == 1) {
      cli::print(tool, distribution.table(inputs.only(tool)));
      return cli::done;
    }
    using Member = cli::EnsembleMember;
    if (distribution.needs_range())
      inputs.for_each(tool, [&](Member&& member) { distribution.add_range(member.data); });
    inputs.for_each(tool, [&](Member&& member) { distribution.add(member); });
    cli::print(tool, distribution.mean());
    return cli::done;
  });
}
