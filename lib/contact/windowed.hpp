/// The contact problem on one grid, solved on the window of it that matters.
///
/// Away from the contact p = 0, and nothing is wanted of the gap but that it be open. So the iteration sees a
/// window W, a rectangle of cells around the contact, with the operator of a body of that many cells:
///     W ← the least window of p > 0, with a margin
///     until ε ≤ tolerance on the grid:
///       minimise on W, p = 0 elsewhere                                          contact/guarded.hpp
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

#include <functional>
#include <optional>

#include "contact/guarded.hpp"
#include "contact/window.hpp"

namespace asperity {

class WindowedGradients {
 public:
  struct Limits {
    double tolerance = 1e-6;     ///< of ε
    double convolutions = 1000;  ///< on this grid, by their share
    bool confirm = true;         ///< on the whole grid, even where the iteration has seen it
    Index margin_part = 32;      ///< a margin is this part of the contact's length and width, and four cells
  };
  /// Told of every round.
  using Observer = std::function<void(const ContactResidual&, double convolutions)>;

  /// Shifts the problem's datum where round-off demands it.
  WindowedGradients(ElasticOperator& influence, ContactProblem& problem, Limits limits)
      : influence_(influence), problem_(problem), limits_(limits) {}

  /// Solves from `start`; `near` says that it is nearly the solution.
  ContactStop solve(Field start, bool near, const Observer& observe = {});

  /// The solution, to be read or moved away.
  Field& pressure() { return p_; }
  Field& gap() { return g_; }  ///< h + K p
  /// The window that holds it, and the body on that.
  const Window& window() const { return window_; }
  ElasticOperator& body() { return on_window_ ? *on_window_ : influence_; }
  const ContactResidual& residual() const { return residual_; }
  double convolutions() const { return convolutions_; }
  double preconditionings() const { return preconditionings_; }

 private:
  void choose(const Window& contact);
  bool is_whole() const { return window_ == whole(influence_.shape()); }
  ContactStop minimise(bool near, const Observer& observe);
  ContactStop minimise(ElasticOperator& influence, ContactProblem& problem, Field& p, Field& g, bool near,
                       const Observer& observe);
  void confirm();
  bool at_round_off(ContactStop on_window);

  ElasticOperator& influence_;
  ContactProblem& problem_;
  Limits limits_;
  Field p_, g_;
  Window contact_, window_;                     // what W must hold, and W
  std::shared_ptr<ElasticOperator> on_window_;  // none: the whole
  ContactResidual residual_;
  bool fresh_ = false;  // residual_ is that of the grid and of a fresh g
  double convolutions_ = 0, preconditionings_ = 0, best_ = 1;
  int rounds_without_gain_ = 0;
};

}  // namespace asperity
