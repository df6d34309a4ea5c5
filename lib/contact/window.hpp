/// A rectangle of a grid's cells.
///
/// Contact happens on a part of the domain. The window around it is what the iteration reads and writes;
/// windows grow by union and margin, and are cut where the domain ends.
#pragma once

#include "core/field.hpp"

namespace asperity {

struct Window {
  Index i = 0, j = 0;  ///< its first cell
  Shape shape;         ///< without cells: empty

  bool empty() const { return shape.cells() == 0; }
  bool operator==(const Window&) const = default;

  Field of(const Field& f) const { return f.block(i, j, shape.nx, shape.ny); }
  void put(const Field& part, Field& into) const { into.block(i, j, shape.nx, shape.ny) = part; }
};

inline Window whole(Shape shape) { return {0, 0, shape}; }

/// The least window that holds both.
Window united(const Window& a, const Window& b);
/// More cells on each side, within the domain.
Window widened(const Window& window, Index cells, Shape domain);
/// About the same middle, larger, within the domain; `shape` covers the window's.
Window enlarged(const Window& window, Shape shape, Shape domain);

/// The least window that holds the cells where p > 0.
Window contact_window(const Field& p);
/// The least window that holds the cells where g < δ: whatever is not yet in contact wants to be.
Window overlap_window(const Field& g, double approach);

}  // namespace asperity
