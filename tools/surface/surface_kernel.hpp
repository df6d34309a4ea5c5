/// What surfaces are drawn with: a kernel, solved for or read, brought to the surface's height, spacing and
/// period, and the distribution of the heights: Gaussian, a translation of these, or that of averages of
/// skewed noise.
#pragma once

#include "tools/surface/generate_options.hpp"
#include "tools/surface/kernel_solution.hpp"

namespace asperity::cli {

/// `data` is what each surface is written with: its grid, and the autocorrelation at the lags that errors ask
/// for, or with --add kernel all tables.
struct SurfaceKernel : KernelSolution {
  KernelTables tables;
  HeightsWithAcf measured;  ///< that came with a table of the autocorrelation
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
