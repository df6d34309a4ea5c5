/// What surfaces are drawn with: a kernel, solved for or read, brought to the surface's height, spacing and period, and the
/// distribution of the heights: Gaussian, a translation of these, or that of averages of skewed noise.
#pragma once

#include "core/pointwise.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/surface/generate_options.hpp"

namespace asperity::cli {

struct SurfaceKernel {
  Dataset data;  ///< what each surface is written with, its grid and the kernel's tables
  KernelTables tables;
  HeightsWithAcf measured;  ///< that came with a table of the autocorrelation
  Inventory before;         ///< of the dataset that was read
  Exit code = done;         ///< that follows from how the kernel was solved for
};

/// Takes what is not given of the grid from the kernel's dataset into the options.
SurfaceKernel surface_kernel(const Tool& tool, GenerateOptions& options);

struct HeightDistribution {
  Pointwise noise, heights;  ///< what the noise and its averages become
};

/// Leaves on record in the kernel's dataset what is expected of the heights.
HeightDistribution height_distribution(const Tool& tool, const GenerateOptions& options,
                                       SurfaceKernel& kernel);

}  // namespace asperity::cli
