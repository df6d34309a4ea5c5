// The distribution of heights beside the Gaussian of the same mean and rms height.
#include <cmath>

#include "stats/height/distribution.hpp"
#include "stats/height/kernel_density.hpp"
#include "stats/height/material_ratio.hpp"
#include "tools/cli/table.hpp"
#include "tools/measure/field_options.hpp"

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
        "Counts in bins; the density by a Gaussian kernel; or quantiles beside those of a Gaussian, the data "
        "of a Q-Q plot",
        group);
    const cli::Bounds rows(0, most_points, "as many rows as the longest table has");
    tool.integer("--bins", bins, rows,
                 "Bins of equal width over the range; 0: Scott's rule, 3.49 Sq / N^(1/3)", group);
    tool.number("--bandwidth", bandwidth,
                "Standard deviation of the kernel, in Sq; absent: Silverman's rule, 1.06 / N^(1/5)", group);
    tool.integer("--points", points, rows, "Of the kernel's curve, or quantiles; 0: 256 and 99", group);
  }

  void check(const cli::Tool& tool) const {
    auto belongs = [&](const char* option, bool fits, const char* to) {
      if (tool.given(std::string("--") + option) && !fits)
        throw cli::UsageError(option, std::string("belongs to --estimate ") + to);
    };
    belongs("bins", estimate == "histogram", "histogram");
    belongs("bandwidth", estimate == "kernel", "kernel");
    belongs("points", estimate != "histogram", "kernel or quantiles");
  }
};

double told(double error, const EffectiveSampleSize& size) { return size.tells_errors() ? error : NAN; }

// Not a number where no error is told.
double in_errors(double deviation, double untold, const EffectiveSampleSize& size) {
  const double error = told(untold, size);
  return error > 0 || std::isnan(error) ? deviation / error : deviation;
}

cli::Table table_of_bins(const Surface& surface, const Moments& m, const EffectiveSampleSize& size,
                         int asked) {
  if (asked > size.points())
    throw cli::UsageError("bins", "value " + std::to_string(asked) + " is above the number of points, " +
                                      cli::shortest(size.points()));
  const std::string density = cli::unit_to(surface.units, -1);
  cli::Table out{{{"height", surface.units},
                  {"count", "1"},
                  {"standard_error", "1", cli::Holds::unknown},
                  {"gaussian", "1"},
                  {"misfit", "1", cli::Holds::unknown},
                  {"density", density},
                  {"density_error", density, cli::Holds::unknown},
                  {"gaussian_density", density}},
                 {}};
  for (const Bin& bin : histogram(surface.heights, m, size, asked ? asked : scott_bins(m, size.points()))) {
    const double per_height = 1 / (size.points() * bin.width()), error = told(bin.count_error, size);
    out.rows.push_back({bin.centre(), bin.count, error, bin.expected,
                        in_errors(bin.count - bin.expected, bin.misfit_error, size), bin.count * per_height,
                        error * per_height, bin.expected * per_height});
  }
  return out;
}

cli::Table table_of_density(const std::vector<DensityPoint>& curve, const Surface& surface,
                            const EffectiveSampleSize& size) {
  const std::string density = cli::unit_to(surface.units, -1);
  cli::Table out{{{"height", surface.units},
                  {"density", density},
                  {"standard_error", density, cli::Holds::unknown},
                  {"gaussian_density", density},
                  {"misfit", "1", cli::Holds::unknown}},
                 {}};
  for (const DensityPoint& p : curve)
    out.rows.push_back({p.height, p.density, told(p.density_error, size), p.gaussian,
                        in_errors(p.density - p.gaussian, p.misfit_error, size)});
  return out;
}

cli::Table table_of_quantiles(const std::vector<QuantilePoint>& points, const Surface& surface,
                              const EffectiveSampleSize& size) {
  const std::string& unit = surface.units;
  cli::Table out{{{"share", "1"},
                  {"normal_quantile", "1"},
                  {"height", unit},
                  {"standard_error", unit, cli::Holds::unknown},
                  {"gaussian_height", unit},
                  {"misfit", "1", cli::Holds::unknown}},
                 {}};
  for (const QuantilePoint& p : points)
    out.rows.push_back({p.share, p.normal, p.height, told(p.height_error, size), p.gaussian,
                        in_errors(p.height - p.gaussian, p.misfit_error, size)});
  return out;
}

double bandwidth_for(const Options& what, const Moments& m, const EffectiveSampleSize& size) {
  if (std::isnan(what.bandwidth)) return silverman_bandwidth(m, size.points());
  const double least = least_bandwidth * m.sz() / m.sq;
  const std::string value = "value " + shortest(what.bandwidth);
  if (!(what.bandwidth >= least && std::isfinite(what.bandwidth)))
    throw cli::UsageError("bandwidth", value + " is not finite or below " + shortest(least) +
                                           " Sq, 1e-5 of the range of heights");
  if (what.bandwidth * m.sq > m.sz())
    throw cli::UsageError("bandwidth", value + " is above " + shortest(m.sz() / m.sq) +
                                           " Sq, the range of heights: nothing but the kernel would show");
  return what.bandwidth * m.sq;
}

cli::Table table_of(const Surface& surface, const Moments& m, const EffectiveSampleSize& size,
                    const Options& what, int threads) {
  if (what.estimate == "kernel") {
    const double h = bandwidth_for(what, m, size);
    return table_of_density(kernel_density(surface.heights, m, size, h, what.points ? what.points : 256),
                            surface, size);
  }
  if (what.estimate == "quantiles")
    return table_of_quantiles(
        quantile_plot(MaterialRatioCurve(surface.heights, threads), m, size, what.points ? what.points : 99),
        surface, size);
  return table_of_bins(surface, m, size, what.bins);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-pdf",
      "The distribution of the heights beside the Gaussian of the same mean and Sq, with standard errors. A "
      "histogram, a row a bin: its centre, count, the count expected of the Gaussian, the misfit (the "
      "difference in its own standard errors), and the same as densities. Or the density by a Gaussian "
      "kernel beside the Gaussian that the kernel has widened likewise. Or quantiles beside those of the "
      "Gaussian, on a straight line against the normal quantile.");
  cli::FieldOptions options;
  Options what;
  options.declare(tool);
  what.declare(tool);
  tool.input();
  tool.table();
  tool.threads();
  tool.example(
      "asperity-generate --shape 128x128 --size 3mm --rq 0.4um --length 17px,4px | asperity-pdf --bins 40");
  tool.accuracy(
      "Counts and quantiles are exact, the kernel's sum to 2e-14. Standard errors are those of a Gaussian "
      "field and allow for the correlation of the heights; errors of neighbouring rows are correlated. Of a "
      "Gaussian surface 95 % of the misfits lie within 2, bins of a few counts and the outermost quantiles "
      "apart.");

  return tool.run(argc, argv, [&] {
    what.check(tool);
    const Surface surface = options.read(tool, tool.read());
    const Moments m = moments(surface.heights, options.variable);
    const EffectiveSampleSize size = error_basis(surface, tool.thread_count()).size();
    warn_of_few(tool, size);
    cli::print(tool, table_of(surface, m, size, what, tool.thread_count()));
    return cli::done;
  });
}
