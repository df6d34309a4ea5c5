#include "stress/section.hpp"

#include <numbers>

namespace asperity {
namespace {

Grid turned(const Grid& g) { return {{g.shape.ny, g.shape.nx}, g.dy, g.dx, g.periodic}; }
Friction turned(const Friction& f) { return {f.coefficient, 0.5 * std::numbers::pi - f.angle}; }

constexpr std::array exchanged{stress::yy, stress::xx, stress::zz, stress::xy, stress::yz, stress::xz};

}  // namespace

StressSection::StressSection(const Grid& grid, const Field& pressure, const Friction& friction,
                             double poisson, Plane plane, int threads, DepthResolution resolution)
    : plane_(plane),
      solver_(plane.along_x ? turned(grid) : grid, plane.along_x ? Field(pressure.transpose()) : pressure,
              plane.along_x ? turned(friction) : friction, poisson, threads, resolution) {}

void StressSection::rows(const std::vector<double>& depths, stress::Set asked,
                         const StressSolver::LayerRowSink& row,
                         const StressSolver::LayersFinished& finished) const {
  if (!plane_.along_x) return solver_.layer_rows(depths, plane_.index, asked, row, finished);
  stress::Set needed;
  for (stress::Component c : stress::components)
    if (asked[c]) needed.set(exchanged[c]);
  auto turned_back = [&](Index l, Index i, const StressRow& values) {
    StressRow out{};
    for (stress::Component c : stress::components) out[c] = values[exchanged[c]];
    row(l, i, out);
  };
  solver_.layer_rows(depths, plane_.index, needed, turned_back, finished);
}

}  // namespace asperity
