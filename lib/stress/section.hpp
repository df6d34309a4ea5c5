/// Stress in a vertical plane x = x_i or y = y_j through cell centres, without the volume around it.
///
/// Of each layer only the row in the plane is computed, from the influence transformed along the plane alone
/// (stress/plane_load.hpp); nothing is transformed across it. A plane y = y_j is the plane x = x_j of the problem with x
/// and y exchanged,
///     σxx ↔ σyy,   σxz ↔ σyz,   α → π/2 - α.                                                           (1)
/// Accuracy  that of stress/layers.hpp; at depths of wider cells nothing is interpolated across the plane, as it is in a
///           volume, whose rows differ by 1e-7 of the largest pressure.
/// Cost      a seventh of the volume's, with wider cells a fifth, and less the more the load is gathered about the
///           plane; memory below that of a layer.
#pragma once

#include "stress/layers.hpp"
#include "stress/plane_load.hpp"

namespace asperity {

struct Plane {
  bool along_x = true;  ///< y = y_index; else x = x_index
  Index index = 0;
};

class StressSection {
 public:
  /// Throws as check_load does.
  StressSection(const Grid& grid, const Field& pressure, const Friction& friction, double poisson,
                Plane plane, int threads = 1, DepthResolution resolution = DepthResolution::full);

  /// Values in a row: nx, or ny of a plane along y.
  Index points() const { return grid_.shape.ny; }
  /// As StressSolver::layers, a row a layer: row(layer, index, values).
  void rows(const std::vector<double>& depths, stress::Set asked, const LayerRowSink& row,
            const LayersFinished& finished = {}) const;

 private:
  /// What one thread needs, by resolution.
  struct Workspace {
    struct Level {
      std::unique_ptr<LayerInfluence> influence;
      std::unique_ptr<const RowTransform> transform;
      RowTransform::Work rows;
      AlignedVector<Complex> modes;   ///< of the row: [block][asked component][8]
      AlignedVector<double> samples;  ///< six rows of `stride`
      Index stride = 0;
    };
    std::vector<Level> levels;
    std::array<AlignedVector<double>, 6> refined;
  };

  const PlaneLoad& load(std::size_t level) const;
  Workspace::Level& prepared(Workspace& work, std::size_t level) const;
  StressRow row_at(double z, stress::Set asked, Workspace& work) const;
  /// Row `r` of the modes: component c.
  void compute_modes(const PlaneLoad& load, stress::Component c, Index r, Workspace::Level& level) const;

  Plane plane_;  ///< the rest is of the problem turned so that the plane is x = x_index
  Grid grid_;
  Field pressure_;
  std::array<double, 3> weights_;
  double poisson_;
  int threads_;
  DepthLevels<PlaneLoad> levels_;
};

}  // namespace asperity
