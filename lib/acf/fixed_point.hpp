/// Anderson's acceleration of the fixed point of G(u) = u - M(u) F(u), by KINSOL.
///
/// The next iterate is that combination of the last `depth` of G whose combined residual is least. It needs no
/// Jacobian and no line search, and nothing makes it converge: the best iterate is kept.
///
/// Memory: 3 `depth` + 8 vectors.
///
/// D. G. Anderson, Iterative procedures for nonlinear integral equations, J. ACM 12 (1965) 547-560.
#pragma once

#include <span>

#include "acf/equations.hpp"
#include "acf/iteration.hpp"

namespace asperity {

struct FixedPointOptions {
  double tolerance = 1e-10;  ///< on max |F|
  int depth = 5;             ///< earlier iterates that are combined
  int max_iterations = 200;
  IterationObserver on_step = {};
};

/// Improves `u` from the start that it holds; u becomes the iterate of the least max |F|.
IterationResult solve_fixed_point(Equations& equations, std::span<double> u,
                                  const FixedPointOptions& options);

}  // namespace asperity
