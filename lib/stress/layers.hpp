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
/// Depth multiresolution. Below the surface a mode fades as exp(-kz): at z ≥ 8 s Δ, Δ the longer side of a cell, those
/// beyond π/sΔ are below 1e-10. Such a layer is computed from the influence of cells s times as long and wide and
/// the pressure's modes below π/sΔ, each times
///     ratio = sinc(kΔ/2) / sinc(k s Δ/2)  in x and in y,                                              (2)
/// which makes of the wide cells the narrow ones; an inverse padded with zeros has the values at all cells. s is a power
/// of two that leaves 32 cells a side. What is cut off the spectrum spreads the pressure by some wide cells, for which
/// the torus must have room beside the load: eight of them, or narrower cells are taken. The error is then below
/// 2e-6 of the largest pressure, in a periodic layer below 1e-9.
///
/// Symbols   σ  stress, positive in tension [Pa]     p  pressure of each cell [Pa]     z  depth, ≥ 0 [m]
/// Scope     a linear elastic half-space; any grid, Δx ≠ Δy, periodic or not.
/// Accuracy  of (1): round-off, below 16 ε Σ|p|. Of (1) as a model of a smooth pressure p(x, y): (h²/12) ∇²p in
///           effect, order 2 in h at depth, 1.2e-4 max p for a Hertz contact 85 cells wide. Near the surface
///           the steps of the pressure show below its edges: see accurate_depth.
/// Cost      per layer and component about one padded complex transform of half the torus; six components of
///           128 × 128 cells take 9-12 padded real transforms, 2-4 ms. Memory: 4 N doubles for the
///           pressure, and per thread 3 N for each component asked, N = nx ny.
///
/// S. Liu, Q. Wang, J. Tribology 124 (2002) 36-45; pruning: transform/pruned.hpp.
#pragma once

#include <functional>
#include <vector>

#include "grid/field.hpp"
#include "stress/component.hpp"
#include "stress/friction.hpp"
#include "stress/layer_influence.hpp"
#include "transform/pruned.hpp"

namespace asperity {

/// One row of a layer: for each component that was asked its ny values, else a null pointer.
using StressRow = std::array<const double*, 6>;

enum class DepthResolution {
  full,     ///< every layer from its own cells
  adapted,  ///< deep layers by (2)
};

class StressSolver {
 public:
  /// Throws ParameterError("poisson") unless 0 ≤ ν ≤ ½, DataError("pressure") unless the pressure fits the
  /// grid and is finite.
  StressSolver(const Grid& grid, const Field& pressure, double poisson, int threads = 1,
               DepthResolution resolution = DepthResolution::full);
  /// With the traction of sliding friction. Throws ParameterError("friction") or ("friction-angle") too.
  StressSolver(const Grid& grid, const Field& pressure, const Friction& friction, double poisson,
               int threads = 1, DepthResolution resolution = DepthResolution::full);

  const Grid& grid() const { return grid_; }
  const Field& pressure() const { return pressure_; }
  double poisson() const { return poisson_; }
  int threads() const { return threads_; }

  /// What one thread needs to compute layers; may be used again for any depth and components.
  class Workspace {
   public:
    explicit Workspace(const StressSolver& solver);

   private:
    friend class StressSolver;
    LayerInfluence& influence(const StressSolver& solver, std::size_t level);

    std::vector<std::unique_ptr<LayerInfluence>> influences_;  ///< of each level, made when it is used
    Index filled_ = 0;                                         ///< blocks of the present layer
    AlignedVector<Complex> block_, work_, row_spectrum_;
    std::array<HalfSpectrum, 6> half_;
    std::array<AlignedVector<double>, 6> row_;
  };

  /// The layer at depth z, row after row: row(i, values). Throws ParameterError("depth") unless 0 ≤ z < ∞.
  template <class RowSink>
  void layer(double z, stress::Set asked, Workspace& work, RowSink row) const {
    transform_layer(z, asked, work);
    for (Index i = 0; i < grid_.shape.nx; ++i) row(i, inverse_row(i, asked, work));
  }

  /// Many layers on all threads: row(layer, i, values) is called from several threads at once, for one layer
  /// from one thread and in order. The values do not depend on the number of threads.
  using LayerRowSink = std::function<void(Index layer, Index i, const StressRow& values)>;
  void layers(const std::vector<double>& depths, stress::Set asked, const LayerRowSink& row) const;

 private:
  /// Cells s times as long and wide, for deep layers; s = 1 first.
  struct Level {
    Index s = 1;
    Grid grid;  ///< of the influence
    Shape torus;
    Shape modes;                           ///< 0 ≤ kx < modes.nx, 0 ≤ ky < modes.ny are kept
    std::vector<double> ratio_x, ratio_y;  ///< (2)
  };

  bool may_coarsen(Index s) const;
  void add_level(Index s);
  std::size_t level_at(double z) const;
  void transform_layer(double z, stress::Set asked, Workspace& work) const;
  class Column;
  void multiply(const Level& level, stress::Component c, Index b, LayerInfluence& influence,
                Complex* product) const;
  void multiply_column(const Level& level, stress::Component c, const Column& column, double ratio_y,
                       const Complex* p, Complex* out) const;
  StressRow inverse_row(Index i, stress::Set asked, Workspace& work) const;

  Grid grid_;
  Field pressure_;
  std::array<double, 3> weights_;  ///< of the tractions, per pressure
  double poisson_;
  int threads_;
  PrunedTransform transform_;
  std::vector<Level> levels_;
  AlignedVector<Complex> pressure_spectrum_;  ///< [block][8][kx], divided by Px Py
};

/// Two cells. From there on every value is within 1 % of the largest pressure even below the edge of a Hertz
/// contact (of ten cells' radius: components 6e-3, von Mises 8e-3, falling as the root of the cell). Above
/// it, cells nearer than this to an edge of the pressure may be off by up to 8 %; others keep to 1 %.
double accurate_depth(const Grid& grid);

}  // namespace asperity
