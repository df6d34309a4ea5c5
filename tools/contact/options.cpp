#include "tools/contact/options.hpp"

#include <cmath>

#include <fmt/format.h>

#include "contact/flattening.hpp"
#include "tools/cli/output_name.hpp"
#include "tools/cli/stream.hpp"

namespace asperity::cli {
namespace {

double parse_load(const std::string& text) {
  const double load = parse_quantity("sweep", text, "N");
  if (!(load > 0 && std::isfinite(load))) throw UsageError("sweep", "'" + text + "' is not above 0");
  return load;
}

}  // namespace

// ---- declaration ----

void ContactOptions::declare(Tool& tool) {
  declare_surface(tool);
  declare_bodies(tool);
  declare_load(tool);
  const std::string solution = "Solution";
  tool.number("--tolerance", contact.tolerance, "Residual to reach, of the range of displacements", solution);
  tool.integer("--max-convolutions", contact.max_convolutions, 1, "Give up after so many", solution);
  tool.output();
  tool.table();
  tool.report();
  tool.threads();
}

void ContactOptions::declare_surface(Tool& tool) {
  const std::string surface = "Surfaces";
  const Option from =
      tool.argument("INPUT", input, "FILE", "Dataset with heights(x,y) to read; - is standard input");
  tool.input_format();
  const Option named = tool.text("--variable", variable, "NAME", "The heights that are read", surface);
  const Option plain =
      tool.flag("--smooth", smooth, "The first body is smooth: starts a chain, reads nothing", surface);
  plain.excludes(from).excludes(named);
  tool.counts("--shape", shape, 1, "Cells in x and y, with --smooth", surface).needs(plain);
  tool.quantities("--size", size, "m", "Sides of the domain, with --smooth", surface).needs(plain);
  tool.text(
      "--counter", counter, "FILE",
      "Heights of the second body, on the same grid and positive towards the first: the gap is the form "
      "less both heights at the same (x, y). Mirror a counter body that was measured face up",
      surface);
  tool.choice("--boundary", boundary, {"free", "periodic"},
              "Half-spaces loaded on the domain alone, or surfaces that repeat it for ever, without radii; "
              "absent: as the grid says",
              surface);
}

void ContactOptions::declare_bodies(Tool& tool) {
  const std::string group = "Bodies";
  const std::string more = " of each body; inf is straight, below 0 hollow";
  const Option both =
      tool.quantities("--radius", radius_, "m", "Radius of each body; inf is a flat, below 0 hollow", group);
  tool.quantities("--radius-x", radius_x_, "m", "Radius of the section along x" + more, group).excludes(both);
  tool.quantities("--radius-y", radius_y_, "m", "Radius of the section along y" + more, group).excludes(both);
  tool.quantities("--young", bodies.young, "Pa", "Young's modulus of each body; inf is rigid", group)
      .required();
  tool.quantities("--poisson", bodies.poisson, "1", "Poisson's ratio of each body", group).required();
}

void ContactOptions::declare_load(Tool& tool) {
  const std::string load = "Load and material", sweep = "Load sweep";
  tool.quantity("--load", load_, "N", "Force that presses the bodies together", load);
  tool.quantity("--approach", approach_, "m",
                "Or their approach from where the smooth forms touch; the load is then a result", load);
  const Option yield = tool.quantity("--yield", yield_, "Pa",
                                     "Yield stress of the softer body: no pressure exceeds 3 of it", load);
  tool.quantity("--limit-pressure", contact.limit_pressure, "Pa", "The greatest pressure itself", load)
      .excludes(yield);
  tool.flag(
      "--stiffness", contact.stiffness,
      "Add contact_stiffness, dQ/d(approach) of the cells in contact; those at the limit pressure give way, "
      "and a periodic surface in full contact is infinitely stiff",
      load);
  tool.flag("--unload", unload,
            "Add heights_residual: the surface after the load is removed, the heights less "
            "displacement_plastic; what is elastic springs back",
            load);

  tool.text(
      "--sweep", loads_, "LOADS",
      "FROM:TO:COUNT, such as 10N:5kN:20 at equal ratios (10N:5kN:20:uniform: equal steps), or 10N,20N,50N: "
      "one load after the other, each "
      "started from the last. Prints a table, a row a load, with the stiffness of each",
      sweep);
  tool.text("--each", each, "PATTERN", "Write a dataset for each load too, such as press-%03d.nc, from 1 on",
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
  check_load(tool);
  contact.threads = tool.thread_count();
  contact.check();
  check_streams(tool);
}

void ContactOptions::check_load(const Tool& tool) {
  const int given = tool.given("--load") + tool.given("--approach") + tool.given("--sweep");
  if (given != 1)
    throw UsageError("load", given == 0 ? "is needed, or --approach or --sweep"
                                        : "only one of --load, --approach and --sweep can be given");
  if (tool.given("--load")) contact.load = load_;
  if (tool.given("--approach")) contact.approach = approach_;
  if (tool.given("--sweep"))
    contact.load = (loads = parse_series("sweep", loads_, Steps::geometric, parse_load)).front();
  if (sweeps()) contact.stiffness = true;
  if (tool.given("--yield")) {
    if (!(yield_ > 0)) throw UsageError("yield", fmt::format("{} Pa is not above 0", yield_));
    contact.limit_pressure = hardness * yield_;
  }
  if (unload && std::isinf(contact.limit_pressure))
    throw UsageError("unload", "nothing is flattened without --yield or --limit-pressure");
}

void ContactOptions::check_streams(Tool& tool) const {
  if (!smooth && input == "-" && stdin_is_terminal())
    throw UsageError("smooth", "no input: pipe a dataset in, name a file, or press smooth bodies");
  if (!smooth && input == "-" && counter == "-")
    throw UsageError("counter", "standard input is the first body already");
  if (!sweeps()) refuse_terminal(tool.output_name());
  if (!sweeps() && tool.json()) throw UsageError("json", "prints the table of --sweep, which is not given");
  if (!sweeps() && !each.empty()) throw UsageError("each", "is for each of --sweep, which are not given");
  tool.writes_dataset(!sweeps());
  sweeps() ? check_table_name(tool.output_name(), tool.json()) : check_dataset_name(tool.output_name());
  if (!each.empty()) check_dataset_name(numbered("each", each, 1), "each");
  for (std::size_t k = 1; !each.empty() && k <= loads.size(); ++k)
    tool.writes("each", numbered("each", each, static_cast<std::int64_t>(k)));
  if (sweeps() && tool.given("--report"))
    throw UsageError("report", "is of one load; of --sweep, each dataset carries its own (--each)");
  if (sweeps() && unload && each.empty())
    throw UsageError("unload", "of --sweep needs --each: the table has no surfaces");
}

}  // namespace asperity::cli
