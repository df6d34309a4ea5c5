/// Two contact solvers that the library does without, to measure its own by.
///
/// Polonsky and Keer's conjugate gradients [1] take the cells in contact as they are, step, cut negative
/// pressures off, let cells that overlap back in, and rescale. g follows by recurrence where nothing was cut,
/// so that most steps take one application of K (theirs take two). With a limit pressure the cut is made
/// there too.
///
/// The spectral projected gradient [2] is what contact/bound_constrained_cg.hpp falls back on, here alone:
/// one application of K a step.
///
/// [1] I. A. Polonsky, L. M. Keer, Wear 231 (1999) 206-219.
/// [2] E. G. Birgin, J. M. Martínez, M. Raydan, SIAM J. Optim. 10 (2000) 1196-1211.
#pragma once

#include <functional>

#include "contact/problem.hpp"

namespace asperity {

/// Told ε and the applications of K so far; false ends the solution.
using Watch = std::function<bool(const ContactResidual&, int convolutions)>;

void polonsky_keer(const ContactProblem& problem, const Watch& watch);
void projected_gradient(const ContactProblem& problem, const Watch& watch);

}  // namespace asperity
