#include "tools/contact/options.hpp"

#include <cmath>

#include <fmt/ranges.h>

#include "contact/energy.hpp"
#include "tools/cli/output_name.hpp"
#include "tools/cli/stream.hpp"

namespace asperity::cli {
namespace {

using ParseLoad = std::function<double(const std::string&)>;

// In "N", or mean pressures in "Pa".
ParseLoad loads_in(const std::string& unit) {
  return [unit](const std::string& text) {
    const double load = parse_quantity("sweep", text, unit);
    if (!(load > 0 && std::isfinite(load))) throw UsageError("sweep", "'" + text + "' is not above 0");
    return load;
  };
}

// Whether a sweep begins with a pressure.
bool begins_with_pressure(const std::string& loads) try {
  parse_quantity("sweep", loads.substr(0, loads.find_first_of(",:")), "Pa");
  return true;
} catch (const ParameterError&) {
  return false;
}

// One of the ranges of a sweep: a falling one is a rising one read backwards.
std::vector<double> parse_range(const std::string& text, const ParseLoad& parse_load) {
  std::vector<std::string> words = split(text, ':');
  const bool falls = words.size() >= 3 && parse_load(words[0]) > parse_load(words[1]);
  if (!falls) return parse_series("sweep", text, Steps::geometric, parse_load);
  std::swap(words[0], words[1]);
  std::vector<double> out =
      parse_series("sweep", fmt::format("{}", fmt::join(words, ":")), Steps::geometric, parse_load);
  std::ranges::reverse(out);
  return out;
}

// Loads and ranges; where a range goes on from the load before it, that load is pressed once.
std::vector<double> parse_loads(const std::string& text, const ParseLoad& parse_load) {
  constexpr double round_off = 1e-12;
  std::vector<double> out;
  for (const std::string& part : split(text, ',')) {
    const bool range = part.find(':') != part.npos;
    const std::vector<double> loads = range ? parse_range(part, parse_load) : std::vector{parse_load(part)};
    const bool joins = range && !out.empty() && std::abs(loads.front() / out.back() - 1) < round_off;
    out.insert(out.end(), loads.begin() + (joins ? 1 : 0), loads.end());
  }
  return out;
}

// "1%" or "0.01".
double parse_share(const std::string& option, const std::string& word) {
  return word.ends_with('%') ? parse_quantity(option, word, "1") : parse_quantities(option, word, "1")[0];
}

}  // namespace

// ---- declaration ----

void ContactOptions::declare(Tool& tool) {
  declare_surface(tool);
  declare_bodies(tool);
  declare_load(tool);
  const std::string solution = "Solution";
  tool.number("--tolerance", contact.tolerance, "Largest residual, as a share of the range of displacements",
              solution);
  tool.integer("--max-convolutions", contact.max_convolutions, 1, "Largest number of convolutions", solution);
  tool.output();
  tool.table();
  tool.report();
  tool.threads();
  tool.shares_ranks();
}

void ContactOptions::declare_surface(Tool& tool) {
  const std::string surface = "Surfaces";
  const auto [input, list] = surfaces.declare(tool);
  const Option named = tool.text("--variable", variable, "NAME", "Field on (x, y) to read", surface);
  const Option plain = tool.flag("--smooth", smooth, "Press a smooth first body, without an input", surface);
  plain.excludes(input).excludes(list).excludes(named);
  tool.counts("--shape", shape, 1, "Samples in x and y, with --smooth", surface).needs(plain);
  tool.quantities("--size", size, "m", "Side lengths in x and y, with --smooth", surface).needs(plain);
  tool.text("--counter", counter, "FILE",
            "Heights of the second body, on the same grid, positive towards the first. The gap is the form "
            "less both heights at the same (x, y): mirror a body that was measured face up",
            surface);
  tool.choice(
      "--boundary", boundary, {"free", "periodic", "periodic_x", "periodic_y"},
      "Boundary condition; free: half-spaces loaded on the domain only; periodic: surfaces that "
      "repeat the domain, without radii; periodic_x, periodic_y: surfaces that repeat along this axis "
      "alone, with radii across it, as in line contact. The approach then counts from "
      "contact_approach_datum. Default: periodic along the axes along which the dataset is",
      surface);
}

void ContactOptions::declare_bodies(Tool& tool) {
  const std::string group = "Bodies";
  const std::string more = " of each body; inf: straight, negative: hollow";
  const Option both =
      tool.quantities("--radius", radius_, "m", "Radius of each body; inf: flat, negative: hollow", group);
  tool.quantities("--radius-x", radius_x_, "m", "Radius of the section along x" + more, group).excludes(both);
  tool.quantities("--radius-y", radius_y_, "m", "Radius of the section along y" + more, group).excludes(both);
  tool.quantities("--young", bodies.young, "Pa", "Young's modulus of each body; inf: rigid", group)
      .required();
  tool.quantities("--poisson", bodies.poisson, "1", "Poisson's ratio of each body", group).required();
}

void ContactOptions::declare_load(Tool& tool) {
  const std::string load = "Load and material";
  tool.quantity("--load", load_, "N", "Force that presses the bodies together", load);
  tool.quantity(
      "--mean-pressure", mean_pressure_, "Pa",
      "Load of flat bodies over the nominal area, instead of --load. That area is the whole surface, "
      "cells out of contact included: contact_mean_pressure",
      load);
  tool.quantity("--approach", approach_, "m",
                "Prescribed approach instead of a load; 0 where the smooth forms touch", load);
  const Option yield = tool.quantities(
      "--yield", plastic.yield, "Pa",
      "Yield stress of the softer body, or of each; the pressure is limited to 3 times the lower "
      "one, or each body flows with --plasticity j2; inf: elastic",
      load);
  tool.quantity("--limit-pressure", contact.limit_pressure, "Pa", "Limit of the pressure, instead of --yield",
                load)
      .excludes(yield);
  tool.words(
      "--add", add,
      {"contact_stiffness", "heights_residual", "contact_ratios", "elastic_energy", "patches", "grid_errors"},
      "Further results to write; contact_stiffness: dQ/d(approach) of the cells in contact, without "
      "those at the limit pressure; infinite for a periodic surface in full contact. heights_residual: the "
      "surface after unloading, heights less displacement_plastic. contact_ratios: area share, reduced "
      "pressure, kappa and reduced gap of flats, roughness of a sphere, plasticity index. elastic_energy: "
      "that of the displacements, and with a limit pressure the work of flattening. patches: number and area "
      "of the connected patches of contact, their labels, and whether they percolate. grid_errors: "
      "contact_…_error, by how much the grid may put each result off, from contacts on half and a quarter as "
      "many cells a side. A table of --sweep has the figures that vary with the load",
      load);
  tool.text(
      "--accuracy", accuracy_, "SHARE",
      "Refine until the errors of the grid are no larger; 1%, 0.005. The surface is refined by its own band "
      "limit, 2, 4, 8 or 16 times; errors are those of the load or approach, the largest pressure, the "
      "corrected area and an added stiffness. Exit 3 if that is not reached. Implies --add grid_errors",
      load);
  plastic.declare(tool);
  declare_sweep(tool);
}

void ContactOptions::declare_sweep(Tool& tool) {
  const std::string sweep = "Load sweep";
  tool.text(
      "--sweep", loads_, "LOADS",
      "Table of loads, with the stiffness at each; 10N:5kN:20 (equal ratios), 10N:5kN:20:uniform "
      "(equal steps), 10N,20N,50N, or a way up and down, 10N:5kN:20,5kN:10N:20; of flat bodies also mean "
      "pressures, 1MPa:50MPa:10. Each load starts from the solution of the one before; with a limit "
      "pressure, a load below a former one presses the surface that the greatest has flattened",
      sweep);
  tool.text(
      "--each", each, "PATTERN",
      "Write a dataset for each load too, or for each of several surfaces; press-%03d.nc, numbered from 1",
      sweep);
}

// ---- checks ----

void ContactOptions::check(Tool& tool) {
  if (!tool.given("--radius") && (tool.given("--radius-x") || tool.given("--radius-y"))) {
    radius_option = tool.given("--radius-x") ? "radius-x" : "radius-y";
    for (std::size_t i = 0; i < 2; ++i) bodies.radius[i] = {radius_x_[i], radius_y_[i]};
  } else {
    for (std::size_t i = 0; i < 2; ++i) bodies.radius[i] = radius_[i];
  }
  bodies.check();
  plastic.check(tool);
  check_load(tool);
  check_flow(tool);
  check_added();
  check_ranks(tool);
  contact.threads = tool.thread_count();
  contact.check();
  check_streams(tool);
  plastic.parameters.memory = static_cast<double>(tool.memory_bound().bytes);
  if (plastic.flows() && !tabulates() && !unloads()) add.emplace_back("heights_residual");
  check_accuracy(tool);
}

void ContactOptions::check_load(const Tool& tool) {
  const int given =
      tool.given("--load") + tool.given("--mean-pressure") + tool.given("--approach") + tool.given("--sweep");
  if (given != 1)
    throw UsageError("load",
                     given == 0 ? "is required, or --mean-pressure, --approach or --sweep"
                                : "only one of --load, --mean-pressure, --approach and --sweep can be given");
  const bool sweep = tool.given("--sweep");
  by_mean_pressure = sweep ? begins_with_pressure(loads_) : tool.given("--mean-pressure");
  if (tool.given("--load")) contact.load = load_;
  if (tool.given("--mean-pressure")) contact.load = mean_pressure_;
  if (tool.given("--approach")) contact.approach = approach_;
  if (sweep) contact.load = (loads = parse_loads(loads_, loads_in(load_unit()))).front();
  contact.stiffness = sweeps() || adds("contact_stiffness");
  if (tool.given("--yield")) {
    const double yield = std::min(plastic.yield[0], plastic.yield[1]);
    if (!(yield > 0)) throw UsageError("yield", fmt::format("'{} Pa' is not above 0", yield));
    if (!plastic.flows()) contact.limit_pressure = hardness * yield;
  }
  if (by_mean_pressure) check_mean_pressure(sweep ? "sweep" : "mean-pressure");
}

void ContactOptions::check_mean_pressure(const char* name) const {
  if (!bodies.flat())
    throw UsageError(name,
                     "a mean pressure of curved bodies depends on how far the surface reaches beyond the "
                     "contact: give the load in N, or leave the radii out");
  const double greatest = sweeps() ? std::ranges::max(loads) : contact.load;
  if (!(greatest >= 1e-100 && greatest <= 1e100))
    throw ParameterError(name, fmt::format("{} Pa does not lie in 1e-100 ... 1e100 Pa", greatest));
  if (greatest > contact.limit_pressure)
    throw ParameterError(
        name, fmt::format("{} Pa is above the limit pressure, {:.6g} Pa", greatest, contact.limit_pressure));
}

double ContactOptions::force_on(const Grid& grid, double load) const {
  return by_mean_pressure ? load * grid.size_x() * grid.size_y() : load;
}

void ContactOptions::check_accuracy(const Tool& tool) {
  if (!tool.given("--accuracy")) return;
  accuracy = parse_share("accuracy", accuracy_);
  if (!(accuracy > 0 && accuracy < 1))
    throw UsageError("accuracy", fmt::format("'{}' is not between 0 and 1, or 0% and 100%", accuracy_));
  if (tabulates()) throw UsageError("accuracy", "belongs to one surface under one load: leave --sweep out");
  if (!adds("grid_errors")) add.emplace_back("grid_errors");
}

void ContactOptions::check_added() const {
  if (unloads() && std::isinf(contact.limit_pressure) && !plastic.flows())
    throw UsageError("add",
                     "heights_residual needs --yield or --limit-pressure: without them nothing is flattened");
  if (smooth && adds("contact_ratios"))
    throw UsageError("add", "contact_ratios needs a rough surface, not --smooth");
}

// Errors of the grid come from elastic contacts on coarser cells.
void ContactOptions::check_flow(const Tool& tool) {
  if (!plastic.flows()) return;
  const char* const why = "knows no plastic flow: leave it out, or press with --plasticity cut";
  if (tool.given("--accuracy")) throw UsageError("accuracy", why);
  if (adds("grid_errors")) throw UsageError("add", std::string("grid_errors ") + why);
  if (tool.ranks().count() > 1)
    throw UsageError("plasticity", fmt::format("j2 cannot be computed by {} ranks: start one process",
                                               tool.ranks().count()));
  if (plastic.unload && sweeps())
    throw UsageError("unload",
                     "belongs to one load: let the way of --sweep lead down, such as 10N:5kN:20,5kN:1N:5");
}

// Several ranks share one contact: what needs the whole field at once, or further contacts, is refused.
void ContactOptions::check_ranks(const Tool& tool) {
  ranks = &tool.ranks();
  if (ranks->count() == 1) return;
  const std::string why = fmt::format(" by {} ranks: start one process", ranks->count());
  if (tool.given("--accuracy")) throw UsageError("accuracy", "cannot be reached" + why);
  if (adds("grid_errors")) throw UsageError("add", "grid_errors cannot be computed" + why);
}

void ContactOptions::check_streams(Tool& tool) {
  const bool piped = !smooth && surfaces.takes_standard_input();
  if (piped && stdin_is_terminal())
    throw UsageError("smooth", "no input: pipe a dataset in, name a file, or add --smooth");
  if (piped && counter == "-") throw UsageError("counter", "standard input is the first body: name a file");
  if (!smooth) surfaces_ = surfaces.resolve(tool);
  tool.writes_dataset(!tabulates());
  if (tabulates()) return check_table(tool);
  refuse_terminal(tool.output_name());
  if (tool.json())
    throw UsageError("json",
                     "prints the table of --sweep, or of several surfaces: add it, or leave --json out");
  if (!each.empty()) throw UsageError("each", "needs --sweep or several surfaces");
  check_dataset_name(tool.output_name());
}

void ContactOptions::check_table(Tool& tool) const {
  check_table_name(tool.output_name(), tool.json());
  if (tool.given("--report"))
    throw UsageError("report",
                     "belongs to one contact; of a table, each dataset has its own attributes (--each)");
  if (each.empty() && unloads())
    throw UsageError("add",
                     "heights_residual needs --each with --sweep or several surfaces: the table has no "
                     "surfaces");
  if (each.empty()) return;
  if (sweeps() && several())
    throw UsageError("each", "numbers the loads of one surface, or several surfaces under one load");
  check_dataset_name(numbered("each", each, 1), "each");
  std::vector<std::string> outputs;
  for (std::size_t k = 1; k <= (sweeps() ? loads.size() : surfaces_); ++k)
    outputs.push_back(numbered("each", each, static_cast<std::int64_t>(k)));
  surfaces.claim(tool, "each", outputs);
}

}  // namespace asperity::cli
