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
#pragma once

#include <functional>

#include "core/field.hpp"

namespace asperity {

/// (1): `out` of at most A × B heights from `noise` of K-1 rows and L-1 columns more.
using TileWorker = std::function<void(const Eigen::Ref<const Field>& noise, Eigen::Ref<Field> out)>;

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

}  // namespace asperity
