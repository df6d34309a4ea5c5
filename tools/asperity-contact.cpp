/// Presses two bodies together and writes pressure, gap, displacement and the state of every cell.
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "cli/stream.hpp"
#include "cli/tool.hpp"
#include "contact/bodies.hpp"
#include "contact/hertz.hpp"
#include "contact/solver.hpp"
#include "dataset/layout.hpp"

using namespace asperity;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double hardness = 3;  // limit pressure over yield stress

struct Options {
  std::string input = "-";
  bool smooth = false;
  Shape shape;
  std::array<double, 2> size{none, none};
  Bodies bodies{.young = {none, none}, .poisson = {none, none}};
  double yield = none;
  ContactParameters contact;
};

void declare(cli::Tool& tool, Options& o) {
  const std::string surface = "Surface", bodies = "Bodies", load = "Load and material", solution = "Solution";
  CLI::Option* input =
      tool.app().add_option("INPUT", o.input, "Dataset with heights(x,y) to read; - is standard input");
  input->type_name("FILE")->capture_default_str();
  CLI::Option* smooth =
      tool.flag("--smooth", o.smooth, "Press smooth bodies: starts a chain, reads nothing", surface);
  smooth->excludes(input);
  tool.counts("--shape", o.shape, 1, "Cells in x and y, with --smooth", surface)->needs(smooth);
  tool.quantities("--size", o.size, "m", "Sides of the domain, with --smooth", surface)->needs(smooth);

  tool.quantities("--radius", o.bodies.radius, "m", "Radius of each body; inf is a flat", bodies);
  tool.quantities("--young", o.bodies.young, "Pa", "Young's modulus of each body; inf is rigid", bodies)
      ->required();
  tool.numbers_pair("--poisson", o.bodies.poisson, "Poisson's ratio of each body", bodies)->required();

  tool.quantity("--load", o.contact.load = none, "N", "Force that presses the bodies together", load)
      ->required();
  CLI::Option* yield = tool.quantity("--yield", o.yield, "Pa",
                                     "Yield stress of the softer body: no pressure exceeds 3 of it", load);
  tool.quantity("--limit-pressure", o.contact.limit_pressure, "Pa", "The greatest pressure itself", load)
      ->excludes(yield);

  tool.number("--tolerance", o.contact.tolerance, "Residual to reach, of the range of displacements",
              solution);
  tool.integer("--max-convolutions", o.contact.max_convolutions, 1, "Give up after so many", solution);
  tool.output();
  tool.report();
  tool.threads();
}

void check(cli::Tool& tool, Options& o) {
  o.bodies.check();
  if (tool.given("--yield")) {
    if (!(o.yield > 0)) throw cli::UsageError("yield", fmt::format("{} Pa is not above 0", o.yield));
    o.contact.limit_pressure = hardness * o.yield;
  }
  o.contact.threads = tool.thread_count();
  o.contact.check();
  if (!o.smooth && o.input == "-" && cli::stdin_is_terminal())
    throw cli::UsageError("smooth", "no input: pipe a dataset in, name a file, or press smooth bodies");
}

Grid smooth_grid(const Options& o) {
  if (o.shape.cells() == 0) throw cli::UsageError("shape", "is needed with --smooth");
  for (double side : o.size)
    if (!(side > 0 && std::isfinite(side)))
      throw cli::UsageError("size", "is needed with --smooth, both sides above 0");
  return {o.shape, o.size[0] / static_cast<double>(o.shape.nx), o.size[1] / static_cast<double>(o.shape.ny)};
}

/// The dataset to amend, and the gap between the bodies before they touch.
Field read_gap(const Options& o, Dataset& data, Grid& grid) {
  if (o.smooth) {
    set_grid(data, grid = smooth_grid(o));
    return undeformed_gap(grid, o.bodies);
  }
  data = cli::Tool::read(o.input);
  grid = grid_of(data);
  if (grid.periodic && o.bodies.composite_curvature() > 0)
    throw cli::UsageError("radius", "a periodic surface has no radius: leave --radius out");
  return undeformed_gap(grid, o.bodies) - field_of(data, "heights");
}

