// Parameters of a surface with their standard errors.
#include "ensemble_input.hpp"
#include "stats_ensemble.hpp"
#include "stats_groups.hpp"

using namespace asperity;

namespace {

cli::Rows rows_of(cli::Tool& tool, cli::Sample sample, const cli::StatsOptions& what, double section) {
  if (!what.profile.empty()) return profile_rows(sample, what, section);
  cli::Rows out;
  auto add = [&](const cli::Rows& rows) { out.insert(out.end(), rows.begin(), rows.end()); };
  if (what.asks_for("height")) add(height_rows(sample));
  if (!what.quantiles.empty()) add(quantile_rows(sample, what));
  if (what.asks_for("gaussianity")) add(gaussianity_rows(sample));
  if (what.asks_for("material")) add(material_rows(sample, what));
  if (what.asks_for("spatial")) add(spatial_rows(tool, sample, what));
  if (what.asks_for("hybrid")) add(hybrid_rows(sample, what));
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool("asperity-stats",
                 "Parameters of a surface by ISO 25178-2, with standard errors that allow for the "
                 "correlation of neighbouring heights. Kurtosis is 3 for a Gaussian; moments are population "
                 "moments of the whole field. Of several surfaces, the mean of each parameter over them, its "
                 "standard error and spread, and the spread that the surfaces' own errors lead to expect.");
  cli::EnsembleInput surfaces;
  cli::MeasuredOptions options;
  cli::StatsOptions what;
  surfaces.declare(tool);
  options.declare(tool);
  what.declare(tool);
  tool.table();
  tool.threads();
  tool.example("asperity-generate --shape 128x128 --size 3mm --rq 0.4um --length 17px,4px | asperity-stats");
  tool.accuracy(
      "Moments to twelve digits, 1 nm on an offset of 1 m included. Standard errors are those of a Gaussian "
      "field, to first order in 1/N_eff; with the correlation that a dataset carries, 95 % intervals hold 92 "
      "% and more from N_eff = 41 on. From an estimated correlation they do from N_eff = 150; at 41 those of "
      "Sa and Sq hold 84 %. Peak and valley have none, nor has what shows a dash. Slopes and curvatures are "
      "those of differences of neighbouring points: of a wave of n points a period low by 1.6/n^2 (Sdq) to "
      "6.6/n^2 (m4). The mean over profiles has the standard error of those that are independent.");

  return tool.run(argc, argv, [&] {
    what.check(tool);
    cli::EnsembleRows ensemble;
    cli::Quantities last;
    surfaces.for_each([&](const Dataset& data, const std::string& name) {
      tool.detail(name);
      cli::Sample sample(cli::measure(data, options, tool.thread_count()), options.variable,
                         tool.thread_count());
      last.rows = rows_of(tool, std::move(sample), what, options.long_cutoff);
      ensemble.add(last.rows);
    });
    if (ensemble.surfaces() == 1)
      cli::print(tool, last);
    else
      cli::print(tool, ensemble.table());
    return cli::done;
  });
}
