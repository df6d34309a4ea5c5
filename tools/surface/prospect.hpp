/// Warnings and refusals that follow from the options of a kernel, given before it is solved.
///
/// A surface of N × M points whose heights would mostly be one offset is refused: with the correlation ρ of
/// the target
///     ρ̄ = Σ w(p,q) ρ(p,q) / Σ w(p,q),   w = (1 - |p|/N)(1 - |q|/M),   |p| < N, |q| < M                  (1)
/// is the share of the variance that is in the mean of a surface. Above ½ the surface is refused. Warnings
/// are given if (1) along one axis alone exceeds ½, if the correlation ends within a sample, for tables of
/// more than 100 MB, and for heights that have a bound nearer than 3 Sq, a peak within a quarter Sq of it
/// (J-shaped), or two peaks.
#pragma once

#include "tools/surface/kernel_solution.hpp"

namespace asperity::cli {

/// `surface` is 0x0 where it is not known; `kept`: the kernel goes into the dataset. Throws UsageError, and
/// ParameterError("memory") where the solution takes more than the request allows.
void foresee(const Tool& tool, const KernelProblem& problem, Shape surface, bool kept);

/// What (1) leads to, blamed on this option; of a single height nothing.
void foresee_extent(const Tool& tool, const Target& target, Shape surface, const char* option);

}  // namespace asperity::cli
