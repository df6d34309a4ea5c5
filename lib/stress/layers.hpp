/// Stress below a loaded surface, layer by layer.
///
/// In the layer at depth z each component is a convolution of the surface pressure with its influence,
///     σ_c(x_i, y_j, z) = Σ_{i',j'} K_c(i-i', j-j'; z) p(i',j'),                                       (1)
/// evaluated at the cell centres by Fourier transform (stress/layer_influence.hpp). Friction (stress/friction.hpp)
/// adds its own influence to K_c; being in proportion to the pressure it needs no transform of its own, and of the
/// product, then a complex one, no more. The pressure is transformed once. Then, for a layer:
///     influence of the layer → per block of eight columns: symbol, product with p^, transform back in x
///                            → per row: transform back in y, six components of one row hand over while hot.
/// Only the components that are asked for are computed; nothing but the rows leaves a layer, so that the von
/// Mises stress of a volume needs the memory of a layer.
///
/// Deep layers are computed from wider cells (stress/resolution.hpp) where that is allowed.
///
/// Symbols   σ  stress, positive in tension [Pa]     p  pressure of each cell [Pa]     z  depth, ≥ 0 [m]
/// Scope     a linear elastic half-space; any grid, Δx ≠ Δy, periodic or not.
/// Accuracy  of (1): round-off, below 16 ε Σ|p|. Of (1) as a model of a smooth pressure p(x, y): (h²/12) ∇²p in
///           effect, order 2 in h at depth, 1.2e-4 max p for a Hertz contact 85 cells wide. Near the surface
///           the steps of the pressure show below its edges: see accurate_depth.
/// Cost      per layer and component about one padded complex transform of half the torus; six components of
///           128 × 128 cells take 8-10 padded real transforms, 3 ms; with friction along an axis 1.5 times as
///           long, in another direction twice. Two threads 1.75 times as fast. Memory: 4 N doubles for the
///           pressure and less for each coarse level, and per thread 3 N for each component asked, N = nx ny.
///
/// S. Liu, Q. Wang, J. Tribology 124 (2002) 36-45; pruning: transform/pruned.hpp.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/field.hpp"
#include "stress/component.hpp"
#include "stress/depth_levels.hpp"
#include "stress/friction.hpp"
#include "stress/layer_influence.hpp"
#include "stress/layer_queue.hpp"
#include "stress/resolution.hpp"
#include "transform/pruned.hpp"

namespace asperity {

/// One row of a layer: for each component that was asked its ny values, else a null pointer.
using StressRow = std::array<const double*, 6>;
/// Rows of many layers: row(layer, i, values).
using LayerRowSink = std::function<void(Index layer, Index i, const StressRow& values)>;

/// Throws ParameterError("poisson") unless -1 < ν ≤ ½ (grid/poisson.hpp), ("friction") or ("friction-angle") unless they
/// are such and the traction at most 1e100 Pa, DataError("pressure") unless the pressure fits a grid of cells, is finite
/// and its largest value 0 or 1e-100 … 1e100 Pa.
void check_load(const Grid& grid, const Field& pressure, const Friction& friction, double poisson);
/// Places and depths reach so far [m]: squares of them are numbers that doubles hold.
inline constexpr double farthest = 1e30;
/// Throws ParameterError("depth") unless 0 ≤ z ≤ farthest.
void check_depth(double z);

class StressSolver {
 public:
  /// Throws as check_load does.
  StressSolver(const Grid& grid, const Field& pressure, double poisson, int threads = 1,
               DepthResolution resolution = DepthResolution::full);
  /// With the traction of sliding friction.
  StressSolver(const Grid& grid, const Field& pressure, const Friction& friction, double poisson,
               int threads = 1, DepthResolution resolution = DepthResolution::full);

  const Grid& grid() const { return grid_; }
  const Field& pressure() const { return pressure_; }
  double poisson() const { return poisson_; }
  int threads() const { return threads_; }

  /// What one thread needs to compute layers; may be used again for any depth and components.
  class Workspace {
   private:
    friend class StressSolver;
    /// Of one resolution, grown when it is used.
    struct Level {
      std::unique_ptr<LayerInfluence> influence;
      AlignedVector<Complex> block, work;
      RowTransform::Work rows;
      std::array<HalfSpectrum, 6> half;
      std::array<AlignedVector<double>, 6> points;  ///< a coarse layer: rows of stride doubles
      Index stride = 0;
    };

    std::size_t present_ = 0;  ///< the resolution of the present layer
    std::vector<Level> levels_;
    std::array<AlignedVector<double>, 6> rows_;  ///< eight rows, or one that is interpolated
    AlignedVector<double> across_;
  };

  /// The layer at depth z, row after row: row(i, values). Throws as check_depth does.
  template <class RowSink>
  void layer(double z, stress::Set asked, Workspace& work, RowSink row) const {
    transform_layer(z, asked, work);
    for (Index i = 0; i < grid_.shape.nx; ++i) row(i, row_of(i, asked, work));
  }

  /// Many layers on all threads, at most as many at a time as there are threads: row(layer, i, values) is called
  /// from several threads at once, for one layer from one thread and in order; finished(begin, end) from the calling
  /// thread when the layers before `end` are complete. The values do not depend on the number of threads.
  void layers(const std::vector<double>& depths, stress::Set asked, const LayerRowSink& row,
              const LayersFinished& finished = {}) const;

 private:
  const Resolution& resolution(std::size_t level) const;
  Workspace::Level& prepared(Workspace& work, std::size_t level, stress::Set asked) const;
  /// Columns of the layer, transformed back in x.
  void transform_layer(double z, stress::Set asked, Workspace& work) const;
  void invert_points(const Resolution& r, stress::Set asked, Workspace::Level& level) const;
  /// Row i; to be called for i = 0, 1, 2 …, eight rows being transformed back at a time.
  StressRow row_of(Index i, stress::Set asked, Workspace& work) const;
  void interpolate_row(const Resolution& r, Index i, const double* points, Index stride, double* across,
                       double* row) const;

  Grid grid_;
  Field pressure_;
  std::array<double, 3> weights_;  ///< of the tractions, per pressure
  double poisson_;
  int threads_;
  DepthLevels<Resolution> levels_;
};

/// Two cells, of their longer side; a period of one cell has no steps along it. From there on every value is within 1 %
/// of the largest pressure even below the edge of a Hertz contact (of ten cells' radius: components 6e-3, von Mises 8e-3,
/// falling as the root of the cell; with friction μ = 0.5 components 7e-3, von Mises 1.0e-2), of any ν. Above it, cells
/// nearer than this to an edge of the pressure may be off by shallow_error; others by 1.2 %, at z = 0 by 5.5 μ % more: a
/// tangential stress has the logarithm of the distance from each step of its traction q, which halfway between the steps
/// leaves at order 1
///     Δσxx = -(2 ln 2/π) Δx ∂qx/∂x,   Δσyy = ν Δσxx,   Δσxy = -(ln 2/π) Δy ∂qx/∂y   of qx, of qy likewise,
/// and fades as exp(-2πz/Δx).
double accurate_depth(const Grid& grid);
/// Of the largest pressure: 9 %, or 11 (1-2ν) % where that is more, and 26 μ % more under friction.
double shallow_error(double poisson, const Friction& friction);

}  // namespace asperity
