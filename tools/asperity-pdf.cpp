// The distribution of heights beside the Gaussian of the same mean and rms height.
#include <cmath>
#include <optional>

#include "stats/height/distribution.hpp"
#include "stats/height/kernel_density.hpp"
#include "stats/height/material_ratio.hpp"
#include "tools/cli/ensemble_input.hpp"
#include "tools/cli/ensemble_table.hpp"
#include "tools/cli/table.hpp"
#include "tools/measure/field_options.hpp"
#include "tools/measure/part_tables.hpp"

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

// A field, and the errors of its distribution.
struct Heights {
  const Surface& surface;
  const Moments& m;
  const EffectiveSampleSize& size;

  // NaN where errors cannot be given.
  double known(double error) const { return size.gives_errors() ? error : NAN; }
  double misfit(double deviation, double error) const {
    const double scale = known(error);
    return scale > 0 || std::isnan(scale) ? deviation / scale : deviation;
  }
};

cli::Table table_of_bins(const Heights& of, int bins) {
  const std::string density = cli::unit_to(of.surface.units, -1);
  cli::Table out{{{"height", of.surface.units},
                  {"count", "1"},
                  {"standard_error", "1", cli::Holds::unknown},
                  {"gaussian", "1"},
                  {"misfit", "1", cli::Holds::unknown},
                  {"density", density},
                  {"density_error", density, cli::Holds::unknown},
                  {"gaussian_density", density}},
                 {}};
  for (const Bin& bin : histogram(of.surface.heights, of.m, of.size, bins)) {
    const double per_height = 1 / (of.size.points() * bin.width()), error = of.known(bin.count_error);
    out.rows.push_back({bin.centre(), bin.count, error, bin.expected,
                        of.misfit(bin.count - bin.expected, bin.misfit_error), bin.count * per_height,
                        error * per_height, bin.expected * per_height});
  }
  return out;
}

cli::Table table_of_density(const Heights& of, double bandwidth, int points) {
  const std::string density = cli::unit_to(of.surface.units, -1);
  cli::Table out{{{"height", of.surface.units},
                  {"density", density},
                  {"standard_error", density, cli::Holds::unknown},
                  {"gaussian_density", density},
                  {"misfit", "1", cli::Holds::unknown}},
                 {}};
  for (const DensityPoint& p : kernel_density(of.surface.heights, of.m, of.size, bandwidth, points))
    out.rows.push_back({p.height, p.density, of.known(p.density_error), p.gaussian,
                        of.misfit(p.density - p.gaussian, p.misfit_error)});
  return out;
}

cli::Table table_of_quantiles(const Heights& of, const MaterialRatioCurve& curve, int points) {
  const std::string& unit = of.surface.units;
  cli::Table out{{{"share", "1"},
                  {"normal_quantile", "1"},
                  {"height", unit},
                  {"standard_error", unit, cli::Holds::unknown},
                  {"gaussian_height", unit},
                  {"misfit", "1", cli::Holds::unknown}},
                 {}};
  for (const QuantilePoint& p : quantile_plot(curve, of.m, of.size, points))
    out.rows.push_back({p.share, p.normal, p.height, of.known(p.height_error), p.gaussian,
                        of.misfit(p.height - p.gaussian, p.misfit_error)});
  return out;
}

double bandwidth_for(const Options& what, const Moments& m, const EffectiveSampleSize& size) {
  if (std::isnan(what.bandwidth)) return silverman_bandwidth(m, size.points());
  const double least = least_bandwidth * m.sz() / m.sq;
  if (!(what.bandwidth >= least && std::isfinite(what.bandwidth)))
    throw cli::UsageError("bandwidth", "'" + cli::shortest(what.bandwidth) + "' is not finite or is below " +
                                           cli::shortest(least) + " Sq, 1e-5 of the range of heights");
  if (what.bandwidth * m.sq > m.sz())
    throw cli::UsageError("bandwidth", "'" + cli::shortest(what.bandwidth) + "' is above " +
                                           cli::shortest(m.sz() / m.sq) +
                                           " Sq, the range of heights: only the kernel would show");
  return what.bandwidth * m.sq;
}

cli::Table table_of(const Heights& of, const Options& what, int threads) {
  if (what.estimate == "kernel")
    return table_of_density(of, bandwidth_for(what, of.m, of.size), what.points ? what.points : 256);
  if (what.estimate == "quantiles")
    return table_of_quantiles(of, MaterialRatioCurve(of.surface.heights, threads),
                              what.points ? what.points : 99);
  const double points = of.size.points();
  if (what.bins > points)
    throw cli::UsageError("bins", "'" + std::to_string(what.bins) + "' is above the number of points, " +
                                      cli::shortest(points));
  return table_of_bins(of, what.bins ? what.bins : scott_bins(of.m, points));
}

