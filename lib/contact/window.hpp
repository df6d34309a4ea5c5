/// The rectangle of a grid's cells that the iteration reads and writes: contact happens on a part of the domain.
///
/// Windows grow by union and margin, and are cut where the domain ends.
#pragma once

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
ContactWindow united(const ContactWindow& a, const ContactWindow& b);
/// More cells on each side, within the domain.
ContactWindow widened(const ContactWindow& window, Index cells, Shape domain);
/// About the same middle, larger, within the domain; `shape` covers the window's.
ContactWindow enlarged(const ContactWindow& window, Shape shape, Shape domain);

/// The least window that holds the cells where p > 0.
ContactWindow contact_window(const Field& p);
/// The least window that holds the cells where g < δ: whatever is not yet in contact wants to be.
ContactWindow overlap_window(const Field& g, double approach);

}  // namespace asperity
