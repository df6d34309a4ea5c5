/// A solver of the autocorrelation equations that the library does without, to measure its own by.
///
/// Anderson's acceleration [1] of the fixed point of G(u) = u - M(u) F(u), F and M of acf/equations.hpp: the
/// next iterate is that combination of the last five G whose combined residual G(u) - u is least. It needs no
/// Jacobian and no line search, and nothing makes it converge: the best iterate is kept.
///
/// [1] D. G. Anderson, Iterative procedures for nonlinear integral equations, J. ACM 12 (1965) 547-560.
#pragma once

#include "acf/kernel.hpp"

namespace asperity {

/// Errors, seconds and steps as solve_kernel() reports them, of a request that names its lags and its
/// formulation.
KernelReport anderson_fixed_point(const KernelRequest& request);

}  // namespace asperity
