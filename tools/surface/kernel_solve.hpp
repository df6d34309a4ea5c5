/// From the options to a kernel in a dataset.
#pragma once

#include <optional>

#include "tools/cli/lineage.hpp"
#include "tools/surface/kernel_dataset.hpp"
#include "tools/surface/kernel_options.hpp"

namespace asperity::cli {

/// A kernel that is to be solved for.
struct Wanted {
  KernelRequest request;
  Spacing spacing;                   ///< of the samples
  bool has_height = false;           ///< request.rms is a height [m]
  std::optional<Marginal> marginal;  ///< of the heights, where they are not Gaussian
  HeightsWithAcf measured;           ///< what came with a table
  std::optional<Shape> period =
      {};        ///< of the surfaces that the kernel is for, where the table is that of one
  Dataset data;  ///< what the kernel is added to: the attributes of the target, the grid of its table
  Inventory before = {};  ///< of the table's dataset
};

/// The model or the table of the options, on samples of this spacing if it is known; a table may know it itself.
/// Throws UsageError, and DataError for a table that makes no sense.
Wanted wanted_kernel(const Tool& tool, const KernelOptions& options, const Spacing& spacing);

struct Solved {
  Dataset data;
  KernelReport report;
  Shape lags;
  bool chosen;           ///< the lags, not given
  bool table;            ///< the target is one, most of whose far lags may be noise
  double acf_tolerance;  ///< that they were chosen for
  Inventory before;      ///< of the dataset with the table, to tell what is gone
  std::optional<Shape> period;
};
Solved solve(const Tool& tool, Wanted wanted);

/// Warns of a kernel that is not what was asked for, and returns the exit code that follows. What is in order is said
/// too, as a note or, where `aside` is set, with --verbose only.
Exit tell(const Tool& tool, const Solved& solved, bool aside = false);

/// The same of a kernel that was read, of which its own run has told all but that it is not solved.
void tell_read(const Tool& tool, const Dataset& data);

}  // namespace asperity::cli
