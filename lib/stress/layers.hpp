/// Stress below a loaded surface, layer by layer.
///
/// In the layer at depth z each component is a convolution of the surface pressure with its influence,
///     σ_c(x_i, y_j, z) = Σ_{i',j'} K_c(i-i', j-j'; z) p(i',j'),                                       (1)
/// evaluated at the cell centres by Fourier transform (stress/layer_influence.hpp). Friction
/// (stress/load.hpp) adds its own influence to K_c; being in proportion to the pressure, it needs no
/// transform of its own. The pressure is transformed once. Then, for a layer:
///     influence → per block of eight columns: transfer function, product with p^, transform back in x
///               → per row: transform back in y,
/// for one component after the other, and only rows leave a layer. Deep layers may be computed from wider
/// cells (stress/resolution.hpp).
///
/// A section, the vertical plane x = x_i or y = y_j through cell centres, needs one row of each layer: it
/// comes from the influence transformed along the plane alone (stress/section.cpp).
///
/// Several ranks (core/ranks.hpp) share the rows of the pressure and of layers, and the columns between them;
/// every layer is collective, and all work on one at a time.
///
/// Symbols   σ  stress, positive in tension [Pa]     p  pressure of each cell [Pa]     z  depth, ≥ 0 [m]
/// Scope     a linear elastic half-space; any grid, Δx ≠ Δy, periodic or not.
/// Accuracy  of (1): round-off, below 16 ε Σ|p|. Of (1) as a model of a smooth pressure p(x, y): (h²/12) ∇²p
///           in effect, order 2 in h at depth, 1.2e-4 max p for a Hertz contact 85 cells wide. Near the
///           surface the steps of the pressure show below its edges: see accurate_depth. Where cells are
///           wider, sections and volumes differ by 1e-7 max p.
/// Cost      per layer and component about one padded complex transform of half the torus; six components of
///           128 × 128 cells take 8-10 padded real transforms, 3 ms; with friction along an axis 1.5 times as
///           long, in another direction twice. Two threads 1.75 times as fast.
/// Memory    on N = nx ny cells 4 N doubles for the pressure and 2 N for a component, and N more for each
///           further one in the same layer(): 6 N one by one, 11 N for all at once; N more with friction in a
///           direction between the axes. Threads share it, on less than 768² cells each has its own layer.
///           A section costs a seventh of the volume, with wider cells a fifth, less the more the load is
///           gathered about it; its memory is below that of a layer.
///
/// S. Liu, Q. Wang, J. Tribology 124 (2002) 36-45; pruning: transform/pruned.hpp.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "stress/layer_plan.hpp"

namespace asperity {

/// finished(begin, end): the layers before `end` are complete.
using LayersFinished = std::function<void(Index begin, Index end)>;
using LayerRowSink = std::function<void(Index layer, Index i, const StressRow& values)>;

/// A stress that is added to the elastic one, such as flow has left (plastic/residual_stress.hpp).
class AddedStress {
 public:
  virtual ~AddedStress() = default;
  /// A component at depth z [m] at the centres of the cells [Pa]; called by several threads at once.
  virtual Field layer(double z, stress::Component c) const = 0;
};

enum class DepthResolution {
  full,     ///< every layer from its own cells
  adapted,  ///< deep layers from wider cells
};

class StressSolver {
 public:
  /// Of whole layers, or of the row of each in a section alone. Throws as LoadedBody::check does, and
  /// ParameterError("section") for a plane outside the grid.
  StressSolver(LoadedBody body, std::optional<Plane> section, int threads = 1,
               DepthResolution resolution = DepthResolution::full);
  explicit StressSolver(LoadedBody body, int threads = 1, DepthResolution resolution = DepthResolution::full)
      : StressSolver(std::move(body), std::nullopt, threads, resolution) {}

  /// From now on adds this to what it computes. Of one rank.
  void add(std::shared_ptr<const AddedStress> more) { added_ = std::move(more); }
  const LoadedBody& body() const { return body_; }
  int threads() const { return threads_; }
  /// Of a layer: that of the grid, or one row.
  Shape shape() const;
  /// The rows of a layer that this rank computes and is handed; the first rank has that of a section.
  Extent rows() const;
  /// Whether a layer has so many points that its components are always computed one by one.
  bool by_component() const;

  /// What one thread needs to compute layers of one solver; may be used again for any depth and components.
  class Workspace {
   public:
    explicit Workspace(int threads = 1) : threads_(threads) {}

   private:
    friend class StressSolver;
    struct Level {
      std::shared_ptr<const LayerPlan> plan;
      std::unique_ptr<LayerWork> work;
    };
    int threads_;
    std::vector<Level> levels_;  ///< made when they are needed
  };

  /// The layer at depth z, row after row; if the workspace has several threads, rows come from all of them,
  /// in any order and at the same time. `behind`: as LayerWork::layer. Throws as check_depth does.
  void layer(double z, stress::Set asked, Workspace& work, const StressRowSink& row,
             const BehindRows& behind = {}) const;

  using LayerJob = std::function<void(Index layer, Workspace& work)>;
  /// Many layers on all threads: job(l, work) calls layer() for depths[l] as often as it wants. At most as
  /// many jobs are begun as there are threads and not finished: finished(begin, end) is called from the
  /// calling thread when the layers before `end` are complete.
  void each_layer(const std::vector<double>& depths, const LayerJob& job,
                  const LayersFinished& finished = {}) const;
  /// The same with one call for each: row(layer, i, values), from several threads at once.
  void layers(const std::vector<double>& depths, stress::Set asked, const LayerRowSink& row,
              const LayersFinished& finished = {}) const;

 private:
  /// One resolution, its plan made when a layer needs it.
  struct Level {
    Index s = 1;
    std::mutex mutex = {};
    std::shared_ptr<const LayerPlan> plan = {};
  };

  /// The widest cells that will do at depth z.
  std::size_t level_at(double z) const;
  std::shared_ptr<const LayerPlan> plan(Level& level) const;
  /// The same rows with what is added at this depth.
  StressRowSink with_added(double z, stress::Set asked, const StressRowSink& row) const;
  /// Whether all threads work on one layer, so that there are buffers for one.
  bool together() const;
  /// Gives back what the layers from number `next` on do not need.
  void release(const std::vector<double>& depths, Index next, Workspace& work) const;

  LoadedBody body_;
  std::optional<Plane> section_;
  int threads_;
  mutable std::deque<Level> levels_;
  std::shared_ptr<const AddedStress> added_;
};

/// Two cells, of their longer side; a period of one cell has no steps along it. From there on every value is
/// within 1 % of the largest pressure even below the edge of a Hertz contact (of ten cells' radius:
/// components 6e-3, von Mises 8e-3, falling as the root of the cell; with friction μ = 0.5 components 7e-3,
/// von Mises 1.0e-2), of any ν. Above it, cells nearer than this to an edge of the pressure may be off by
/// shallow_error; others by 1.2 %, at z = 0 by 5.5 μ % more: a tangential stress has the logarithm of the
/// distance from each step of its traction q, which halfway between the steps leaves at order 1
///     Δσxx = -(2 ln 2/π) Δx ∂qx/∂x,   Δσyy = ν Δσxx,   Δσxy = -(ln 2/π) Δy ∂qx/∂y   of qx, of qy likewise,
/// and fades as exp(-2πz/Δx).
double accurate_depth(const Grid& grid);
/// The error above that depth, as a share of the maximum pressure: 9 %, or 11 (1-2ν) % where that is more,
/// and 26 μ % more under friction.
double shallow_error(double poisson, const Friction& friction);

}  // namespace asperity
