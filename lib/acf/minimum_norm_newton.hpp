/// Kernels of more coefficients than there are equations: the least change that meets them.
///
/// The kernel has |k| < K, |l| < L, and R is prescribed at fewer lags, |p| < n, |q| < m. With P the
/// restriction to them and Q that to the kernel, both of a zero-phase field, Newton's equation
///     J s = -F,      J s = 2 P (α^ s^),      J*y = 2 Q (α^ y^),                                         (1)
/// has many solutions, and s = J*y with J J*y = -F is the shortest. It is found by conjugate gradients,
/// preconditioned by P / (4 α^²), and tried at half its length where ‖F‖ does not fall.
///
/// Cost      three transforms there and back of (2K+n)(2L+m) points an inner iteration, 60 a step at most.
///
/// A. Ben-Israel, A Newton–Raphson method for the solution of systems of equations, J. Math. Anal. Appl. 15
/// (1966) 243-252.
#pragma once

#include "acf/iteration.hpp"
#include "acf/target.hpp"
#include "core/field.hpp"

namespace asperity {

/// `kernel` of (2K-1) × (2L-1) coefficients, improved until max |F| ≤ tolerance [σ²] or as far as it goes;
/// never worse in ‖F‖ than it was.
Field minimum_norm_newton(const Field& kernel, const Target& target, Shape lags, bool oriented,
                          double tolerance, const IterationObserver& on_step);

}  // namespace asperity
