#include "tools/contact/scene.hpp"

#include <cmath>

#include <fmt/format.h>

#include "dataset/layout.hpp"
#include "tools/cli/grid_words.hpp"

namespace asperity::cli {
namespace {

Grid smooth_grid(const ContactOptions& o) {
  if (o.shape.cells() == 0) throw UsageError("shape", "is needed with --smooth");
  for (double side : o.size)
    if (!(side > 0 && std::isfinite(side)))
      throw UsageError("size", "is needed with --smooth, both sides above 0");
  return {o.shape, o.size[0] / static_cast<double>(o.shape.nx), o.size[1] / static_cast<double>(o.shape.ny),
          o.boundary == "periodic"};
}

// A periodic surface may be pressed as a single patch; one that is not does not become periodic by being told so.
bool periodic(const ContactOptions& o, const Grid& grid) {
  if (o.boundary == "periodic" && !grid.periodic)
    throw UsageError("boundary",
                     "periodic needs a surface that continues itself at its edges, and the grid says that "
                     "this one does not (asperity-generate --periodic draws one)");
  const bool out = o.boundary.empty() ? grid.periodic : o.boundary == "periodic";
  if (out && !o.bodies.flat())
    throw UsageError(o.radius_option,
                     "a periodic surface has no radius: leave it out, or press with --boundary free");
  return out;
}

Field counter_heights(const Tool& tool, const std::string& name, const Grid& grid, std::size_t held) try {
  tool.reads(name);
  const Dataset data = tool.read(name, held);
  const Grid own = grid_of(data);
  if (!same_grid(own, grid))
    throw DataError("counter", fmt::format("its grid, {}, is not that of the first body, {}", described(own),
                                           described(grid)));
  return field_of(data, "heights", "m");
} catch (const DataError& e) {
  throw DataError(e.name, fmt::format("in {}: {}", name, e.what()));
}

}  // namespace

ContactScene read_scene(const Tool& tool, const ContactOptions& o) {
  constexpr double bytes_a_cell = 120;
  ContactScene scene;
  scene.grid = o.smooth ? smooth_grid(o) : grid_of(scene.data = tool.read(o.input));
  const Shape shape = scene.grid.shape;
  tool.require_memory(bytes_a_cell * static_cast<double>(shape.cells()), o.smooth ? "shape" : "memory",
                      fmt::format("a contact of {}x{} cells", shape.nx, shape.ny));
  if (o.smooth) set_grid(scene.data, scene.grid);
  const Grid given = scene.grid;
  scene.grid.periodic = periodic(o, given);
  for (const char* axis : {"x", "y"})
    scene.data.find(axis)->attributes.set("periodic", scene.grid.periodic ? 1 : 0);

  scene.gap = undeformed_gap(scene.grid, o.bodies);
  if (!o.smooth) scene.gap -= field_of(scene.data, o.variable, "m");
  if (!o.counter.empty()) scene.gap -= counter_heights(tool, o.counter, given, scene.data.size_in_memory());
  return scene;
}

}  // namespace asperity::cli
