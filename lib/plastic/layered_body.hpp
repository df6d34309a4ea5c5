/// An elastic half-space of layers that may have flown: stress and displacement under a pressure.
///
/// A pressure p on the cells of a surface and a plastic strain ε in the layers below them leave
///     σ = B p + S ε,     u = Bᵀ ε.                                                                     (1)
/// B is the elastic stress of uniformly loaded cells (stress/layer_influence.hpp), averaged over each layer
/// by Gauss's rule of two points. By Betti's theorem its transpose gives the displacement of the surface
/// that the strain leaves, positive into the body, since the pressure's own stress does work on the strain:
///     Σ p u ΔxΔy = Σ h ΔxΔy (B p):ε.                                                                   (2)
/// S is that of plastic/layer_waves.hpp by Fourier transform. Of a free surface both are free of images: B
/// by padding, S since plastic/image_strains.hpp takes them off. Of a periodic one nothing is padded. As
/// (2), and S being symmetric, flow and contact have a common potential.
///
/// A wave of Nyquist stands for +q and -q together: its stress is the mean over both, without which a body
/// and its mirror image would differ.
///
/// Symbols   p pressure [Pa]   ε plastic strain   σ deviator of the stress [Pa]   u displacement [m]   h
///           thickness of a layer [m]   Δx, Δy cell [m]
/// Accuracy  S: exact for trigonometric polynomials that are uniform in each layer; order 2 in the layers'
///           thickness for smooth strains, σxz of the first layer order 1. B in single precision: 1e-7 p.
/// Cost      of n layers (1) takes 10 n padded real transforms, 5 n more in x, and as long again for the
///           waves: 128 × 128 × 32 0.25 s. Memory: 10 n Px (Py/2) bytes for B on a torus of Px × Py, twice
///           the cells a side, and of the spectra 175 MB at a time; where they take more, rows are
///           transformed again for each group of columns.
#pragma once

#include "plastic/image_strains.hpp"
#include "stress/layer_influence.hpp"
#include "transform/pruned.hpp"

namespace asperity {

class LayeredBody {
 public:
  static constexpr double most_spectra = 175e6;  ///< in memory at a time [bytes]

  /// Layers between these edges [m], the first of which is 0.
  LayeredBody(const Grid& cells, std::vector<double> edges, double shear_modulus, double poisson,
              int threads = 1);

  const Grid& grid() const { return grid_; }
  const std::vector<double>& edges() const { return edges_; }
  Index layers() const { return waves_.layers(); }
  double thickness(Index k) const { return edges_[size(k + 1)] - edges_[size(k)]; }

  /// ε, of which the next two functions tell; they come in this order.
  void set_strain(const LayeredField& strain);
  /// u of (1) [m].
  Field displacement();
  /// σ of (1) [Pa], and its mean where `out` has six components. Then, or without a pressure, of the strain
  /// alone.
  void stress(const Field* pressure, LayeredField& out);

 private:
  using Lanes = LayerWaves::Lanes;
  /// Waves of a column of the spectrum, in lanes; those of Nyquist's come first, as +q and as -q.
  struct Chunk {
    LayerWaves::Places places;
    Lanes qx, sign;  ///< sign: of a kernel that is odd in x, which is stored for qx ≥ 0
    std::array<Index, LayerWaves::lanes> at;  ///< in that kernel
    bool nyquist = false;
  };
  struct Buffers;
  struct Rows;

  void make_chunks();
  void make_pressed();
  void add_kernel(LayerInfluence& influence, Index k);
  float* pressed(Index ky, Index k, Index c) {
    return pressed_.data() + ((ky * layers() + k) * deviator::components + c) * kernel_rows_;
  }
  /// The column after those of a block.
  Index end_of(Index block) const { return std::min((block + 1) * block_columns, transform_.columns()); }
  /// Of the loaded blocks, [block][row][8].
  Index spectrum_size() const { return loaded_.count * grid_.shape.nx * block_columns; }
  Complex* spectrum(Index k, Index c) { return spectra_.data() + (k * components_ + c) * spectrum_size(); }
  /// Blocks of columns whose spectra are in memory together.
  std::vector<Extent> groups(Index components) const;
  template <class Visit>
  void each_group(Index fields, Visit visit);
  void load(Extent blocks, Index components);
  void add_rows(Extent blocks, LayeredField& out);
  void sum_displacement(Index b, Index block, Buffers& buffers);
  void respond_block(Index b, Index block, bool pressed, Buffers& buffers);
  void forward_columns(const Complex* rows, Complex* columns, Complex* scratch) const;
  void respond(Index ky, Index column, const Complex* pressure, Buffers& buffers);
  void add_pressed(const Chunk& chunk, Index ky, int part, const Complex* pressure, LayerWaves::Work& work);

  Grid grid_;
  std::vector<double> edges_;
  double two_mu_, poisson_;
  int threads_;
  PrunedTransform transform_;  ///< of pressure and displacement
  RowTransform rows_;
  ColumnTransform columns_;
  LayerWaves waves_;
  Index kernel_rows_;             ///< Px/2 + 1
  AlignedVector<float> pressed_;  ///< B in the waves' basis: [ky][layer][component][kx]
  std::vector<Chunk> chunks_;
  Index components_ = deviator::components;
  AlignedVector<Complex> spectra_;  ///< of ε, then of σ: [layer][component][block]
  Extent loaded_;                   ///< blocks of the strain's; none: of no strain
  const LayeredField* strain_ = nullptr;
};

/// u of (1) [m] at all cells of a grid, of a strain below the window that begins at its cell (i, j): the same
/// to round-off and single precision, layer by layer in little memory.
Field surface_displacement(const Grid& grid, Index i, Index j, const std::vector<double>& edges,
                           double poisson, const LayeredField& strain, int threads = 1);

}  // namespace asperity
