/// Presses two bodies together: pressure, gap, displacement and state of each cell, or a table of loads.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "contact/sweep.hpp"
#include "tools/cli/ensemble_table.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/stream.hpp"
#include "tools/contact/press.hpp"
#include "tools/contact/record.hpp"

using namespace asperity;

namespace {

constexpr double coarse_portion = 0.1;  // of the rest of the progress bar, for a grid before the finest

// Progress of the solution, for a terminal.
class ProgressCounter {
 public:
  ProgressCounter(const cli::Tool& tool, const cli::ContactOptions& options)
      : progress_(tool),
        rounds_(tool, {"grid", "convolutions", "residual", "area [mm2]", "greatest [MPa]"}),
        tolerance_(options.contact.tolerance),
        loads_(options.loads.size()),
        of_one_(!options.several()) {}

  /// Of plastic flow.
  void increments(int done, int of) { progress_.count(done, of, "increments"); }
  /// Of a sweep: another load is done.
  void next() { ++load_; }
  void add(const ContactProgress& p) {
    const std::string grid = fmt::format("{}x{}", p.shape.nx, p.shape.ny);
    if (of_one_ && loads_ > 0)
      progress_.count(static_cast<double>(load_) + (p.finest ? cli::decades_done(p.residual, tolerance_) : 0),
                      static_cast<double>(loads_), "loads");
    else if (of_one_)
      progress_.iterate({.stage = {grid},
                         .residual = p.residual,
                         .tolerance = tolerance_,
                         .steps = static_cast<double>(p.convolutions),
                         .name = "convolutions",
                         .portion = p.finest ? 1 : coarse_portion,
                         .last = p.finest});
    rounds_.row({grid, std::to_string(p.convolutions), fmt::format("{:.2e}", p.residual),
                 fmt::format("{:.6g}", p.area * 1e6), fmt::format("{:.6g}", p.max_pressure * 1e-6)});
  }

 private:
  cli::Progress progress_;
  cli::StepTable rounds_;
  double tolerance_;
  std::size_t loads_, load_ = 0;
  bool of_one_;  ///< several surfaces are counted, not their rounds
};

void warn(const cli::Tool& tool, const std::vector<Doubt>& doubts) {
  for (const Doubt& doubt : doubts) tool.warn(doubt.words);
}

void warn_of(const cli::Tool& tool, const cli::ContactOptions& options, const cli::ContactScene& scene) {
  warn(tool, cli::doubts(scene));
  warn(tool, doubts(scene.grid, options.bodies));
}

// With a warning where the contact has not converged.
int exit_of(const cli::Tool& tool, const cli::ContactOptions& options, const Contact& contact) {
  const std::string why = cli::unconverged(options, contact);
  if (why.empty()) return cli::done;
  tool.warn(why);
  return cli::not_converged;
}

// ---- one surface ----

// The one that is pressed, or none of a smooth body.
cli::ContactScene only_scene(const cli::Tool& tool, cli::ContactOptions& options) {
  return cli::scene_of(tool, options, options.smooth ? Dataset() : options.surfaces.only(tool));
}

int press_one(cli::Tool& tool, cli::ContactOptions& options) {
  cli::ContactScene scene = only_scene(tool, options);
  cli::Influence influence(options);
  const cli::Inventory before(scene.data);
  const cli::Accurate accurate = options.accuracy > 0
                                     ? cli::press_accurately(tool, options, scene, influence)
                                     : cli::Accurate{cli::press(options, scene, influence), {}};
  const cli::Pressed& pressed = accurate.pressed;
  cli::record(scene, options, pressed.contact, pressed.figures, pressed.flow ? &*pressed.flow : nullptr);
  before.tell(tool, scene.data, "pressure");
  warn_of(tool, options, scene);
  warn(tool, pressed.doubts);
  const int code = exit_of(tool, options, pressed.contact);
  const bool reached = accurate.unreached.empty();
  if (!reached) tool.warn("the accuracy is not reached: " + accurate.unreached);
  scene.written([&] { tool.write(scene.data); });
  return reached ? code : cli::not_converged;
}

// ---- several surfaces ----

cli::Several several_contacts() {
  return {.on_one_grid = "the mean over contacts", .go_on = cli::Several::GoOn::after_any_error};
}

cli::ContactScene scene_of_member(const cli::Tool& tool, const cli::ContactOptions& options,
                                  cli::EnsembleMember& member) {
  cli::ContactScene scene = cli::scene_of(tool, options, std::move(member.data));
  warn_of(tool, options, scene);
  return scene;
}

int press_several(const cli::Tool& tool, cli::ContactOptions& options) {
  cli::Influences influences(options);
  const auto results_of = [&](cli::EnsembleMember&& of) {
    cli::ContactScene scene = scene_of_member(tool, options, of);
    const cli::Inventory before(scene.data);
    const cli::Pressed pressed =
        influences.with_one([&](cli::Influence& own) { return cli::press(options, scene, own); });
    cli::record(scene, options, pressed.contact, pressed.figures, pressed.flow ? &*pressed.flow : nullptr);
    cli::SurfaceResults out{scene.data.attributes, pressed.contact.converged};
    warn(tool, pressed.doubts);
    out.code = exit_of(tool, options, pressed.contact);
    if (!options.each.empty()) {
      if (of.number == 1) before.tell(tool, scene.data, "pressure");
      tool.write(scene.data, cli::numbered("each", options.each, static_cast<std::int64_t>(of.number)));
    }
    return out;
  };
  return cli::print_rows(
      tool, options.surfaces, several_contacts(),
      {.prefix = "contact_", .without = {"hertz_*"}, .achieved = {"residual", "convolutions", "converged"}},
      results_of);
}

// ---- a sweep of loads ----

// What is said about a load.
struct LoadVerdict {
  std::string load;  ///< "s_1.nc: 20 N"
  std::vector<Doubt> doubts;
  std::string unconverged;  ///< why; "": converged
};
// finish() comes before the table.
struct Say {
  std::function<void(const LoadVerdict&)> say;
  std::function<void()> finish;
};

// Says it load by load: a kind of doubt in full at its first load, then a count and the last load.
class Verdicts {
 public:
  explicit Verdicts(const cli::Tool& tool) : tool_(tool) {}

