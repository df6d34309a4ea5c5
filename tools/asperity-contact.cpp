/// Presses two bodies together: pressure, gap, displacement and state of each cell, or a table of loads.
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "contact/doubts.hpp"
#include "contact/influence.hpp"
#include "contact/stiffness.hpp"
#include "contact/sweep.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/stream.hpp"
#include "tools/contact/resolution.hpp"
#include "tools/contact/scene.hpp"

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
        loads_(options.loads.size()) {}

  /// Of a sweep: another load is done.
  void next() { ++load_; }
  void add(const ContactProgress& p) {
    const std::string grid = fmt::format("{}x{}", p.shape.nx, p.shape.ny);
    if (loads_ > 0)
      progress_.count(static_cast<double>(load_) + (p.finest ? cli::decades_done(p.residual, tolerance_) : 0),
                      static_cast<double>(loads_), "loads");
    else
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
};

void warn(const cli::Tool& tool, const std::vector<Doubt>& doubts) {
  for (const Doubt& doubt : doubts) tool.warn(doubt.words);
}

// The doubts of a sweep: each kind in full at its first load, then a count and the last load.
class SweepDoubts {
 public:
  void add(const cli::Tool& tool, const std::vector<Doubt>& doubts, const std::string& load) {
    for (const Doubt& doubt : doubts) {
      Seen& seen = seen_[doubt.about];
      if (seen.loads++ == 0) tool.warn(load + ": " + doubt.words);
      seen.last = load;
    }
  }
  void tell(const cli::Tool& tool) const {
    for (const auto& [about, seen] : seen_)
      if (const int more = seen.loads - 1; more > 0)
        tool.warn(fmt::format("the contact {} under {} more load{}, up to {}", about, more,
                              more == 1 ? "" : "s", seen.last));
  }

 private:
  struct Seen {
    int loads = 0;
    std::string last;
  };
  std::map<std::string_view, Seen> seen_;
};

int told_exit(const cli::Tool& tool, const cli::ContactOptions& options, const Contact& contact,
              const std::string& of) {
  if (!contact.converged) tool.warn(of + "not converged: " + contact.reason);
  const bool stiff = !options.contact.stiffness || !std::isnan(contact.stiffness);
  if (contact.converged && !stiff)
    tool.warn(of + fmt::format(
                       "the stiffness is not converged: residual {:.1e} above {:.0e}; see --max-convolutions",
                       contact.stiffness_residual, stiffness_tolerance));
  return contact.converged && stiff ? cli::done : cli::not_converged;
}

int press(cli::Tool& tool, const cli::ContactOptions& options) {
  cli::ContactScene scene = cli::read_scene(tool, options);
  const auto influence =
      make_influence(scene.grid, options.bodies.composite_modulus(), options.contact.threads);
  Contact contact = solve_contact(scene.grid, scene.gap, *influence, options.contact);
  contact.setup_seconds = influence->setup_seconds();
  const cli::GridFigures figures = cli::grid_figures(options, scene, *influence, contact);
  const cli::Inventory before(scene.data);
  cli::record(scene, options, contact, figures);
  before.tell(tool, scene.data, "pressure");
  tool.write(scene.data);
  warn(tool, cli::doubts(scene.growth));
  warn(tool, doubts(scene.grid, options.bodies));
  warn(tool, doubts(scene.grid, options.bodies, contact));
  warn(tool, doubts(figures));
  return told_exit(tool, options, contact, "");
}

int sweep(cli::Tool& tool, const cli::ContactOptions& options, ProgressCounter& counter) {
  const cli::ContactScene scene = cli::read_scene(tool, options);
  const auto influence =
      make_influence(scene.grid, options.bodies.composite_modulus(), options.contact.threads);
  const cli::Inventory before(scene.data);
  cli::Table table;
  SweepDoubts in_doubt;
  int code = cli::done, number = 0;
  warn(tool, cli::doubts(scene.growth));
  warn(tool, doubts(scene.grid, options.bodies));
  solve_load_sequence(scene.grid, scene.gap, *influence, options.contact, options.loads,
                      [&](const Contact& c) {
                        ++number;
                        counter.next();
                        const cli::GridFigures figures = cli::grid_figures(options, scene, *influence, c);
                        cli::add_load(table, scene, options, c, figures);
                        const std::string load = cli::format_quantity(c.load, "N");
                        in_doubt.add(tool, doubts(scene.grid, options.bodies, c), load);
                        in_doubt.add(tool, doubts(figures), load);
                        code = std::max(code, told_exit(tool, options, c, load + ": "));
                        if (options.each.empty()) return;
                        cli::ContactScene one = scene;
                        cli::record(one, options, c, figures);
                        if (number == 1) before.tell(tool, one.data, "pressure");
                        tool.write(one.data, cli::numbered("each", options.each, number));
                      });
  cli::print(tool, table);
  in_doubt.tell(tool);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool("asperity-contact",
                 "Presses two rough bodies together, elastic or elastic-perfectly plastic: pressure, gap, "
                 "displacement and state of "
                 "each cell, contact area and approach.");
  cli::ContactOptions options;
  options.declare(tool);
  tool.example(
      "asperity-contact --smooth --shape 128x128 --size 3mm --radius 50mm --young 208GPa --poisson 0.3 "
      "--load 5000N -o smooth.nc");
  tool.essential({"--radius", "--young", "--poisson", "--load", "--approach", "--yield", "--boundary",
                  "--smooth", "--counter", "--sweep", "--add", "--output"});
  tool.accuracy(
      "The bounds hold exactly and the load to 1e-12; a fresh convolution confirms the residual. With n "
      "cells across "
      "a Hertzian contact the maximum pressure errs by 0.9/n^2, the approach by 0.2/n^2. The stiffness errs "
      "by at "
      "most its residual, 1e-6, and by the outline of the cells: some 0.1/n for spheres.");

  return tool.run(argc, argv, [&] {
    options.check(tool);
    ProgressCounter counter(tool, options);
    if (tool.verbose() || tool.shows_progress())
      options.contact.progress = [&](const ContactProgress& p) { counter.add(p); };
    return options.sweeps() ? sweep(tool, options, counter) : press(tool, options);
  });
}
