/// The ways to a kernel, each from the problem to a candidate, if it has one.
#pragma once

#include <optional>
#include <vector>

#include "acf/kernel_problem.hpp"

namespace asperity {

struct Attempt {
  std::optional<Kernel> candidate = {};
  IterationResult effort =
      {};  ///< its reason, where there is one, says what kept the attempt from the solution
  std::vector<double> unknowns = {};  ///< where least squares have come to
};

/// The root of what is positive of the spectrum, on a torus of four times the lags.
Attempt spectral_root(const KernelProblem& problem, Answer answer);
/// Newton's iteration from the windowed root: a candidate where it converges.
Attempt newton(const KernelProblem& problem);
/// The best that these come to.
Attempt fixed_point(const KernelProblem& problem);
Attempt conjugate_gradient(const KernelProblem& problem);
/// On from `start`, or the windowed root where that is empty, by so many products at the most.
Attempt least_squares(const KernelProblem& problem, std::vector<double> start, long products);
/// A kernel of twice the lags by projections (acf/projections.hpp), and where equations are to be met exactly the least
/// change that meets them (acf/minimum_norm_newton.hpp). Where the lags are a table that is met within what is
/// tolerated, of more lags until the ends of the kernel do no harm, or the `best` so far is good enough.
Attempt wider_kernel(const KernelProblem& problem, const std::optional<Kernel>& best);

}  // namespace asperity
