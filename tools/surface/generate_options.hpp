/// The options of asperity-generate, and what surfaces are drawn with: a kernel, solved for or read, with the
/// surface's height, spacing and period; and the distribution of the heights, Gaussian, a translation of
/// these, or that of averages of skewed noise.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "surface/synthesis.hpp"
#include "tools/surface/kernel_solution.hpp"

namespace asperity::cli {

struct SurfaceKernel;

struct GenerateOptions {
  KernelOptions acf;
  std::string kernel;
  Shape shape;
  std::array<double, 2> size{NAN, NAN};
  bool periodic = false, exact_rq = false;
  std::vector<std::string> add = {};
  int count = 1, first = 0;

  void declare(Tool& tool);
  /// Throws UsageError where the surfaces of an ensemble have no names of their own, or a report is asked
  /// for.
  void check_outputs(Tool& tool) const;

  /// The first option given of those that say which kernel to solve for, or nothing.
  std::string target_option(const Tool& tool) const;
  bool adds(std::string_view variable) const { return std::ranges::find(add, variable) != add.end(); }
  /// Number `k` of the surfaces, and the name of its file.
  std::int64_t number(int k) const { return std::int64_t{first} + k; }
  std::string output_name(const Tool& tool, int k) const;

  /// `held` are bytes of memory that are taken meanwhile; of several surfaces at once, each has its share of
  /// the rest. Throws ParameterError("memory") where there is too little.
  Synthesis synthesis(const Tool& tool, SurfaceKernel source, Pointwise translation, std::size_t held,
                      int at_once) const;

 private:
  void declare_drawing(Tool& tool);
};

// ---- what surfaces are drawn with ----

/// `data` is what each surface is written with: its grid, and the autocorrelation at the lags that errors ask
/// for, or with --add kernel all tables.
struct SurfaceKernel : KernelSolution {
  KernelTables tables;
  HeightsWithAcf measured;  ///< that came with a table of the autocorrelation
};

/// Of a table, where the tool has one; else as the options ask for. Takes what is not given of the grid from
/// the kernel's dataset into the options.
SurfaceKernel surface_kernel(const Tool& tool, GenerateOptions& options, std::optional<AcfTable> table);

struct HeightDistribution {
  Pointwise noise, heights;  ///< what the noise and its averages become
};

/// Leaves on record in the kernel's dataset what is expected of the heights.
HeightDistribution height_distribution(const Tool& tool, const GenerateOptions& options,
                                       SurfaceKernel& kernel);

}  // namespace asperity::cli
