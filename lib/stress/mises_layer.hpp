/// The von Mises stress of a layer from one component after the other.
///
///     σ_vM = √(½ A + 3 B),   A = (σxx-σyy)² + (σyy-σzz)² + (σzz-σxx)²,   B = σxy² + σxz² + σyz²        (1)
///
/// is that of stress/equivalent.hpp to the last bit. A waits for three components, of which two are kept; B
/// takes the place of the second. Memory: two fields, where six components at once take six.
#pragma once

#include <span>

#include "core/field.hpp"
#include "stress/component.hpp"

namespace asperity {

class MisesLayer {
 public:
  explicit MisesLayer(Shape layer);

  /// Row i of a component, all rows of which come in the order xx, yy, zz, xy, xz, yz.
  void add(stress::Component c, Index i, std::span<const double> values);
  /// When all have come, times a factor.
  void row(Index i, double factor, std::span<double> out) const;

 private:
  Field a_, b_;
};

}  // namespace asperity
