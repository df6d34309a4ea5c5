/// The smooth part of the stress near a surface: (1 - w) K of stress/shallow.hpp (1), from wide cells.
///
/// At four depths, at the middles of cells four times as long and wide, the layer below their mean pressures
/// less what w K makes of the cells within 16; at other depths the cubic through the four. A load periodic in
/// both directions is one of waves, whose field at the surface of so wide cells is not that of steps: there
/// the depths begin at 2 Δ, half a wide cell, else at the surface.
#pragma once

#include <array>

#include "stress/load.hpp"

namespace asperity {

class FarStress {
 public:
  static constexpr Index wide = 4;
  using Weights = std::array<double, 4>;

  FarStress(const LoadedBody& body, int threads);

  Shape shape() const { return shape_of(layers_[0][0]); }
  /// Of the four layers, at depth z [m].
  Weights weights(double z) const;
  stress::Tensor at(const Weights& weights, Index i, Index j) const;

 private:
  Weights depths_;
  std::array<std::array<Field, 6>, 4> layers_;
};

}  // namespace asperity
