/// The kernel of a problem: solved, then recorded in a dataset.
#pragma once

#include "tools/surface/kernel_options.hpp"

namespace asperity::cli {

/// A kernel and, of heights that are a translation of Gaussian ones, how far that reaches. One on a torus has
/// a root, and values only where they are kept.
struct SolvedKernel : Kernel {
  double least_acf = NAN;     ///< smallest autocorrelation possible with these heights
  double hermite_tail = NAN;  ///< error of the translation
  std::optional<SpectralRoot> root = {};
};

/// Of what the problem asks for. Its progress is part of a longer run where `aside` is set.
SolvedKernel solve(const Tool& tool, KernelProblem& problem, bool aside = false);

struct KernelSolution {
  Dataset data;
  Inventory before;         ///< of the dataset that was read, to note what is gone
  Exit code = done;         ///< not_converged for a kernel that is not as requested
  std::string change = {};  ///< of the target by the kernel, in words; to be said of the kernel that is used
  std::optional<SpectralRoot> root = {};  ///< of a kernel on a torus
};

/// The kernel in the problem's dataset. Warns of one that is not as requested; otherwise reports it, as a
/// note or, where `aside` is set, with --verbose only.
KernelSolution record(const Tool& tool, KernelProblem problem, SolvedKernel kernel, bool aside = false);

/// For a kernel that was read: its own run has reported everything except that the kernel did not converge.
void report_read(const Tool& tool, const Dataset& data);

// ---- before the solution: surface/prospect.cpp ----

/// Warns and refuses, by the options of a kernel, before it is solved.
///
/// A surface of N × M points whose heights would mostly be one offset is refused: with the correlation ρ of
/// the target
///     ρ̄ = Σ w(p,q) ρ(p,q) / Σ w(p,q),   w = (1 - |p|/N)(1 - |q|/M),   |p| < N, |q| < M                  (1)
/// is the share of the variance that is in the mean of a surface. Above ½ the surface is refused. Warnings
/// are given if (1) along one axis alone exceeds ½, if the correlation ends within a sample, for tables of
/// more than 100 MB, and for heights that have a bound nearer than 3 Sq, a peak within a quarter Sq of it
/// (J-shaped), or two peaks.
///
/// `surface` is 0x0 where it is not known; `kept`: the kernel goes into the dataset. Throws UsageError, and
/// ParameterError("memory") where the solution takes more than the request allows.
void foresee(const Tool& tool, const KernelProblem& problem, Shape surface, bool kept);

/// What (1) leads to, blamed on this option; of a single height nothing.
void foresee_extent(const Tool& tool, const Target& target, Shape surface, const char* option);

}  // namespace asperity::cli
