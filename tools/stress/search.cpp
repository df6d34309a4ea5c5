#include "tools/stress/search.hpp"

#include <fmt/format.h>

#include "core/words.hpp"
#include "tools/cli/progress.hpp"

namespace asperity::cli {
namespace {

constexpr double round_off = 1e-12;  // of a pressure that is balanced to it

StressMaximum search(const Tool& tool, const StressSolver& volume) {
  Progress progress(tool);
  StepTable probes(tool, {"layer", "depth [um]", "greatest von_mises [MPa]"});
  return maximum_von_mises(volume, [&](const StressProbe& p) {
    progress.count(static_cast<double>(p.done), static_cast<double>(p.expected), "layers of the search");
    probes.row({std::to_string(p.done), fmt::format("{:.6g}", p.depth * 1e6),
                fmt::format("{:.6g}", p.von_mises * 1e-6)});
  });
}

void record(Attributes& a, const StressMaximum& m) {
  a.set("stress_max_von_mises", m.von_mises);
  a.set("stress_max_x", m.x);
  a.set("stress_max_y", m.y);
  a.set("stress_max_depth", m.depth);
}

void warn_if_shallow(const Tool& tool, const LoadedBody& body, const StressMaximum& maximum) {
  const auto& [grid, pressure, poisson, friction] = body;
  const double accurate = accurate_depth(grid), spread = pressure.maxCoeff() - pressure.minCoeff();
  const bool uniform = grid.periodic && spread <= round_off * pressure.maxCoeff();  // at any depth
  if (maximum.depth >= accurate || uniform) return;
  tool.warn(
      fmt::format("the largest von Mises stress lies {:.4g} um deep, less than the {:.4g} um of "
                  "stress_accurate_depth: it rests on single cells and may be off by {:.0f} % of the largest "
                  "pressure; make the cells finer",
                  maximum.depth * 1e6, accurate * 1e6, 100 * shallow_error(poisson, friction)));
}

// A maximum in the outermost cells has no parabola and stays at their centres.
bool at_end(double place, double first, double last) {
  return first != last && (place == first || place == last);
}

void warn_if_at_edge(const Tool& tool, const Grid& grid, const StressMaximum& maximum) {
  const auto [nx, ny] = grid.shape;
  if (grid.periodic ||
      !(at_end(maximum.x, grid.x(0), grid.x(nx - 1)) || at_end(maximum.y, grid.y(0), grid.y(ny - 1))))
    return;
  tool.warn(fmt::format(
      "the largest von Mises stress lies at the edge of the domain, at ({:.4g}, {:.4g}) um: beyond "
      "it none is looked for; make the domain larger",
      maximum.x * 1e6, maximum.y * 1e6));
}

}  // namespace

StressMaximum search_maximum(const Tool& tool, StressScene& scene, const StressSolver& solver) {
  const StressMaximum top = scene.plane ? search(tool, scene.volume(solver.threads())) : search(tool, solver);
  record(scene.data.attributes, top);
  tool.detail(fmt::format("largest von Mises stress {:.6g} MPa, {:.6g} um deep, from {}",
                          top.von_mises * 1e-6, top.depth * 1e6, counted(top.layers, "layer")));
  if (top.von_mises == 0) return top;
  warn_if_shallow(tool, scene.body, top);
  warn_if_at_edge(tool, scene.body.grid, top);
  return top;
}

}  // namespace asperity::cli
