// Parameters of a surface with their standard errors.
#include <cmath>
#include <optional>
#include <set>

#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "stats/measure/ensemble_parameters.hpp"
#include "tools/cli/counted_cells.hpp"
#include "tools/cli/ensemble_input.hpp"
#include "tools/cli/ensemble_table.hpp"
#include "tools/cli/turns.hpp"
#include "tools/measure/stats_options.hpp"
#include "tools/measure/twin_rows.hpp"

using namespace asperity;

namespace {

// The surfaces of the command line, measured one by one.
class Surfaces {
 public:
  Surfaces(const cli::Tool& tool, const cli::StatsOptions& options)
      : tool_(tool), field_(options.field), errors_(options.errors), asked_(options.checked(tool)) {}

  void add(const Dataset& data, const std::string& name, bool alone) {
    tool_.detail(name);
    if (const auto part = cli::counted_cells(data, field_.variable)) tool_.note(part->told_of_all());
    grids_.add(tool_, grid_of(data), name, si_unit_of(data.at(field_.variable)));
    Surface surface = field_.read_flat(tool_, data);
    if (surface.flat) return add_flat(surface);
    add(Sample(std::move(surface), asked_.groups.contains(Group::hybrid), tool_.thread_count()), alone);
  }
  void print() const {
    for (const std::string& group : missing_) tool_.warn(group);
    if (!doubt_.empty()) tool_.warn(doubt_);
    if (fewest_) warn_of_few(tool_, *fewest_);
    if (ensemble_.surfaces() == 1) return cli::print(tool_, last_);
    cli::print(tool_, cli::ensemble_table(ensemble_));
  }

 private:
  void add(const Sample& sample, bool alone) {
    Parameters all;
    for (const Group group : asked_.groups) {
      const Parameters rows = measure(sample, group, asked_);
      if (const std::string why = missing(rows); group == Group::hybrid && !why.empty()) {
        // The other groups are still printed.
        if (asked_.groups.size() == 1) throw DataError(field_.variable, why);
        cli::in_turn([this, why] { missing_.insert(field_.variable + ": no hybrid parameters: " + why); });
      }
      if (group == Group::hybrid)
        if (const std::string doubt = doubt_of_steps(sample); !doubt.empty())
          cli::in_turn([this, doubt] { doubt_ = doubt_.empty() ? field_.variable + ": " + doubt : doubt_; });
      if (group == Group::spatial) warn_of_decays(tool_, rows, asked_.sal_level, sample.grid());
      all.insert(all.end(), rows.begin(), rows.end());
    }
    settle_errors(sample, alone, all);
    cli::in_turn([this, size = sample.size(), all = std::move(all)] {
      if (!fewest_ || size.effective(2) < fewest_->effective(2)) fewest_ = size;
      ensemble_.add(all);
      last_ = all;
    });
  }

  void add_flat(const Surface& flat) {
    Parameters all;
    for (const Group group : asked_.groups)
      for (Parameter& row : measure_flat(flat, group, asked_)) all.push_back(std::move(row));
    cli::in_turn([this, all = std::move(all)] {
      ensemble_.add(all);
      last_ = all;
    });
  }

  // As asked for by --errors.
  void settle_errors(const Sample& sample, bool alone, Parameters& all) const {
    if (errors_ == "none")
      for (Parameter& p : all) {
        p.standard_error = NAN, p.interval.reset();
        if (std::isfinite(p.value)) p.why.clear();  // else why there is no value
      }
    const bool asked = errors_ == "twins";
    if (asked || (errors_ == "auto" && alone))
      cli::errors_by_twins(tool_, sample, asked_, asked ? TwinUse::everywhere : TwinUse::where_quick, all);
  }

  const cli::Tool& tool_;
  const cli::FieldOptions& field_;
  const std::string errors_;
  const MeasureOptions asked_;
  cli::EnsembleGrid grids_;
  EnsembleParameters ensemble_;
  Parameters last_;
  // Warnings that are given once for all surfaces.
  std::optional<EffectiveSampleSize> fewest_ = {};  ///< of the surface with the fewest independent heights
  std::set<std::string> missing_ = {};              ///< groups without values, and why
  std::string doubt_ = {};                          ///< of heights in steps, of the first surface
};

void document(cli::Tool& tool) {
  tool.essential({"--parameters", "--profile", "--quantiles", "--material-ratio", "--sal-level",
                  "--direction", "--variable", "--remove-form", "--lambda-s", "--lambda-c", "--json",
                  "--output"});
  tool.example("asperity-generate --shape 128x128 --size 3mm --rq 0.4um --length 17px,4px | asperity-stats");
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-stats",
      "Measures surface parameters (ISO 25178-2) with standard errors that allow for the correlation of "
      "neighbouring heights. Kurtosis is 3 for a Gaussian; moments are population moments of the whole "
      "field. For several surfaces it prints the mean of each parameter, its standard error, its spread, and "
      "the spread expected from the errors of the single surfaces. All surfaces need the same spacing, "
      "because slopes, peaks and lengths depend on it; surfaces of different sizes are averaged with a "
      "warning.");
  cli::EnsembleInput surfaces;
  cli::StatsOptions options;
  surfaces.declare(tool);
  options.declare(tool);
  tool.table();
  tool.threads();
  document(tool);

  return tool.run(argc, argv, [&] {
    Surfaces measured(tool, options);
    surfaces.for_each(tool, [&](const cli::EnsembleMember& member) {
      measured.add(member.data, member.name, member.alone());
    });
    measured.print();
    return cli::done;
  });
}
