/// Stress in a vertical plane x = x_i or y = y_j through cell centres, without the volume around it.
///
/// Of each layer only the row in the plane is computed (StressSolver::layer_rows): the way back in x is one sum a
/// column and that in y one row. A plane y = y_j is the plane x = x_j of the problem with x and y exchanged,
///     σxx ↔ σyy,   σxz ↔ σyz,   α → π/2 - α.                                                           (1)
/// Accuracy  that of stress/layers.hpp.
/// Cost      0.6 of the volume's; memory as of a layer.
#pragma once

#include "stress/layers.hpp"

namespace asperity {

struct Plane {
  bool along_x = true;  ///< y = y_index; else x = x_index
  Index index = 0;
};

class StressSection {
 public:
  StressSection(const Grid& grid, const Field& pressure, const Friction& friction, double poisson,
                Plane plane, int threads = 1, DepthResolution resolution = DepthResolution::full);

  /// Values in a row: nx, or ny of a plane along y.
  Index points() const { return solver_.grid().shape.ny; }
  /// As StressSolver::layers, a row a layer: row(layer, index, values).
  void rows(const std::vector<double>& depths, stress::Set asked, const StressSolver::LayerRowSink& row,
            const StressSolver::LayersFinished& finished = {}) const;

 private:
  Plane plane_;
  StressSolver solver_;
};

}  // namespace asperity
