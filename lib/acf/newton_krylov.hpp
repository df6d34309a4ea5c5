/// Iterations for F(u) = 0, the only door to KINSOL: Newton–Krylov, and Anderson's for the fixed point.
///
/// Given a start u, each step solves J(u) s = -F(u) by restarted GMRES, preconditioned from the right by
/// M ≈ J⁻¹, to
///     ‖F + J s‖ ≤ η ‖F‖,                                                                                (1)
/// and moves to u + λ s, λ ≤ 1 chosen by a line search that makes ‖F‖ fall. Norms are weighted by the scale
/// d: max |d F| decides on convergence. Only products J v and M v are asked for. J and M belong to the
/// iterate of the last `linearize`, which is called at the beginning of each step.
///
/// The fixed point of G(u) = u - M(u) F(u) is looked for by Anderson's acceleration: the next iterate is that
/// combination of the last `depth` of G whose combined residual is least. It needs no Jacobian and no line
/// search, and nothing makes it converge: the best iterate is kept.
///
/// Exceptions thrown by the system pass through the solver; a call of SUNDIALS that fails becomes a
/// std::runtime_error naming it. An iteration that does not arrive is no exception: the result says so.
///
/// Memory: `krylov_dimension` + 10 vectors; 3 `depth` + 8 for the fixed point.
///
/// A. C. Hindmarsh et al., SUNDIALS: suite of nonlinear and differential/algebraic equation solvers, ACM
/// Trans. Math. Softw. 31 (2005) 363-396; P. N. Brown, Y. Saad, Hybrid Krylov methods for nonlinear systems
/// of equations, SIAM J. Sci. Stat. Comput. 11 (1990) 450-481; D. G. Anderson, Iterative procedures for
/// nonlinear integral equations, J. ACM 12 (1965) 547-560.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace asperity {

struct NonlinearSystem {
  /// f = F(u); false when u lies outside the domain of F, whereupon a shorter step is tried.
  std::function<bool(std::span<const double> u, std::span<double> f)> residual;
  /// Prepares `jacobian` and `precondition` for the iterate u.
  std::function<void(std::span<const double> u)> linearize;
  /// out = J v
  std::function<void(std::span<const double> v, std::span<double> out)> jacobian;
  /// v = M v
  std::function<void(std::span<double> v)> precondition;
  /// d: the scale of the unknowns and of the equations, one positive number each.
  std::vector<double> scale;
};

struct NewtonOptions {
  double tolerance = 1e-10;       ///< on max |d F|
  double step_tolerance = 1e-14;  ///< on the relative length of a step: shorter ones stand still
  double forcing = 1e-3;          ///< η in (1)
  int max_steps = 15;             ///< Newton steps
  int max_products = 300;         ///< Jacobian products, checked before each step
  int krylov_dimension = 30;
  int restarts = 2;  ///< of GMRES, a step
};

struct FixedPointOptions {
  double tolerance = 1e-10;  ///< on max |F|
  int depth = 5;             ///< earlier iterates that are combined
  int max_iterations = 200;
};

struct IterationResult {
  bool converged = false;
  std::string reason;  ///< how it ended
  long steps = 0, residuals = 0, jacobian_products = 0, preconditionings = 0;
  double seconds = 0;
  double system_seconds = 0;  ///< of them in the system's functions, of Newton's iteration
};

/// Improves `u` from the start that it holds. Whatever the outcome, u is an iterate of the last accepted
/// step.
IterationResult solve_newton_krylov(const NonlinearSystem& system, std::span<double> u,
                                    const NewtonOptions& options);

/// The same for the fixed point; u becomes the iterate of the least max |F|.
IterationResult solve_fixed_point(const NonlinearSystem& system, std::span<double> u,
                                  const FixedPointOptions& options);

/// The library's name and version.
std::string sundials_version();

}  // namespace asperity