void record_parameters(Attributes& a, const Options& o) {
  auto set_pair = [&a](const char* name, const std::array<double, 2>& values) {
    a.set_values(name, std::vector<double>(values.begin(), values.end()));
  };
  a.set("contact_load", o.contact.load);
  a.set("contact_limit_pressure", o.contact.limit_pressure);
  set_pair("contact_radius", o.bodies.radius);
  set_pair("contact_young", o.bodies.young);
  set_pair("contact_poisson", o.bodies.poisson);
  a.set("contact_composite_modulus", o.bodies.composite_modulus());
  a.set("contact_tolerance", o.contact.tolerance);
  for (const char* name : {"contact_hertz_pressure", "contact_hertz_radius", "contact_hertz_approach"})
    a.erase(name);
  if (!(o.bodies.composite_curvature() > 0)) return;
  const Hertz smooth = hertz(o.bodies, o.contact.load);
  a.set("contact_hertz_pressure", smooth.pressure);
  a.set("contact_hertz_radius", smooth.radius);
  a.set("contact_hertz_approach", smooth.approach);
}

void record_result(Attributes& a, const Contact& c) {
  a.set("contact_max_pressure", c.max_pressure);
  a.set("contact_area", c.area);
  a.set("contact_plastic_area", c.plastic_area);
  a.set("contact_approach", c.approach);
  a.set("contact_residual", c.residual);
  a.set("contact_load_error", c.load_error);
  a.set("contact_converged", c.converged ? 1 : 0);
  a.set("contact_convolutions", c.convolutions);
  a.set("contact_preconditionings", c.preconditionings);
  a.set("contact_levels", c.levels);
  a.set("contact_setup_seconds", c.setup_seconds);
  a.set("contact_seconds", c.seconds);
}

void record_fields(Dataset& data, const Contact& c) {
  set_field(data, "pressure", c.pressure, {"Pa", "contact pressure"});
  set_field(data, "gap", c.gap, {"m", "gap between the pressed bodies, negative where flattened"});
  set_field(data, "displacement", c.displacement, {"m", "elastic displacement of both bodies together"});
  set_flags(data, "contact", c.state, "state of contact", "open elastic at_limit_pressure");
}

std::string told(const ContactProgress& p) {
  return fmt::format(
      "{}x{}: {:4d} convolutions, residual {:.2e}, area {:.6g} mm2, greatest pressure {:.6g} MPa", p.shape.nx,
      p.shape.ny, p.convolutions, p.residual, p.area * 1e6, p.max_pressure * 1e-6);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool("asperity-contact", "Presses two rough bodies together: pressure, gap, contact area");
  Options options;
  declare(tool, options);
  tool.example(
      "asperity-contact --smooth --shape 128x128 --size 3mm --radius 50mm --young 208GPa --poisson 0.3 \\\n"
      "    --load 5000N -o smooth.nc");
  tool.accuracy(
      "Bounds exact, load to 1e-12, residual as asked for and confirmed with a fresh convolution. On n "
      "cells\n"
      "  across a Hertzian contact its greatest pressure errs by 0.9/n^2, its approach by 0.2/n^2.");

  return tool.run(argc, argv, [&] {
    check(tool, options);
    if (tool.verbose()) options.contact.progress = [&](const ContactProgress& p) { tool.detail(told(p)); };
    Dataset data;
    Grid grid;
    const Field gap = read_gap(options, data, grid);
    const Contact contact = solve_contact(grid, gap, options.bodies.composite_modulus(), options.contact);

    record_parameters(data.attributes, options);
    record_result(data.attributes, contact);
    record_fields(data, contact);
    for (const std::string& warning : contact.warnings) tool.warn(warning);
    tool.write(data);
    if (!contact.converged) tool.warn("not converged: " + contact.reason);
    return contact.converged ? cli::done : cli::not_converged;
  });
}
