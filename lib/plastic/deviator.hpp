/// Deviators of strain and stress as five numbers, and fields of them in layers below the surface.
///
/// Plastic flow keeps the volume, and von Mises' condition knows no mean stress: both need deviators alone.
/// In the basis
///     d0 = (xx - yy)/√2,   d1 = √(3/2) zz,   d2 = √2 xy,   d3 = √2 xz,   d4 = √2 yz                    (1)
/// the Euclidean product of two deviators is a:b, so that with s of the stress, e of the plastic strain,
///     σ_vM = √(3/2) |s|,   the equivalent strain = √(2/3) |e|.                                         (2)
/// A rotation by θ about z turns (d0, d2) by 2θ, (d3, d4) by θ, and keeps d1.
///
/// Layers are bounded by edges 0 = z_0 < z_1 < … < z_n; values are means over a layer at the cell centres.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/field.hpp"
#include "stress/component.hpp"

namespace asperity {

namespace deviator {

inline constexpr Index components = 5;
using Vector = std::array<double, 5>;

inline const double root_half = 1 / std::numbers::sqrt2, root_sixth = 1 / std::sqrt(6.0),
                    root_two_thirds = 2 * root_sixth, root_three_halves = std::sqrt(1.5);

/// (1) of a tensor, whose mean is left out.
inline Vector of(const stress::Tensor& t) {
  using namespace stress;
  return {root_half * (t[xx] - t[yy]), root_sixth * (2 * t[zz] - t[xx] - t[yy]), std::numbers::sqrt2 * t[xy],
          std::numbers::sqrt2 * t[xz], std::numbers::sqrt2 * t[yz]};
}

/// (1) of the tensor whose only component is this one, 1.
inline Vector of(stress::Component c) {
  stress::Tensor unit{};
  unit[c] = 1;
  return of(unit);
}

/// The tensor with this mean.
inline stress::Tensor tensor(const Vector& d, double mean = 0) {
  const double across = mean - root_sixth * d[1];
  return {across + root_half * d[0], across - root_half * d[0], mean + root_two_thirds * d[1],
          root_half * d[2],          root_half * d[3],          root_half * d[4]};
}

/// Whether a component is odd in x, or in y, where the surface is loaded evenly.
constexpr bool odd_in_x(Index c) { return c == 2 || c == 3; }
constexpr bool odd_in_y(Index c) { return c == 2 || c == 4; }

}  // namespace deviator

/// So many numbers in every cell of every layer: [layer][component][x][y].
class LayeredField {
 public:
  LayeredField() = default;
  LayeredField(Index layers, Index components, Shape shape)
      : values(Eigen::ArrayXd::Zero(layers * components * shape.cells())),
        components_(components),
        shape_(shape) {}

  Shape shape() const { return shape_; }
  Index components() const { return components_; }
  Index layers() const { return values.size() / std::max<Index>(components_ * shape_.cells(), 1); }
  Index cells() const { return shape_.cells(); }
  Eigen::Map<Field> operator()(Index layer, Index component) {
    return {values.data() + place(layer, component), shape_.nx, shape_.ny};
  }
  Eigen::Map<const Field> operator()(Index layer, Index component) const {
    return {values.data() + place(layer, component), shape_.nx, shape_.ny};
  }

  Eigen::ArrayXd values;

 private:
  Index place(Index layer, Index component) const {
    return (layer * components_ + component) * shape_.cells();
  }

  Index components_ = 0;
  Shape shape_;
};

}  // namespace asperity