  void say(const LoadVerdict& verdict) {
    for (const Doubt& doubt : verdict.doubts) {
      Seen& seen = seen_[doubt.about];
      if (seen.loads++ == 0) tool_.warn(verdict.load + ": " + doubt.words, of_a_load);
      seen.last = verdict.load;
    }
    if (verdict.unconverged.empty()) return;
    tool_.warn(verdict.load + ": " + verdict.unconverged, of_a_load);
    code_ = cli::not_converged;
  }
  /// Before the table is printed.
  void finish() const {
    for (const auto& [about, seen] : seen_)
      if (const int more = seen.loads - 1; more > 0)
        tool_.warn(fmt::format("the contact {} under {} more load{}, up to {}", about, more,
                               more == 1 ? "" : "s", seen.last),
                   of_a_load);
  }
  int code() const { return code_; }

 private:
  struct Seen {
    int loads = 0;
    std::string last;
  };

  static constexpr bool of_a_load = false;  // not of the run: whose dataset has it from sweep_table()

  const cli::Tool& tool_;
  std::map<std::string_view, Seen> seen_ = {};
  int code_ = cli::done;
};

// A row for each load; `say` comes after each.
cli::Table sweep_table(const cli::Tool& tool, const cli::ContactOptions& options,
                       const cli::ContactScene& scene, ElasticOperator& influence, const std::string& of,
                       const std::function<void(const LoadVerdict&)>& say) {
  cli::Table out;
  std::size_t number = 0;
  std::optional<cli::Flow> flow;
  const auto add = [&](const Contact& c) {
    const cli::Flow* const below = flow ? &*flow : nullptr;
    const cli::GridFigures figures = cli::grid_figures(options, scene, influence, c);
    cli::add_load(out, scene, options, c, figures, below);
    const std::string load = cli::format_quantity(options.loads[number++], options.load_unit());
    LoadVerdict verdict{of + load, doubts(scene.grid, options.bodies, c), cli::unconverged(options, c)};
    for (Doubt& doubt : cli::doubts(figures)) verdict.doubts.push_back(std::move(doubt));
    if (flow)
      for (Doubt& doubt : cli::doubts(*flow, scene.grid)) verdict.doubts.push_back(std::move(doubt));
    say(verdict);
    if (options.each.empty()) return;
    cli::ContactScene one = scene;
    cli::record(one, options, c, figures, below);
    std::vector<std::string> lines;
    for (const Doubt& doubt : verdict.doubts) lines.push_back(doubt.words);
    if (!verdict.unconverged.empty()) lines.push_back(verdict.unconverged);
    tool.record_warnings(one.data.attributes, "contact_", lines);
    if (number == 1) cli::Inventory(scene.data).tell(tool, one.data, "pressure");
    one.written([&] {
      tool.write(one.data, cli::numbered("each", options.each, static_cast<std::int64_t>(number)));
    });
  };
  std::vector<double> loads = options.loads;
  for (double& load : loads) load = options.force_on(scene.grid, load);
  if (!options.plastic.flows()) {
    solve_load_sequence(scene.grid, scene.gap, influence, options.contact, loads, add);
    return out;
  }
  flow.emplace(cli::plastic_path(options, scene, influence));
  for (const double load : loads) {
    cli::go_on(*flow, options.plastic, load, std::ranges::max(loads));
    add(cli::contact_of(options, scene, influence, *flow));
  }
  return out;
}

const std::set<std::string> prescribed_columns{"load", "mean_pressure"};

// What has not converged is unknown.
void blank_unconverged(cli::Table& table) {
  const auto converged = static_cast<std::size_t>(
      std::ranges::find(table.columns, "converged", &cli::Column::name) - table.columns.begin());
  for (auto& row : table.rows)
    if (std::get<double>(row[converged]) == 0)
      for (std::size_t c = 0; c < row.size(); ++c)
        if (!prescribed_columns.contains(table.columns[c].name)) row[c] = NAN;
}

cli::EnsembleTable::Content content_of(const cli::Table& sweep) {
  const std::set<std::string> apart{"approach", "residual", "convolutions", "converged"};
  cli::EnsembleTable::Content out{.keys = {}, .value = "approach", .error = "approach_standard_error"};
  for (const cli::Column& c : sweep.columns)
    if (prescribed_columns.contains(c.name))
      out.keys.push_back(c.name);
    else if (c.name.starts_with("percolates_"))
      out.shares.push_back(c.name);
    else if (!apart.contains(c.name))
      (c.name.ends_with("_error") ? out.means : out.others).push_back(c.name);
  return out;
}

int sweep_one(const cli::Tool& tool, cli::ContactOptions& options, const Say& say) {
  const cli::ContactScene scene = only_scene(tool, options);
  cli::Influence influence(options);
  warn_of(tool, options, scene);
  const cli::Table table = sweep_table(tool, options, scene, influence.on(scene.grid), "", say.say);
  say.finish();
  cli::print(tool, table);
  return cli::done;
}

// The mean over the surfaces that converged under a load.
int sweep_several(const cli::Tool& tool, cli::ContactOptions& options, const Say& say) {
  struct One {
    cli::Table loads;
    std::vector<LoadVerdict> verdicts = {};
  };
  cli::Influences influences(options);
  cli::EnsembleTable mean(&content_of);
  const int code = options.surfaces.for_each(
      tool,
      [&](cli::EnsembleMember&& member) {
        const cli::ContactScene scene = scene_of_member(tool, options, member);
        One out;
        out.loads = influences.with_one([&](cli::Influence& influence) {
          return sweep_table(tool, options, scene, influence.on(scene.grid), member.name + ": ",
                             [&](const LoadVerdict& verdict) { out.verdicts.push_back(verdict); });
        });
        blank_unconverged(out.loads);
        return out;
      },
      [&](const One& one, const std::string& name) {
        for (const LoadVerdict& verdict : one.verdicts) say.say(verdict);
        mean.add(one.loads, name);
      },
      several_contacts());
  say.finish();
  mean.print(tool);
  return code;
}

int sweep(const cli::Tool& tool, cli::ContactOptions& options, ProgressCounter& counter) {
  Verdicts verdicts(tool);
  const Say say{[&](const LoadVerdict& verdict) {
                  counter.next();
                  verdicts.say(verdict);
                },
                [&] { verdicts.finish(); }};
  const int failed = options.several() ? sweep_several(tool, options, say) : sweep_one(tool, options, say);
  return std::max(verdicts.code(), failed);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-contact",
      "Presses two rough bodies together, elastic or elastic-perfectly plastic: pressure, gap, "
      "displacement and state of "
      "each cell, contact area and approach. Of several surfaces it prints a table: a row for each, "
      "then the mean, its standard error and the spread between them, of surfaces - 1 degrees of freedom "
      "of Student's t, and of shares such as percolates_x by Wilson's interval; with --sweep a row for each "
      "load, with means and standard errors. A surface that fails or does not converge is not in "
      "the mean.");
  cli::ContactOptions options;
  options.declare(tool);
  tool.example(
      "asperity-contact --smooth --shape 128x128 --size 3mm --radius 50mm --young 208GPa --poisson 0.3 "
      "--load 5000N -o smooth.nc");
  tool.essential({"--radius", "--young", "--poisson", "--load", "--approach", "--yield", "--plasticity",
                  "--boundary", "--smooth", "--sweep", "--add", "--accuracy", "--output"});

  return tool.run(argc, argv, [&] {
    options.check(tool);
    ProgressCounter counter(tool, options);
    if (tool.verbose() || tool.shows_progress())
      options.contact.progress = [&](const ContactProgress& p) {
        if (!options.plastic.flows()) counter.add(p);
      };
    if (tool.shows_progress() && !options.tabulates())
      options.plastic.parameters.progress = [&](int done, int of) { counter.increments(done, of); };
    if (options.sweeps()) return sweep(tool, options, counter);
    return options.several() ? press_several(tool, options) : press_one(tool, options);
  });
}
