/// The rectangle of a grid's cells that the iteration reads and writes: contact happens on a part of the domain.
///
/// Windows grow by union and margin, and are cut where the domain ends.
#pragma once

#include <algorithm>

#include "core/extent.hpp"
#include "core/field.hpp"

namespace asperity {

struct ContactWindow {
  Extent x, y;  ///< without lines: empty

  bool empty() const { return x.count == 0; }
  Shape shape() const { return {x.count, y.count}; }
  bool operator==(const ContactWindow&) const = default;

  Field of(const Field& f) const { return f.block(x.first, y.first, x.count, y.count); }
  void put(const Field& part, Field& into) const { into.block(x.first, y.first, x.count, y.count) = part; }
};

inline ContactWindow whole(Shape shape) { return {{0, shape.nx}, {0, shape.ny}}; }

/// The least window that holds both.
inline ContactWindow united(const ContactWindow& a, const ContactWindow& b) {
  if (a.empty() || b.empty()) return a.empty() ? b : a;
  auto along = [](Extent one, Extent other) -> Extent {
    const Index first = std::min(one.first, other.first);
    return {first, std::max(one.end(), other.end()) - first};
  };
  return {along(a.x, b.x), along(a.y, b.y)};
}

/// More cells on each side, within the domain.
inline ContactWindow widened(const ContactWindow& window, Index cells, Shape domain) {
  auto along = [cells](Extent held, Index n) -> Extent {
    const Index first = std::max<Index>(held.first - cells, 0);
    return {first, std::min(held.end() + cells, n) - first};
  };
  return {along(window.x, domain.nx), along(window.y, domain.ny)};
}

/// About the same middle, larger, within the domain; `shape` covers the window's.
inline ContactWindow enlarged(const ContactWindow& window, Shape shape, Shape domain) {
  auto along = [](Extent held, Index count, Index n) -> Extent {
    return {std::clamp<Index>(held.first - (count - held.count) / 2, 0, n - count), count};
  };
  return {along(window.x, shape.nx, domain.nx), along(window.y, shape.ny, domain.ny)};
}

/// The least window of the cells where holds(value): p > 0, or g < δ, which wants to be in contact.
template <class Holds>
ContactWindow window_of(const Field& f, Holds holds) {
  const auto [x, y] = extents(f, holds);
  return {x, y};
}

}  // namespace asperity
