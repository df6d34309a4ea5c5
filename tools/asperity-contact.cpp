/// Presses two bodies together: pressure, gap, displacement and state of each cell, or a table of loads.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "contact/sweep.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/turns.hpp"
#include "tools/contact/accuracy.hpp"
#include "tools/contact/resolution.hpp"
#include "tools/contact/several.hpp"

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

// The one that is pressed, or none of a smooth body.
cli::ContactScene only_scene(const cli::Tool& tool, cli::ContactOptions& options) {
  return cli::scene_of(tool, options, options.smooth ? Dataset() : options.surfaces.only(tool));
}

int press(cli::Tool& tool, cli::ContactOptions& options) {
  cli::ContactScene scene = only_scene(tool, options);
  cli::Influence influence(options);
  const cli::Inventory before(scene.data);
  const cli::Accurate accurate = options.accuracy > 0
                                     ? cli::press_accurately(tool, options, scene, influence)
                                     : cli::Accurate{cli::press(options, scene, influence), {}};
  const cli::Pressed& pressed = accurate.pressed;
  before.tell(tool, scene.data, "pressure");
  scene.written([&] { tool.write(scene.data); });
  warn(tool, cli::doubts(scene));
  warn(tool, doubts(scene.grid, options.bodies));
  warn(tool, pressed.doubts);
  const int code = cli::told_exit(tool, options, pressed.contact, "");
  if (accurate.unreached.empty()) return code;
  tool.warn("the accuracy is not reached: " + accurate.unreached);
  return cli::not_converged;
}

// The sweeps of a run: one surface, or several.
class Sweeps {
 public:
  Sweeps(cli::Tool& tool, const cli::ContactOptions& options, ProgressCounter& counter)
      : tool_(tool), options_(options), counter_(counter) {}

  cli::Table table(const cli::ContactScene& scene, ElasticOperator& influence, const std::string& of,
                   int& code) {
    cli::Table out;
    int number = 0;
    solve_load_sequence(scene.grid, scene.gap, influence, options_.contact, options_.loads,
                        [&](const Contact& c) {
                          cli::in_turn([this] { counter_.next(); });
                          const cli::GridFigures figures = cli::grid_figures(options_, scene, influence, c);
                          cli::add_load(out, scene, options_, c, figures);
                          const std::string load = of + cli::format_quantity(c.load, "N");
                          doubt(doubts(scene.grid, options_.bodies, c), load);
                          doubt(cli::doubts(figures), load);
                          code = std::max(code, cli::told_exit(tool_, options_, c, load + ": "));
                          if (!options_.each.empty()) write(scene, c, figures, ++number);
                        });
    return out;
  }
  void tell() const { in_doubt_.tell(tool_); }

 private:
  void doubt(const std::vector<Doubt>& doubts, const std::string& load) {
    cli::in_turn([this, doubts, load] { in_doubt_.add(tool_, doubts, load); });
  }
  void write(const cli::ContactScene& scene, const Contact& contact, const cli::GridFigures& figures,
             int number) {
    cli::ContactScene one = scene;
    cli::record(one, options_, contact, figures);
    if (number == 1) cli::Inventory(scene.data).tell(tool_, one.data, "pressure");
    one.written([&] { tool_.write(one.data, cli::numbered("each", options_.each, number)); });
  }

  cli::Tool& tool_;
  const cli::ContactOptions& options_;
  ProgressCounter& counter_;
  cli::SweepDoubts in_doubt_;
};

int sweep(cli::Tool& tool, cli::ContactOptions& options, ProgressCounter& counter) {
  Sweeps sweeps(tool, options, counter);
  int code = cli::done;
  if (options.several()) {
    code = cli::sweep_several(
        tool, options,
        [&](const cli::ContactScene& scene, ElasticOperator& influence, const std::string& of, int& worst) {
          return sweeps.table(scene, influence, of, worst);
        });
  } else {
    const cli::ContactScene scene = only_scene(tool, options);
    cli::Influence influence(options);
    warn(tool, cli::doubts(scene));
    warn(tool, doubts(scene.grid, options.bodies));
    cli::print(tool, sweeps.table(scene, influence.on(scene.grid), "", code));
  }
  sweeps.tell();
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-contact",
      "Presses two rough bodies together, elastic or elastic-perfectly plastic: pressure, gap, "
      "displacement and state of "
      "each cell, contact area and approach. Of several surfaces it prints a table: a row for each, "
      "then the mean and its standard error by the spread between them; with --sweep a row for each "
      "load, with means and standard errors. A surface that fails or does not converge is not in "
      "the mean.");
  cli::ContactOptions options;
  options.declare(tool);
  tool.example(
      "asperity-contact --smooth --shape 128x128 --size 3mm --radius 50mm --young 208GPa --poisson 0.3 "
      "--load 5000N -o smooth.nc");
  tool.essential({"--radius", "--young", "--poisson", "--load", "--approach", "--yield", "--boundary",
                  "--smooth", "--sweep", "--add", "--accuracy", "--output"});

  return tool.run(argc, argv, [&] {
    options.check(tool);
    ProgressCounter counter(tool, options);
    if (tool.verbose() || tool.shows_progress())
      options.contact.progress = [&](const ContactProgress& p) { counter.add(p); };
    if (options.sweeps()) return sweep(tool, options, counter);
    return options.several() ? cli::press_several(tool, options) : press(tool, options);
  });
}
