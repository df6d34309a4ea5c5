/// The autocorrelation closest to a target that is none, and its kernel.
///
/// A function R of the lag is the autocorrelation of some surface exactly when its spectrum is nowhere
/// negative. Two sets of functions on a torus of 4n × 4m points are projected onto in turn: those of spectrum
/// ≥ 0, by
///     S ← max(S, 0),  over-relaxed:  S ← (1 - ω) S where S < 0,  1 ≤ ω < 2,                            (1)
/// and those that agree with the target at |p| < n, |q| < m, by putting it back there. What lies beyond these
/// lags is free and begins with the target where it is known. If the sets meet, the iteration ends in a
/// common point, an extension of the target; if not, between two closest ones [1]. The kernel is the zero-
/// phase root kernel^ = √max(S, 0) on the whole torus; what it has beyond its ends on the torus is lost, so
/// that `change` is to be measured on it.
///
/// Accuracy  ω = 1.9 leaves three to four digits more than ω = 1 in as many steps; a target on the edge of
/// what is
///           feasible is met within some 1e-4 after 300.
/// Cost      one transform there and back on the torus a step, 300 at the most. Memory: 5 vectors of 4 n·m, 8
///           oriented.
///
/// [1] L. G. Gubin, B. T. Polyak, E. V. Raik, The method of projections for finding the common point of
/// convex
///     sets, USSR Comput. Math. Math. Phys. 7 (1967) 1-24.
#pragma once

#include "acf/iteration_step.hpp"
#include "acf/target.hpp"
#include "grid/field.hpp"

namespace asperity {

struct ProjectionOptions {
  double tolerance = 1e-10;  ///< on the change of the target [σ²]: smaller ones end the iteration
  double relaxation = 1.9;   ///< ω
  int max_iterations = 300;
  IterationObserver told = {};  ///< every ten iterations
};

struct NearestKernel {
  Field values;       ///< (4n-1) × (4m-1) or a little more, unit variance
  double change = 0;  ///< largest change of the target at |p| < n, |q| < m, on the torus [σ²]
  int iterations = 0;
};

NearestKernel nearest_kernel(const Target& target, Shape lags, bool oriented,
                             const ProjectionOptions& options = {});

}  // namespace asperity
