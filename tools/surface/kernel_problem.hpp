/// From the options to the equations of a kernel: their target, the heights, and how to solve them.
#pragma once

#include <optional>

#include "acf/band_limited.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/surface/acf_table.hpp"
#include "tools/surface/kernel_options.hpp"

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
  std::optional<EllipticTarget> model;  ///< of a target that is no table
  std::optional<BandLimited> band;      ///< the target of that period, of --cutoff
  Dataset data;                         ///< what the kernel is added to, with the grid of a table
  Inventory before;                     ///< of the table's dataset
};

/// The table of --acf, if it is given; throws UsageError for options that it has no use for, DataError where
/// it makes no sense.
std::optional<AcfTable> wanted_table(const Tool& tool, const KernelOptions& options);

/// Of the table, or the model of the options, on samples of this spacing if it is known; a table may know it
/// itself. `periodic` are the points of periodic surfaces, 0x0 of others. Throws UsageError for options that
/// are out of bounds or of no use.
KernelProblem kernel_problem(const Tool& tool, const KernelOptions& options, std::optional<AcfTable> table,
                             const Spacing& spacing, Shape periodic);

}  // namespace asperity::cli
