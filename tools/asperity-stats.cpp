// Parameters of a surface with their standard errors.
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "core/words.hpp"
#include "tools/measure/ensemble_input.hpp"
#include "tools/measure/ensemble_rows.hpp"
#include "tools/measure/groups.hpp"

using namespace asperity;

namespace {

void append(cli::Rows& out, const cli::Rows& rows) { out.insert(out.end(), rows.begin(), rows.end()); }

// What is said once, of however many surfaces.
struct Cautions {
  std::optional<EffectiveSampleSize> fewest;  ///< of the surface with the fewest independent heights
  std::set<std::string> missing;              ///< groups that cannot be had, and why

  void add(const EffectiveSampleSize& size) {
    if (!fewest || size.effective(2) < fewest->effective(2)) fewest = size;
  }
  void tell(const cli::Tool& tool) const {
    for (const std::string& group : missing) tool.warn(group);
    if (fewest) warn_of_few(tool, *fewest);
  }
};

// A group that cannot be had takes no other with it, and is refused where nothing else was asked for.
void append_group(cli::Rows& out, const cli::Rows& rows, const std::string& group,
                  const std::string& variable, const cli::StatsOptions& what, Cautions& cautions) {
  if (const std::string why = missing(rows); !why.empty()) {
    if (what.asks_for_nothing_else(group)) throw DataError(variable, why);
    cautions.missing.insert(variable + ": no " + group + " parameters: " + why);
  }
  append(out, rows);
}

// Other formats than NetCDF are read whole.
bool larger_than_memory(const std::string& path, std::size_t memory) {
  namespace fs = std::filesystem;
  std::error_code none;
  if (!fs::is_regular_file(path, none) || fs::file_size(path, none) <= memory / 8) return false;
  std::string first(8, '\0');
  std::ifstream(path, std::ios::binary).read(first.data(), static_cast<std::streamsize>(first.size()));
  return looks_like_netcdf(first);
}

// All but spatial.
cli::Rows rows_of(cli::Sample& sample, const cli::MeasuredOptions& options, const cli::StatsOptions& what,
                  Cautions& cautions) {
  cautions.add(sample.size());
  if (!what.profile.empty()) return profile_rows(sample, what, options.long_cutoff);
  cli::Rows out;
  if (what.asks_for("height")) append(out, height_rows(sample));
  if (!what.quantiles.empty()) append(out, quantile_rows(sample, what));
  if (what.asks_for("gaussianity")) append(out, gaussianity_rows(sample));
  if (what.asks_for("material")) append(out, material_rows(sample, what));
  if (what.asks_for("hybrid"))
    append_group(out, hybrid_rows(sample, what), "hybrid", options.variable, what, cautions);
  return out;
}

cli::Rows rows_of_whole(const cli::Tool& tool, const Dataset& data, const cli::MeasuredOptions& options,
                        const cli::StatsOptions& what, Cautions& cautions) {
  cli::WholeSample sample(cli::measure(tool, data, options), options.variable, tool.thread_count());
  cli::Rows out = rows_of(sample, options, what, cautions);
  if (what.asks_for("spatial")) append(out, spatial_rows(tool, sample, what));
  return out;
}

cli::Rows rows_in_strips(const cli::Tool& tool, const std::string& path, const cli::MeasuredOptions& options,
                         const cli::StatsOptions& what, Cautions& cautions, cli::EnsembleGrid& grids) {
  if (const std::string whole = what.needs_whole_field(tool); !whole.empty())
    throw cli::UsageError("memory", "the file's " + std::to_string(std::filesystem::file_size(path)) +
                                        " bytes are more than an eighth of it, and " + whole +
                                        " needs the whole field");
  const FieldFile file(path, options.variable, tool.memory_bound());
  grids.add(tool, file.grid(), path);
  Dataset head = file.dataset();
  tool.settle(head, path);
  cli::StripSample sample(file, options, {what.asks_for("hybrid"), tool.memory(), tool.thread_count()});
  tool.note("read in strips of " + counted(sample.rows(), "row"));
  if (sample.correlation_reaches_beyond())
    tool.warn("the correlation is longer than half a strip of " + counted(sample.rows(), "row") +
              ": standard errors are too small; see --memory");
  return rows_of(sample, options, what, cautions);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-stats",
      "Parameters of a surface by ISO 25178-2, with standard errors that allow for the "
      "correlation of neighbouring heights. Kurtosis is 3 for a Gaussian; moments are population "
      "moments of the whole field. Of several surfaces, the mean of each parameter over them, its "
      "standard error and spread, and the spread that the surfaces' own errors lead to expect. Surfaces of "
      "another spacing than the first's are refused, for slopes, peaks and lengths follow it; of "
      "another size they are averaged with a warning.");
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
      "Moments to twelve digits, 1 nm on an offset of 1 m included. Standard errors are those of a "
      "Gaussian field, to first order in 1/N_eff; those of the height parameters, where the dataset says "
      "what distribution the heights were drawn with or Ssk or Sku tell by four standard errors that they"
      " are not Gaussian, are those of that distribution or of Johnson's of these moments. 95 % intervals"
      " of the height parameters, of Sal and of lengths hold 93 to 97 %, within what 2000 fields can "
      "tell, with the correlation that a dataset carries or an estimated one, down to N_eff = 41; there "
      "an estimated one's length at 1/e holds 97.7 %. Below N_eff = 5, or 10 where it is estimated, which "
      "does not fall much lower however few heights are independent, no errors are told, and up to twice "
      "that they are rough. Peak and valley have none, nor has what shows a dash. Slopes and curvatures are "
      "those of differences of neighbouring points: of a wave of n points"
      " a period low by 1.6/n^2 (Sdq) to 6.6/n^2 (m4). The mean over profiles has the standard error of "
      "those that are independent.");

  return tool.run(argc, argv, [&] {
    what.check(tool);
    cli::EnsembleRows ensemble;
    cli::EnsembleGrid grids;
    cli::Quantities last;
    Cautions cautions;
    auto add = [&](cli::Rows rows) {
      ensemble.add(rows);
      last.rows = std::move(rows);
    };
    surfaces.for_each(
        tool,
        [&](const Dataset& data, const std::string& name) {
          tool.detail(name);
          grids.add(tool, grid_of(data), name);
          add(rows_of_whole(tool, data, options, what, cautions));
        },
        [&](const std::string& path) {
          const bool bounded = tool.given("--memory") || what.needs_whole_field(tool).empty();
          const bool in_strips = bounded && larger_than_memory(path, tool.memory());
          if (in_strips) add(rows_in_strips(tool, path, options, what, cautions, grids));
          return in_strips;
        });
    cautions.tell(tool);
    if (ensemble.surfaces() == 1)
      cli::print(tool, last);
    else
      cli::print(tool, ensemble.table());
    return cli::done;
  });
}
