/// Surfaces as moving averages of white noise.
///
///     z(i,j) = Σ_{k<K} Σ_{l<L} kernel(k,l) η(i+k, j+l),    0 ≤ i < N, 0 ≤ j < M                         (1)
///
/// from noise of (N+K-1) × (M+L-1) values or, on a periodic surface, of N × M values that repeat, however
/// large the kernel. The autocorrelation of z is that of the kernel or, on a periodic surface, its periodic
/// sum, whose variance differs if the correlation is longer than half the period (see acf/periodic.hpp).
///
/// The surface is drawn from its first row to its last in bands of whole tiles (TileFilter). A
/// band's noise is drawn row by row, the last K-1 rows are kept for the next band, and threads share the rows
/// and the tiles. The finished rows go to a sink in their order, a field in memory or a file, so that no more
/// than a band is held.
///
/// A band is as high as the threads need to be busy and the memory allows; tiles are the same in every band.
/// So the surface depends neither on the number of threads nor on the memory, to the last bit.
///
/// Of a kernel on a torus, the root of a spectrum (acf/periodic.hpp), the surface is the torus, which is
/// periodic, or a corner of it:
///     z = inverse transform of root · η^,                                                               (2)
/// one transform of the torus there and back. Its noise has the rows of the torus.
///
/// Symbols   N × M  points of the surface   K × L  of the kernel   A × B  of a tile   P × Q  of its torus
/// Accuracy  round-off: ε log2(P Q) Σ|kernel| max|η|.
/// Cost      direct: N M K L multiply-adds; by transform: two real transforms of P Q points a tile. The
///           cheaper one is taken. The noise costs 8 ns a value, and each value is drawn once.
/// Memory    (A + K - 1)(M + L - 1) + A M doubles for the lowest band, P Q shared and 2 P Q a thread; on a
///           torus of P Q points 1.5 P Q, half of a P Q of them shared by all surfaces.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>

#include "acf/periodic.hpp"
#include "core/field.hpp"
#include "math/noise.hpp"

namespace asperity {

/// (1): `out` of at most A × B heights from `noise` of K-1 rows and L-1 columns more.
using TileWorker = std::function<void(const Eigen::Ref<const Field>& noise, Eigen::Ref<Field> out)>;

/// A surface cut into tiles, and the moving average of white noise on one of them.
///
///     z(i,j) = Σ_{k<K} Σ_{l<L} kernel(k,l) η(i+k, j+l),    0 ≤ i < A, 0 ≤ j < B                          (1)
///
/// on a tile of A × B heights from (A+K-1) × (B+L-1) values of noise: as the sum stands, or by overlap–save,
/// on a torus of P = A+K-1 by Q = B+L-1 points where noise and conjugate kernel spectrum are multiplied.
///
/// A large tile wastes little on its overlap, a small one stays in the cache. The torus is the one for which
///     tiles · 2 P Q log2(P Q) · c(P Q),    c = c0 max(1, P Q / 2^17)^(1/4)                               (2)
/// is least among the fast lengths; c is what a butterfly of FFTW takes, c0 in the cache, and its fourth root
/// follows to a factor of 1.5 what is measured from 64² to 4320² points. Tiles depend on the kernel and the
/// surface alone, for the last bits of the heights depend on them.
///
/// T. G. Stockham, High-speed convolution and correlation, AFIPS Spring Joint Computer Conf. 28 (1966)
/// 229-233.
struct TileFilter {
  Shape tile;                              ///< A × B; tiles at the far edges of the surface are cut off
  std::size_t shared_bytes, worker_bytes;  ///< that all threads share, and that each of them needs
  std::function<TileWorker()> worker;      ///< for one thread, with its work space
};

/// The sum as it stands.
TileFilter direct_filter(const Field& kernel, Shape surface);
/// By overlap–save.
TileFilter transform_filter(const Field& kernel, Shape surface);

/// Seconds that each way takes on one thread, the noise apart, by (2) and by a product's time.
struct SynthesisCost {
  double direct, transform;
};
SynthesisCost synthesis_cost(Shape kernel, Shape surface);

enum class Summation { cheapest, direct, transform };

/// Takes rows first, first + 1, … of a surface, which it may alter, from the first to the last, on one
/// thread.
using RowSink = std::function<void(Index first, Eigen::Ref<Field> rows)>;

class Synthesis {
 public:
  struct Options {
    bool periodic = false;  ///< along both axes, as the grid of what is drawn is to say too
    Summation summation = Summation::cheapest;
    int threads = 1;
    /// Bound of working_set() [byte], kept by fewer rows and threads at a time.
    std::size_t memory = std::numeric_limits<std::size_t>::max();
    Pointwise translation = {};        ///< what a height of (1) becomes, if there is one
    std::size_t memory_elsewhere = 0;  ///< bytes in use meanwhile, which count in the working set
  };

  /// Throws ParameterError("shape") of a surface without points, ("kernel") of a kernel without coefficients,
  /// ("memory") when one strip needs more.
  Synthesis(Field kernel, Shape surface, Options options);
  /// (2), of the rms height `rms` before a translation; `periodic` is what the root's torus is. Throws
  /// ParameterError("shape") of a surface larger than the torus, and ("memory").
  Synthesis(SpectralRoot root, double rms, Shape surface, Options options);

  /// The surface of this noise, row by row. Exceptions of the sink pass on. For several threads at once.
  void surface(const WhiteNoise& noise, const RowSink& sink) const;
  Field surface(const WhiteNoise& noise) const;

  /// The noise under the surface: η(i + (K-1)/2, j + (L-1)/2), which the middle of the kernel multiplies.
  void noise_below(const WhiteNoise& noise, const RowSink& sink) const;

  Shape shape() const { return surface_; }
  Summation summation() const { return options_.summation; }  ///< the one taken
  /// Rows that a sink gets at a time, at most.
  Index band_rows() const { return strips_ * filter_.tile.nx; }
  /// Bytes that drawing takes, the result apart.
  std::size_t working_set() const { return root_ ? torus_bytes() : bytes(strips_, options_.threads); }

 private:
  void choose_band();
  std::size_t torus_bytes() const;
  Shape middle() const;  ///< the lag zero of the kernel
  void torus_rows(const WhiteNoise& noise, Field& room, const RowSink& sink) const;
  void noise_of_torus(const WhiteNoise& noise, const RowSink& sink) const;
  std::size_t bytes(Index strips, int threads) const;
  Index noise_columns() const { return surface_.ny + kernel_.cols() - 1; }
  void draw(const WhiteNoise& noise, Index first, Eigen::Ref<Field> rows) const;
  void bands(const WhiteNoise& noise, Eigen::Ref<Field> room, const RowSink& sink) const;
  void filter(const Eigen::Ref<const Field>& noise, Eigen::Ref<Field> out) const;

  Field kernel_ = {};
  std::shared_ptr<const SpectralRoot> root_ = {};  ///< in place of a kernel
  Shape surface_;
  Options options_;
  TileFilter filter_ = {};
  Index strips_ = 1;  ///< rows of tiles in a band
};

}  // namespace asperity
