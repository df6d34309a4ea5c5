/// The contact problem on one grid, solved on a window around the contact.
///
/// Away from the contact p = 0, and the gap only has to be open. The iteration therefore works on a window W,
/// a rectangle of cells around the contact, with the operator of a body of that size:
///     W ← the least window of p > 0, with a margin
///     until ε ≤ tolerance on the grid:
///       minimise on W, p = 0 elsewhere                                 contact/bound_constrained_cg.hpp
///       g ← h + K p on the grid                                    one application of the whole K
///       W ← W ∪ the least window of g < δ, with a margin
/// W only grows, and the energy falls. Whatever ends the iteration on W, even round-off, W grows while there
/// is a violation outside; only the limit of convolutions stops this. W is the whole grid if the start is in
/// contact everywhere, if a window would not save time, or if p_Y on W does not carry the load.
///
/// Accuracy  ε is that of the last g on the grid, which no recurrence has touched.
/// Cost      an application of K or M on W costs, and counts, as the share that W has of the grid's cells.
#pragma once

#include <algorithm>
#include <memory>

#include "contact/bound_constrained_cg.hpp"
#include "contact/calibration.hpp"
#include "core/extent.hpp"

namespace asperity {

/// A rectangle of a grid's cells.
struct ContactWindow {
  Extent x, y;  ///< without lines: empty

  bool empty() const { return x.count == 0; }
  Shape shape() const { return {x.count, y.count}; }
  bool operator==(const ContactWindow&) const = default;

  /// The part of a field: from the rows that this rank has of it to those that it has of the part.
  Field of(const Field& f, const Slabs& field, const Slabs& part) const;
  /// The part back into the field.
  void put(const Field& values, const Slabs& part, Field& f, const Slabs& field) const;
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

/// The least window that holds those of all ranks.
ContactWindow least_of_all(const Ranks& ranks, const ContactWindow& own);

/// The least window of the cells where holds(value): p > 0, or g < δ, which wants to be in contact.
template <class Holds>
ContactWindow window_of(const Field& f, const Slabs& slabs, Holds holds) {
  auto [x, y] = extents(f, holds);
  x.first += slabs.own().first;
  return least_of_all(slabs.ranks(), {x, y});
}

/// A rectangle that holds the contact, and the body on it.
struct WindowBody {
  ContactWindow contact, window;               ///< what the window must hold, and the window
  std::shared_ptr<ElasticOperator> influence;  ///< none: the whole
};

struct WindowedSolution : ContactSolution {
  WindowBody body;
};

struct WindowedLimits {
  double tolerance = 1e-6;                   ///< of ε
  double convolutions = 1000;                ///< on this grid, by their share
  bool confirm = true;                       ///< on the whole grid, even where the iteration has seen it
  Index margin_part = contact::margin_part;  ///< a margin is this part of the contact's sides
};

/// Solves from a pressure; `near`: nearly the solution. May shift the problem's datum.
WindowedSolution minimise_on_window(ContactProblem& problem, Field start, bool near,
                                    const WindowedLimits& limits, const ContactObserver& observe);

}  // namespace asperity
