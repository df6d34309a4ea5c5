/// The part of a body that will flow: a window of the grid's cells, and layers below it.
///
/// Where a pressure stresses the body beyond its yield stress it flows, and hardly elsewhere; only this box
/// has plastic strain, the rest of the half-space is elastic. The pressure is best one that flow has limited
/// already, the contact's with a limit of 3 σ_Y: the elastic one reaches too deep. What flows beyond is
/// found out later, and the box grown.
///
/// Layers are thin at the surface, a quarter of a cell where asperities flow, else up to half a cell, and
/// thicken by a constant ratio.
#pragma once

#include <vector>

#include "core/extent.hpp"
#include "core/field.hpp"

namespace asperity {

struct PlasticBox {
  Extent x, y;                ///< cells of the grid
  std::vector<double> edges;  ///< of layers [m], the first one 0

  Index layers() const { return static_cast<Index>(edges.size()) - 1; }
  /// The part of a field above it.
  template <class Whole>
  auto of(Whole&& field) const {
    return field.block(x.first, y.first, x.count, y.count);
  }
  Grid grid(const Grid& whole) const { return {{x.count, y.count}, whole.dx, whole.dy, whole.periodic}; }
  bool operator==(const PlasticBox&) const = default;
};

/// How much deeper than the pressure yields the layers of yielding_box reach.
inline constexpr double deeper_box = 1.25;

/// 0 = z_0 < … < z_n = depth, the first layer at most `first` thick.
std::vector<double> graded_layers(double depth, double first, Index layers);

/// Around the contact and what a pressure stresses beyond `yield` [Pa], with a margin; without layers if
/// that is nowhere.
PlasticBox yielding_box(const Grid& grid, const Field& pressure, double poisson, double yield, Index layers,
                        int threads = 1);

/// The cells of the grid that something takes, and the layers, down to the deepest.
struct FlowReach {
  Extent x, y;
  Index layers = 0;

  /// With a run of cells, and a layer.
  void add(Extent in_x, Extent in_y, Index to_layer = 0);
};

/// The same box with more cells at the sides that are reached, and another quarter of its depth.
PlasticBox grown(const PlasticBox& box, const FlowReach& reached, const Grid& grid);

}  // namespace asperity
