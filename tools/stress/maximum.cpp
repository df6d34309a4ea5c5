#include "tools/stress/maximum.hpp"

#include <fmt/format.h>

#include "core/words.hpp"
#include "tools/cli/progress.hpp"

namespace asperity::cli {
namespace {

constexpr double round_off = 1e-12;  // of a pressure that is balanced to it

// How a criterion is called: by --of, by the attribute of its maximum, and in a message.
struct Words {
  const char *of, *attribute, *text;
};

constexpr Words words_of(Criterion of) {
  switch (of) {
    case Criterion::von_mises:
      return {"von_mises", "stress_max_von_mises", "von Mises stress"};
    case Criterion::max_shear:
      return {"max_shear", "stress_max_shear", "shear stress"};
    case Criterion::principal:
      return {"principal", "stress_max_principal", "principal stress"};
  }
  return {};
}

// `layers`: those of a dataset follow.
StressMaximum search_layers(const Tool& tool, const StressSolver& volume, const StressSearch& search,
                            bool layers) {
  Progress progress(tool, layers ? 0.5 : 1);
  StepTable probes(tool, {"layer", "depth [um]", fmt::format("greatest {} [MPa]", words_of(search.of).of)});
  return maximum_stress(volume, search, [&](const StressProbe& p) {
    progress.count(static_cast<double>(p.done), static_cast<double>(p.expected), "layers searched");
    probes.row({std::to_string(p.done), fmt::format("{:.6g}", p.depth * 1e6),
                fmt::format("{:.6g}", p.value * 1e-6)});
  });
}

void warn_if_shallow(const Tool& tool, const LoadedBody& body, const StressMaximum& maximum,
                     const char* what) {
  const auto& [grid, pressure, poisson, friction] = body;
  const double accurate = accurate_depth(grid), spread = pressure.maxCoeff() - pressure.minCoeff();
  const bool uniform = grid.periodic.both() && spread <= round_off * pressure.maxCoeff();  // at any depth
  if (maximum.depth >= accurate || uniform) return;
  tool.warn(
      fmt::format("the largest {} lies {:.4g} um deep, less than the {:.4g} um of "
                  "stress_accurate_depth: it rests on single cells and may be off by {:.0f} % of the "
                  "largest pressure; refine the grid",
                  what, maximum.depth * 1e6, accurate * 1e6, 100 * shallow_error(poisson, friction)));
}

// A maximum in the outermost cells has no parabola through it and stays at their centres.
bool at_end(double place, double first, double last) {
  return first != last && (place == first || place == last);
}

void warn_if_at_edge(const Tool& tool, const Grid& grid, const StressMaximum& maximum, const char* what) {
  const auto [nx, ny] = grid.shape;
  const bool in_x = !grid.periodic.x && at_end(maximum.x, grid.x(0), grid.x(nx - 1)),
             in_y = !grid.periodic.y && at_end(maximum.y, grid.y(0), grid.y(ny - 1));
  if (!in_x && !in_y) return;
  tool.warn(
      fmt::format("the largest {} lies at the edge of the domain, at ({:.4g}, {:.4g}) um, and may be "
                  "larger beyond it; choose a larger domain",
                  what, maximum.x * 1e6, maximum.y * 1e6));
}

}  // namespace

StressSearch search_of(const StressOptions& options, const Grid& grid) {
  StressSearch search;
  for (Criterion c : {Criterion::von_mises, Criterion::max_shear, Criterion::principal})
    if (options.of == words_of(c).of) search.of = c;
  if (!options.below.empty()) search.below = depth_on(grid, "below", options.below, StressSearch::deepest);
  return search;
}

StressMaximum find_maximum(const Tool& tool, StressScene& scene, const StressSearch& search,
                           const StressSolver& solver) {
  const auto [of, attribute, what] = words_of(search.of);
  const StressMaximum top = search_layers(tool, solver, search, !scene.depths.empty());
  Attributes& a = scene.data.attributes;
  a.set(attribute, top.value);
  a.set("stress_max_x", top.x);
  a.set("stress_max_y", top.y);
  a.set("stress_max_depth", top.depth);
  if (search.below > 0) a.set("stress_max_below", search.below);
  tool.detail(fmt::format("largest {} {:.6g} MPa, {:.6g} um deep, from {}", what, top.value * 1e-6,
                          top.depth * 1e6, counted(top.layers, "layer")));
  if (top.value == 0) return top;
  if (search.below > 0 && top.depth == search.below)
    tool.note(fmt::format("the largest {} lies at the depth of --below; above it, it is larger", what));
  warn_if_shallow(tool, scene.body, top, what);
  warn_if_at_edge(tool, scene.body.grid, top, what);
  return top;
}

}  // namespace asperity::cli
