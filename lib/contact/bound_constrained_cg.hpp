/// Bound-constrained conjugate gradients: the contact problem on the cells of one operator.
///
///     p ← clip and rescale the start,  g ← h + K p;  under a given approach, the multiple of least energy
///     until ε ≤ tolerance:
///       subspace step F ← free cells and cells that want off their bound            contact/subspace_cg.hpp
///                     minimise on F by preconditioned conjugate gradients
///                     within bounds: take it.  Otherwise clip, rescale, and take it if the energy falls
///                     as it should (guarded step); if not, go along it to the lowest point and
///       gradient step p ← p + λ (Proj(p - α (g - δ)) - p),  λ = min(1, -(g-δ)·d / d·Kd)
///                     a few times; also when ε has not halved in four rounds, or |F| < 2
///
/// The finer the grid, the more ragged is a set with holes and islands of any size. Where F has far more edge
/// than a disc, on 128² cells or more, a subspace step
///   - takes the preconditioner of contact/two_level.hpp, and goes on to a tenth of the residual,
///   - leaves cells on their bound that are driven off it by little (FreeSet::proportion),
///   - relaxes what it found within the bounds before it is clipped (contact/relaxation.hpp).
/// On such sets a relaxation from p, as far as the energy falls, takes the place of the gradient steps after
/// a guarded step that was refused; they follow if it fails.
///
/// Cells leave a bound when F is built, in a relaxation or in a gradient step; they join one in these and
/// in guarded steps, and exactly. Whatever proposes a pressure, it is clipped and rescaled, and taken
/// only as far as the energy falls, which K d shows: every iterate is feasible and the energy falls,
/// so that the sets cannot cycle. On F, which always holds the free cells, the gradients go on while no
/// bound is violated, and once the residual has fallen to a quarter they stop at the first violation, and
/// where it has grown a thousandfold, for at round-off directions are noise.
///
/// Accuracy  g follows p by recurrence, K d on large grids to single precision, fresh and to double after 50
///           updates; contact/windowed.hpp confirms ε. What a step leaves is 4e-7 of its own size: from
///           ε = 1e-8 on some contacts take a round more.
/// Cost      one K a step, one M a conjugate gradient step, a few passes over the cells; six fields and a
///           mask, on ragged sets three fields more.
///
/// E. G. Birgin, J. M. Martínez, M. Raydan, Nonmonotone spectral projected gradient methods on convex sets,
/// SIAM J. Optim. 10 (2000) 1196-1211; J. J. Moré, G. Toraldo, On the solution of large quadratic programming
/// problems with bound constraints, SIAM J. Optim. 1 (1991) 93-113.
#pragma once

#include <functional>
#include <limits>

#include "contact/problem.hpp"

namespace asperity {

enum class ContactStop { converged, convolution_limit, round_off };

struct ContactStart {
  Field p;            ///< [Pa]
  Field g = {};       ///< h + K p [m]; made where it is empty
  bool near = false;  ///< p is nearly the solution
};

struct ContactSolution {
  Field p;            ///< [Pa]
  Field g;            ///< h + K p [m]
  bool fresh = true;  ///< g comes from one convolution, not from recurrences
  ContactResidual residual = {};
  ContactStop stop = ContactStop::converged;
  double convolutions = 0, preconditionings = 0;  ///< applications of K and of M
};

/// Called after every round.
using ContactObserver = std::function<void(const ContactResidual&, double convolutions)>;

/// Counts the rounds since a number last fell below a share of its mark, which is then set to it.
class Stagnation {
 public:
  explicit Stagnation(double share) : share_(share) {}

  int add(double value) {
    if (!(value < share_ * mark_)) return ++rounds_;
    restart(value);
    return 0;
  }
  void restart(double mark) { mark_ = mark, rounds_ = 0; }
  double mark() const { return mark_; }

 private:
  double share_, mark_ = std::numeric_limits<double>::infinity();
  int rounds_ = 0;
};

/// Ends at this ε, after about so many convolutions, or at round-off, which may shift the problem's datum.
ContactSolution minimise(ContactProblem& problem, ContactStart start, double tolerance, double convolutions,
                         const ContactObserver& observe = {});

}  // namespace asperity
