/// Least-squares coefficients for autocorrelation equations that have no solution.
///
/// GSL's trust-region method for large systems minimises ½‖F(u)‖², weighted by the multiplicity: each
/// step minimises the linear model ‖F + J s‖ within ‖s‖ ≤ Δ by conjugate gradients that stop at the bound
/// (Steihaug), with products J v and J*v only.
///
/// GSL's error handler, which is global to the process, is left alone; it is called only if memory runs out.
///
/// Cost      two transforms there and back a product. Memory O(n·m).
///
/// T. Steihaug, The conjugate gradient method and trust regions in large scale optimization, SIAM J. Numer.
/// Anal. 20 (1983) 626-637; M. Galassi et al., GNU Scientific Library Reference Manual, ch. Nonlinear
/// least-squares fitting.
#pragma once

#include <span>

#include "acf/equations.hpp"
#include "acf/iteration.hpp"

namespace asperity {

struct LeastSquaresOptions {
  int max_iterations = 60;
  double step_tolerance = 1e-8;  ///< on the relative change of the coefficients
  double gradient_tolerance = 1e-9;
  long max_products = 20000;  ///< looked at after each iteration
  IterationObserver on_step = {};
};

/// Improves u.
IterationResult minimise_squares(Equations& equations, std::span<double> u,
                                 const LeastSquaresOptions& options = {});

}  // namespace asperity