// Of a part of the cells, whose values are bounded and not Gaussian.
cli::Table table_of(const cli::Tool& tool, const cli::CountedCells& part, const Options& what) {
  for (const char* option : {"remove-form", "lambda-s", "lambda-c", "correlation"})
    if (tool.given(std::string("--") + option))
      throw cli::UsageError(option, "is for whole fields: leave it out, " + part.variable +
                                        " is counted as it is, on the cells that are " + part.which);
  if (what.estimate == "kernel")
    throw cli::UsageError("estimate", "'kernel' smooths " + part.variable +
                                          " beyond its bound at 0: use histogram or quantiles");
  tool.note(part.told());
  return what.estimate == "quantiles"
             ? quantiles_of(part, what.points ? what.points : 99, tool.thread_count())
             : histogram_of(part, what.bins);
}

cli::Table distribution_of(const cli::Tool& tool, const cli::FieldOptions& options, const Options& what,
                           const Dataset& data) {
  if (const auto part = cli::counted_cells(data, options.variable)) return table_of(tool, *part, what);
  const Surface surface = options.read(tool, data);
  const Moments m = moments(surface.heights, options.variable);
  const EffectiveSampleSize size = error_basis(surface, tool.thread_count()).size();
  warn_of_few(tool, size);
  return table_of({surface, m, size}, what, tool.thread_count());
}

// Several surfaces: the mean of each quantile, with an error by the spread between them.
class Surfaces {
 public:
  Surfaces(cli::Tool& tool, const cli::FieldOptions& field, const Options& what)
      : tool_(tool), field_(field), what_(what) {}

  void add(const cli::EnsembleMember& member) {
    if (what_.estimate != "quantiles")
      throw cli::UsageError("estimate", "'" + what_.estimate +
                                            "' has a range of its own for each surface: over several, use "
                                            "--estimate quantiles");
    tool_.detail(member.name);
    const cli::Table one = distribution_of(tool_, field_, what_, member.data);
    if (!mean_) mean_.emplace(content_of(one));
    mean_->add(one, member.name);
  }
  void finish() const {
    if (mean_) cli::print(tool_, mean_->table());
  }

 private:
  static cli::EnsembleTable::Content content_of(const cli::Table& one) {
    const bool whole = one.columns[1].name == "normal_quantile";  // not a part of the cells
    if (whole) return {.keys = {"share", "normal_quantile"}, .value = "height", .means = {"gaussian_height"}};
    return {.keys = {"share"}, .value = one.columns[1].name};
  }

  cli::Tool& tool_;
  const cli::FieldOptions& field_;
  const Options& what_;
  std::optional<cli::EnsembleTable> mean_ = {};
};

void document(cli::Tool& tool) {
  tool.essential({"--estimate", "--bins", "--bandwidth", "--rows", "--variable", "--remove-form",
                  "--lambda-s", "--lambda-c", "--correlation", "--json", "--output", "--from"});
  tool.example(
      "asperity-generate --shape 128x128 --size 3mm --rq 0.4um --length 17px,4px | asperity-pdf --bins 40");
  tool.accuracy(
      "Counts and quantiles are exact, the kernel sum to 2e-14. Standard errors hold for a Gaussian field "
      "and allow for the correlation of the heights; errors of neighbouring rows are correlated. For a "
      "Gaussian surface 95 % of the misfits lie within 2, except in bins of a few counts and for the "
      "outermost quantiles. Errors of a pressure and a gap come from the counts of 16 or 64 blocks of the "
      "field, whatever the distribution, and hold for correlations below an eighth of its side: of 80 "
      "contacts, 89 to 98 % have the quartiles "
      "of the pressure within 1.96 errors. The gap varies 1.1 to 1.6 times as much from surface to surface "
      "as its errors tell, because the displacement under all contacts moves it together.");
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-pdf",
      "Prints the distribution of the heights beside the Gaussian of the same mean and Sq, with standard "
      "errors. histogram: one row per bin with its centre, its count, the count expected for the Gaussian, "
      "the misfit (their difference divided by its standard error), and the same as densities. kernel: the "
      "density by a Gaussian kernel beside the Gaussian smoothed by that kernel. quantiles: heights beside "
      "those of the Gaussian, which lie on a straight line against the normal quantile. Of a contact, the "
      "pressure is counted on the cells in contact and the gap on the open ones, beside no Gaussian; share "
      "is that of all cells. For several surfaces, quantiles are the means over them, with the standard "
      "error by their spread and the spread expected from the errors of the single surfaces.");
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
    Surfaces surfaces(tool, options, what);
    inputs.for_each(tool, [&](cli::EnsembleMember&& member) {
      member.alone() ? cli::print(tool, distribution_of(tool, options, what, member.data))
                     : surfaces.add(member);
    });
    surfaces.finish();
    return cli::done;
  });
}
