/// The options that say which autocorrelation a surface shall have, for the tools that solve for its kernel;
/// and the problem that they pose: a target, the heights, and how to solve the equations.
///
/// asperity-generate knows them by their groups in --help, "Autocorrelation" and "Solution".
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "acf/band_limited.hpp"
#include "acf/kernel.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/tool.hpp"
#include "tools/surface/acf_table.hpp"
#include "tools/surface/kernel_dataset.hpp"
#include "tools/surface/marginal.hpp"

namespace asperity::cli {

/// The rms height of a surface: prescribed, or such that its neighbouring heights have an rms slope.
///
/// The slope is that of asperity-stats, Sdq (stats/hybrid/slopes.hpp, (1)), or √m2 of a profile: of the
/// differences of neighbouring heights on this grid. In the ensemble its square is
///     E[Sdq²] = 2 (R(0,0) - R(1,0))/Δx² + 2 (R(0,0) - R(0,1))/Δy²,                                      (1)
/// R being acf_achieved, that of the heights, exactly; zero beyond a single lag. An axis of one point has no
/// slope. R of a model without a slope, such as the exponential, makes it one of the grid.
///
/// Accuracy  round-off: ε over 1 - R(1)/R(0).
struct HeightOptions {
  double rms = NAN;    ///< [m]
  double slope = NAN;  ///< in place of it

  void declare(Tool& tool, const std::string& rq, const std::string& group);
  /// Throws UsageError where both are given, ParameterError for a slope out of bounds.
  void check(const Tool& tool) const;
  bool has_slope() const { return !std::isnan(slope); }
  /// Scales to the slope, if it is given, for surfaces of this shape, 0x0 where none is known. Says the
  /// height and leaves the slope on record. Throws UsageError without a spacing, ParameterError where heights
  /// have no slope.
  void apply(const Tool& tool, KernelTables& tables, Shape surface, Attributes& attributes) const;
};

struct KernelOptions {
  std::string target = "exponential", acf, psd, angle = "0deg", wavelength, cutoff;
  std::array<SampledLength, 2> length, rolloff;
  EllipticTarget shape;  ///< its level and the parameters of its shape
  HeightOptions height;
  MarginalOptions heights;

  KernelRequest request;  ///< its lags and tolerances
  std::string formulation, method = "newton-krylov", infeasible = "auto";

  /// A tool that draws may filter noise that is not Gaussian itself.
  void declare(Tool& tool, bool draws = false);
  bool filters() const { return method == "filter"; }

  /// The option that gives its lengths: "length", or "rolloff" of self-affine.
  const char* length_option(const Tool& tool) const { return rolloff_is_length(tool) ? "rolloff" : "length"; }
  bool rolloff_is_length(const Tool& tool) const;  ///< of self-affine

 private:
  void declare_target(Tool& tool);
  void declare_tables(Tool& tool);
  void declare_solution(Tool& tool, bool draws);
};

// ---- the problem ----

struct KernelProblem {
  /// For surfaces of this shape, 0x0 where none is known. Of those with one point along an axis, a problem
  /// along the other; without equations, one on a torus.
  void lay_out(const Tool& tool, Shape surface, bool periodic);
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
  std::optional<Shape> period;     ///< of the surfaces that the kernel is for, where the table is that of one
  bool positive_definite = false;  ///< the table, which is 0 beyond its lags
  /// Where the kernel is the root of a spectrum: the period of the surfaces, or a torus of which a surface is
  /// a corner; nothing where there are equations to solve.
  std::optional<Shape> torus = {};
  std::optional<Shape> corner = {};  ///< the largest one
  bool keeps_kernel = true;          ///< with all of its lags; surfaces are drawn from the root alone
  int threads = 1;
  /// Of the tables on a torus: all, or, of a corner without its kernel, lag one, which tells the slope.
  Shape lags_kept() const;
  std::optional<EllipticTarget> model;  ///< of a target that is no table
  std::optional<BandLimited> band;      ///< the target of that period, of --cutoff
  Dataset data;                         ///< what the kernel is added to, with the grid of a table
  Inventory before;                     ///< of the table's dataset

 private:
  void narrow(Shape surface);
};

/// Throws UsageError for an option of a model, which `table`, the option of a table, has no use for.
void refuse_model(const Tool& tool, const char* table);
/// The same for an option of equations, of which `limit`, the option of a spectrum, leaves none.
void refuse_solver(const Tool& tool, const KernelOptions& options, const std::string& limit);
/// The table of --acf or of --psd, if one is given; throws UsageError for options that it has no use for,
/// DataError where it makes no sense. The spectrum needs the samples and the shape of the surface.
std::optional<AcfTable> wanted_table(const Tool& tool, const KernelOptions& options, const Spacing& spacing,
                                     Shape surface, bool periodic);

/// Of the table, or the model of the options, on samples of this spacing if it is known; a table may know it
/// itself. `periodic` are the points of periodic surfaces, 0x0 of others. Throws UsageError for options that
/// are out of bounds or of no use.
KernelProblem kernel_problem(const Tool& tool, const KernelOptions& options, std::optional<AcfTable> table,
                             const Spacing& spacing, Shape periodic);

}  // namespace asperity::cli
