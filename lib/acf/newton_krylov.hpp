/// Newton–Krylov iteration for F(u) = 0, by KINSOL.
///
/// Given a start u, each step solves J(u) s = -F(u) by restarted GMRES, preconditioned from the right by
/// M ≈ J⁻¹, to
///     ‖F + J s‖ ≤ η ‖F‖,                                                                                (1)
/// and moves to u + λ s, λ ≤ 1 chosen by a line search that makes ‖F‖ fall. Norms are weighted by d = √w:
/// max |d F| decides on convergence. A step to where the residual is refused is tried shorter.
///
/// Memory: `krylov_dimension` + 10 vectors.
///
/// A. C. Hindmarsh et al., SUNDIALS: suite of nonlinear and differential/algebraic equation solvers, ACM
/// Trans. Math. Softw. 31 (2005) 363-396; P. N. Brown, Y. Saad, Hybrid Krylov methods for nonlinear systems
/// of equations, SIAM J. Sci. Stat. Comput. 11 (1990) 450-481.
#pragma once

#include <span>

#include "acf/equations.hpp"
#include "acf/kernel.hpp"

namespace asperity {

struct NewtonOptions {
  double tolerance = 1e-10;       ///< on max |d F|
  double step_tolerance = 1e-14;  ///< on the relative length of a step: shorter ones stand still
  double forcing = 1e-3;          ///< η in (1)
  int max_steps = 15;             ///< Newton steps
  int max_products = 300;         ///< Jacobian products, checked before each step
  int krylov_dimension = 30;
  int restarts = 2;  ///< of GMRES, a step
  IterationObserver on_step = {};
};

/// Improves `u` from the start that it holds. Whatever the outcome, u is an iterate of the last accepted
/// step.
IterationResult solve_newton_krylov(Equations& equations, std::span<double> u, const NewtonOptions& options);

}  // namespace asperity
