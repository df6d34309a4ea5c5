// The distribution of heights beside the Gaussian of the same mean and rms height.
#include <cmath>

#include "cli/table.hpp"
#include "measured.hpp"
#include "stats/distribution.hpp"

using namespace asperity;

namespace {

cli::Table table_of_bins(const std::vector<Bin>& bins, const cli::Measured& measured, double points) {
  const std::string density = measured.units_to(-1);
  cli::Table out{{{"height", measured.units},
                  {"count", "1"},
                  {"standard_error", "1"},
                  {"gaussian", "1"},
                  {"misfit", "1"},
                  {"density", density},
                  {"density_error", density},
                  {"gaussian_density", density}},
                 {}};
  for (const Bin& bin : bins) {
    const double per_height = 1 / (points * bin.width());
    const double deviation = bin.count - bin.expected;
    out.rows.push_back({bin.centre(), bin.count, bin.count_error, bin.expected,
                        bin.misfit_error > 0 ? deviation / bin.misfit_error : deviation,
                        bin.count * per_height, bin.count_error * per_height, bin.expected * per_height});
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-pdf",
      "The histogram of the heights, a row a bin: its centre, the count with its standard error, the count "
      "expected of the Gaussian with the same mean and Sq, the misfit (count - expected, in standard errors "
      "of that difference), and the same as densities.");
  cli::MeasuredOptions options;
  int bins = 0;
  options.declare(tool);
  tool.integer("--bins", bins, 0, "Bins of equal width over the range; 0: Scott's rule, 3.49 Sq / N^(1/3)",
               "Bins");
  tool.input();
  tool.table();
  tool.threads();
  tool.example(
      "asperity-generate --shape 128x128 --size 3mm --rq 0.4um --length 17px,4px | asperity-pdf --bins 40");
  tool.accuracy(
      "Counts are exact. Their standard errors are those of a Gaussian field and allow for the correlation "
      "of the "
      "heights; errors of neighbouring bins are correlated. Of a Gaussian surface 95 % of the misfits lie "
      "within 2, "
      "bins of a few counts apart.");

  return tool.run(argc, argv, [&] {
    const cli::Measured measured = cli::measure(tool.read(), options, tool.thread_count());
    const Moments m = moments(measured.heights, options.variable);
    const EffectiveSize size = cli::effective_size(measured, tool.thread_count());
    if (bins == 0) bins = scott_bins(m, size.points());

    const cli::Table table =
        table_of_bins(histogram(measured.heights, m, size, bins), measured, size.points());
    cli::print(tool, table);
    return cli::done;
  });
}
