/// The coefficients of least squares, where the autocorrelation equations have no solution.
///
/// ½‖F(u)‖², weighted by the multiplicity, is made least by GSL's trust-region method for large systems: each
/// step minimises the linear model ‖F + J s‖ within ‖s‖ ≤ Δ by conjugate gradients that stop at the bound
/// (Steihaug), with products J v and J*v only.
///
/// GSL's error handler, which is the process's, is left as it is, and called for want of memory alone.
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
