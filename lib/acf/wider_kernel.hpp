/// Kernels that are wider than the lags prescribed: that of the autocorrelation closest to a target, and the
/// least change of a kernel that meets the equations.
///
/// A function R of the lag is the autocorrelation of some surface of unit variance exactly when its spectrum
/// S is nowhere negative and has the mean R(0,0) = 1. Two convex sets of functions on a torus of fn × fm
/// points, f = 4 unless more are requested, are projected onto in turn:
///     A   those that agree with the target at |p| < n, |q| < m: it is put back there,
///     B   the autocorrelations: S ← max(S - θ, 0), θ such that the mean is 1 [1],
/// by the iteration of Douglas and Rachford [2],
///     z ← z + P_B(2 P_A z - z) - P_A z,                                                                 (1)
/// that begins with the target where it is known and 0 elsewhere; what lies beyond n and m is free. Where the
/// sets meet, P_B ends in an extension of the target, mostly after finitely many steps; else in the
/// autocorrelation that is closest to it in the mean square [3]. The kernel is the zero-phase root kernel^ =
/// √S on the whole torus. Its part beyond the torus is lost, less of it on a larger torus; measure the
/// resulting error.
///
/// A kernel of |k| < K, |l| < L has more coefficients than there are equations. With P the restriction to the
/// lags |p| < n, |q| < m and Q that to the kernel, both of a zero-phase field, Newton's equation
///     J s = -F,      J s = 2 P (α^ s^),      J*y = 2 Q (α^ y^),                                         (2)
/// has many solutions, and s = J*y with J J*y = -F is the shortest [4]. Conjugate gradients find it,
/// preconditioned by P / (4 α^²); s is tried at half its length where ‖F‖ does not fall.
///
/// Accuracy  (1) meets an exponential cut where it has fallen to e⁻²·³ to round-off, after 30 steps at 7²
///           and 13² lags, 100 at 31²; a Gaussian cut at 1 %, on the edge of what is feasible, to 1e-5 after
///           100.
/// Cost      (1) one transform there and back on the torus and four passes over its spectrum a step; 5
///           vectors of 4 n·m, 8 oriented, for f = 4. (2) three transforms there and back of (2K+n)(2L+m)
///           points an inner iteration, 60 a step at most.
///
/// [1] M. Held, P. Wolfe, H. P. Crowder, Validation of subgradient optimization, Math. Program. 6 (1974)
///     62-88.
/// [2] P.-L. Lions, B. Mercier, Splitting algorithms for the sum of two nonlinear operators, SIAM J. Numer.
///     Anal. 16 (1979) 964-979.
/// [3] H. H. Bauschke, P. L. Combettes, D. R. Luke, Finding best approximation pairs relative to two closed
///     convex sets in Hilbert spaces, J. Approx. Theory 127 (2004) 178-192.
/// [4] A. Ben-Israel, A Newton–Raphson method for the solution of systems of equations, J. Math. Anal. Appl.
///     15 (1966) 243-252.
#pragma once

#include "acf/kernel.hpp"
#include "acf/target.hpp"
#include "core/field.hpp"

namespace asperity {

struct ProjectionOptions {
  double tolerance = 1e-10;        ///< on the change of the target [σ²]: smaller ones end the iteration
  int max_iterations = 300;        ///< 0: P_B of the target, the root of what is positive of it
  Index torus = 4;                 ///< f
  IterationObserver on_step = {};  ///< every ten iterations
};

struct NearestKernel {
  Field values;       ///< (fn-1) × (fm-1) or a little more, unit variance
  double change = 0;  ///< largest change of the target at |p| < n, |q| < m, on the torus [σ²]
  int iterations = 0;
};

NearestKernel nearest_kernel(const Target& target, Shape lags, bool oriented,
                             const ProjectionOptions& options = {});

/// (2): `kernel` of (2K-1) × (2L-1) coefficients, improved until max |F| ≤ tolerance [σ²] or as far as it
/// goes; never worse in ‖F‖ than it was.
Field minimum_norm_newton(const Field& kernel, const Target& target, Shape lags, bool oriented,
                          double tolerance, const IterationObserver& on_step);

}  // namespace asperity
