/// The von Mises stress of a layer from one component after the other.
///
///     σ_vM = √(½ A + 3 B),   A = (σxx-σyy)² + (σyy-σzz)² + (σzz-σxx)²,   B = σxy² + σxz² + σyz²        (1)
///
/// is that of stress/equivalent.hpp to the last bit. A waits for three components, of which two are kept; B
/// takes the place of the second. Memory: two fields, where six components at once take six.
#pragma once

#include <span>

#include "core/large_field.hpp"
#include "stress/equivalent.hpp"

namespace asperity {

class MisesLayer {
 public:
  explicit MisesLayer(Shape layer) : a_(large_field(layer)), b_(large_field(layer)) {}

  /// Row i of a component, all rows of which come in the order xx, yy, zz, xy, xz, yz.
  void add(stress::Component c, Index i, std::span<const double> values) {
    const auto s = Eigen::Map<const Row>(values.data(), a_.cols());
    switch (c) {
      case stress::xx:
        a_.row(i) = s;
        break;
      case stress::yy:
        b_.row(i) = s;
        break;
      case stress::zz:
        for (Index j = 0; j < s.size(); ++j) a_(i, j) = differences(a_(i, j), b_(i, j), s(j));
        break;
      case stress::xy:
        b_.row(i) = s;
        break;
      case stress::xz:  // the first square waits, for a compiler may fuse it with this sum
        for (Index j = 0; j < s.size(); ++j) b_(i, j) = b_(i, j) * b_(i, j) + s(j) * s(j);
        break;
      case stress::yz:
        for (Index j = 0; j < s.size(); ++j) b_(i, j) = b_(i, j) + s(j) * s(j);
    }
  }
  /// When all have come, times a factor.
  void row(Index i, double factor, std::span<double> out) const {
    for (Index j = 0; j < a_.cols(); ++j) out[size(j)] = factor * std::sqrt(0.5 * a_(i, j) + 3 * b_(i, j));
  }

 private:
  static double differences(double xx, double yy, double zz) {
    const double a = xx - yy, b = yy - zz, c = zz - xx;
    return a * a + b * b + c * c;
  }

  using Row = Eigen::Array<double, 1, Eigen::Dynamic>;

  Field a_, b_;
};

}  // namespace asperity
