/// Solvers of the autocorrelation equations that the library does without, to measure its own by.
///
/// anderson_fixed_point: Anderson's acceleration [1] of the fixed point of G(u) = u - M(u) F(u), F and M of
/// acf/equations.hpp. The next iterate is that combination of the last five G whose combined residual
/// G(u) - u is least. It needs no Jacobian and no line search, and nothing makes it converge.
///
/// conjugate_gradient: as Bakolas and Creţu, Bălan & Urzică (2009) do, ½‖F(u)‖² falls along directions
///     d ← -g + β d,      g = J F,      β = max(0, ⟨g, g - g'⟩ / ⟨g', g'⟩),                              (1)
/// g' the gradient before (Polak & Ribière [2]), all products weighted by the multiplicity. F is quadratic,
///     F(u + t d) = F + t J d + t² Q,      Q = F(d) + R,                                                 (2)
/// so that ½‖F(u + t d)‖² is a quartic in t, and its least value follows from the roots of a cubic: the line
/// search is exact and costs one product. It squares the condition of J, and finds kernels whose spectrum
/// changes sign.
///
/// least_squares: GSL's trust-region method minimises ½‖F(u)‖², weighted likewise, for targets without a
/// kernel of their lags; each step minimises ‖F + J s‖ within ‖s‖ ≤ Δ by Steihaug's conjugate gradients [3].
///
/// The last two need a self-adjoint J, that of the symmetric and oriented formulations.
///
/// [1] D. G. Anderson, Iterative procedures for nonlinear integral equations, J. ACM 12 (1965) 547-560.
/// [2] E. Polak, G. Ribière, Note sur la convergence de méthodes de directions conjuguées, Rev. fr. inform.
///     rech. opér. 3 (1969) 35-43; V. Bakolas, Wear 254 (2003) 546-554.
/// [3] T. Steihaug, The conjugate gradient method and trust regions in large scale optimization, SIAM J.
///     Numer. Anal. 20 (1983) 626-637.
#pragma once

#include "acf/kernel.hpp"

namespace asperity {

/// Errors, seconds and steps as solve_kernel() reports them, of a request that names its lags and its
/// formulation; `converged`: the residual is within the tolerance.
KernelReport anderson_fixed_point(const KernelRequest& request);
KernelReport conjugate_gradient(const KernelRequest& request);
KernelReport least_squares(const KernelRequest& request);

}  // namespace asperity
