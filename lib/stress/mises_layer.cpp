#include "stress/mises_layer.hpp"

#include <cmath>

#include "core/memory.hpp"

namespace asperity {
namespace {

using Row = Eigen::Array<double, 1, Eigen::Dynamic>;

double differences(double xx, double yy, double zz) {
  const double a = xx - yy, b = yy - zz, c = zz - xx;
  return a * a + b * b + c * c;
}

}  // namespace

MisesLayer::MisesLayer(Shape layer) : a_(large_field(layer)), b_(large_field(layer)) {}

void MisesLayer::add(stress::Component c, Index i, std::span<const double> values) {
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

void MisesLayer::row(Index i, double factor, std::span<double> out) const {
  for (Index j = 0; j < a_.cols(); ++j) out[size(j)] = factor * std::sqrt(0.5 * a_(i, j) + 3 * b_(i, j));
}

}  // namespace asperity
