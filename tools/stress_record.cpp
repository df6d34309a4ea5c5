#include "stress_record.hpp"

#include "dataset/layout.hpp"

namespace asperity::cli {

void forget_stress(Dataset& data) {
  for (const StressQuantity& quantity : stress_quantities())
    for (const auto& output : quantity.outputs) data.erase(output.name);
  for (const char* name : {"stress_max_von_mises", "stress_max_x", "stress_max_y", "stress_max_depth"})
    data.attributes.erase(name);
}

void record_volumes(Dataset& data, const StressSolver& solver, const std::vector<double>& depths,
                    const StressSelection& selection) {
  const Shape shape = solver.grid().shape;
  const auto outputs = selection.outputs();
  std::vector<std::vector<double>> volumes(
      outputs.size(), std::vector<double>(depths.size() * static_cast<std::size_t>(shape.cells())));
  solver.layers(depths, selection.needs(), [&](Index l, Index i, const StressRow& row) {
    std::vector<double*> out;
    for (auto& volume : volumes) out.push_back(volume.data() + (l * shape.nx + i) * shape.ny);
    selection.compute(row, shape.ny, out.data());
  });
  set_depths(data, depths);
  for (std::size_t k = 0; k < outputs.size(); ++k)
    set_volume(data, outputs[k].name, std::move(volumes[k]), {outputs[k].units, outputs[k].long_name});
}

void record_maximum(Attributes& a, const StressMaximum& m) {
  a.set("stress_max_von_mises", m.von_mises);
  a.set("stress_max_x", m.x);
  a.set("stress_max_y", m.y);
  a.set("stress_max_depth", m.depth);
}

void record_parameters(Attributes& a, const StressOptions& options, const StressSolver& solver) {
  a.set("stress_poisson", solver.poisson());
  a.set("stress_resolution", options.resolution);
  a.set("stress_accurate_depth", accurate_depth(solver.grid()));
  const Friction friction = options.sliding();
  a.set("stress_friction", friction.coefficient);
  a.erase("stress_friction_angle");
  if (friction.coefficient > 0) a.set("stress_friction_angle", friction.angle);
}

}  // namespace asperity::cli
