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

}  // namespace asperity::cli
