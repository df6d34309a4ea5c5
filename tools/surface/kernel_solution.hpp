/// From the options to a kernel in a dataset.
#pragma once

#include <optional>

#include "tools/cli/lineage.hpp"
#include "tools/surface/kernel_dataset.hpp"
#include "tools/surface/kernel_options.hpp"
#include "tools/surface/marginal_dataset.hpp"

namespace asperity::cli {

struct KernelProblem {
  /// Of a surface with one point along an axis, a problem along the other.
  void narrow(Shape surface);
  /// Of a periodic profile nothing is left to solve: the target becomes its sum over the periods.
  void wrap(const Tool& tool, Shape surface);
  /// Whether lags, formulation and method are left open.
  bool free() const {
    return request.lags == Shape{} && !request.formulation && request.method == Method::newton_krylov;
  }

  KernelRequest request;
  const char* extent = "length";     ///< the option that says how far the correlation reaches
  Spacing spacing;                   ///< of the samples
  bool has_height = false;           ///< request.rms is a height [m]
  std::optional<Marginal> marginal;  ///< of the heights, where they are not Gaussian
  HeightsWithAcf measured;           ///< what came with a table
  std::optional<Shape> period;  ///< of the surfaces that the kernel is for, where the table is that of one
  std::optional<BandLimited> band;  ///< the target of that period, of --cutoff
  Dataset data;      ///< what the kernel is added to: the attributes of the target, the grid of its table
  Inventory before;  ///< of the table's dataset
};

/// The model or the table of the options, on samples of this spacing if it is known; a table may know it
/// itself. `periodic` are the points of periodic surfaces, 0x0 of others. Throws UsageError, and DataError
/// for a table that makes no sense.
KernelProblem kernel_problem(const Tool& tool, const KernelOptions& options, const Spacing& spacing,
                             Shape periodic);

struct KernelSolution {
  Dataset data;
  Inventory before;         ///< of the dataset that was read, to tell what is gone
  Exit code = done;         ///< not_converged for a kernel that is not as requested
  std::string change = {};  ///< of the target by the kernel, in words; to be said of the kernel that is used
};

/// Warns of a kernel that is not as requested. Otherwise reports it, as a note or, where
/// `aside` is set, with --verbose only.
KernelSolution solve(const Tool& tool, KernelProblem problem, bool aside = false);

/// For a kernel that was read: its own run has reported everything except that the kernel did not converge.
void tell_read(const Tool& tool, const Dataset& data);

}  // namespace asperity::cli
