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

/// The same box with more cells at the sides that are asked for, or another quarter of its depth.
struct BoxSides {
  bool west = false, east = false, south = false, north = false, bottom = false;
  bool any() const { return west || east || south || north || bottom; }
};
PlasticBox grown(const PlasticBox& box, const BoxSides& sides, const Grid& grid);

}  // namespace asperity
