/// The contact problem on one grid, solved on the window of it that matters.
///
/// Away from the contact p = 0, and nothing is wanted of the gap but that it be open. So the iteration sees a
/// window W, a rectangle of cells around the contact, with the operator of a body of that many cells:
///     W ← the least window of p > 0, with a margin
///     until ε ≤ tolerance on the grid:
///       minimise on W, p = 0 elsewhere                                 contact/bound_constrained_cg.hpp
///       g ← h + K p on the grid                                    one application of the whole K
///       W ← W ∪ the least window of g < δ, with a margin
/// W grows only, and the energy falls. Whatever ends the iteration on W, round-off too, the grid is looked at and W
/// grows while there is a violation outside; only the limit of convolutions ends it without. W is the whole grid where
/// the start is in contact everywhere, where the body has no windows or none worth it, and where the limit pressure on
/// W would not carry the load.
///
/// Accuracy  ε is that of the last g on the grid, which no recurrence has touched.
/// Cost      an application of K or M on W costs, and counts, as the share that W has of the grid's cells.
#pragma once

#include <memory>

#include "contact/bound_constrained_cg.hpp"
#include "contact/window.hpp"
#include "core/calibration.hpp"

namespace asperity {

/// A rectangle that holds the contact, and the body on it.
struct WindowBody {
  ContactWindow contact, window;               ///< what the window must hold, and the window
  std::shared_ptr<ElasticOperator> influence;  ///< none: the whole
};

struct WindowedSolution : ContactSolution {
  WindowBody body;
};

struct WindowedLimits {
  double tolerance = 1e-6;     ///< of ε
  double convolutions = 1000;  ///< on this grid, by their share
  bool confirm = true;         ///< on the whole grid, even where the iteration has seen it
  Index margin_part = calibration::contact::margin_part;  ///< a margin is this part of the contact's sides
};

/// Solves from a pressure; `near` says that it is nearly the solution. Shifts the problem's datum where round-off
/// demands it.
WindowedSolution minimise_on_window(ElasticOperator& influence, ContactProblem& problem, Field start,
                                    bool near, const WindowedLimits& limits,
                                    const ContactObserver& observe = {});

}  // namespace asperity
