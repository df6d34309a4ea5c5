/// A fixed point u = G(u), by KINSOL's fixed-point iteration with Anderson's acceleration.
///
/// From the last m + 1 iterates and their residuals f_i = G(u_i) - u_i, each step takes the combination of
/// them of weights that sum to 1 and leave the least |Σ w_i f_i|, and moves by what is left of it:
///     u ← Σ w_i G(u_i).                                                                                  (1)
/// A map that shortens distances converges even by u ← G(u); (1) does so in some times fewer evaluations,
/// where G is nearly linear as fast as GMRES. It ends where max |d (G(u) - u)| ≤ the tolerance, d being
/// scales: KINSOL's own criterion is of its step.
///
/// Memory: 3 m + 9 vectors.
///
/// D. G. Anderson, Iterative procedures for nonlinear integral equations, J. ACM 12 (1965) 547-560; H. F.
/// Walker, P. Ni, Anderson acceleration for fixed-point iterations, SIAM J. Numer. Anal. 49 (2011)
/// 1715-1735.
#pragma once

#include <functional>
#include <span>

namespace asperity {

struct FixedPointOptions {
  double tolerance = 1e-6;    ///< on max |d (G(u) - u)|
  int depth = 5;              ///< m of (1); 0: u ← G(u)
  int max_evaluations = 200;  ///< of G
};

struct FixedPoint {
  int evaluations = 0;
  double residual = 0;  ///< max |d (G(u) - u)| of the last
  bool converged = false;
};

/// g = G(u).
using FixedPointMap = std::function<void(std::span<const double> u, std::span<double> g)>;

/// From the u that is given; leaves in it that of the last evaluation.
FixedPoint solve_fixed_point(const FixedPointMap& map, std::span<double> u, std::span<const double> scale,
                             const FixedPointOptions& options);

}  // namespace asperity
