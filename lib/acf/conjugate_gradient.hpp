/// The autocorrelation equations by nonlinear conjugate gradients, as Bakolas and Creţu, Bălan & Urzică do.
///
/// The sum of squares ½‖F(u)‖² falls along directions
///     d ← -g + β d,      g = J*F,      β = max(0, ⟨g, g - g'⟩ / ⟨g', g'⟩),                              (1)
/// g' the gradient before (Polak & Ribière), all products weighted by the multiplicity. F is quadratic,
///     F(u + t d) = F + t J d + t² Q,      Q = F(d) + R,                                                 (2)
/// so that ½‖F(u + t d)‖² is a quartic in t, and its least value follows from the roots of a cubic: the line
/// search is exact and costs one product.
///
/// It squares the condition of J: some 400 iterations at 31 × 31 lags and e^-4.6, 1200 at 63 × 63, where
/// Newton takes 5 steps (validation/acf_error_time.cpp). It finds kernels whose spectrum changes sign.
///
/// Cost      three transforms there and back an iteration and half of one.
///
/// E. Polak, G. Ribière, Note sur la convergence de méthodes de directions conjuguées, Rev. fr. inform. rech.
/// opér. 3 (1969) 35-43; V. Bakolas, Wear 254 (2003) 546-554.
#pragma once

#include <span>

#include "acf/equations.hpp"
#include "acf/iteration.hpp"

namespace asperity {

/// Improves u until max |F| ≤ tolerance, by 3000 iterations at most.
IterationResult solve_conjugate_gradient(Equations& equations, std::span<double> u, double tolerance,
                                         const IterationObserver& on_step);

}  // namespace asperity
