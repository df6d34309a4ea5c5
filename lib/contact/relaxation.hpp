/// Relaxation of a pressure within its bounds, cell by cell with its neighbours.
///
/// Where a step on a free set leaves the bounds, clipping is not enough: the load that a cell loses belongs
/// to its neighbours. About a pressure p with g = h + K p the energy of a change d, 0 ≤ p + d ≤ c, is
/// modelled by
///     E = (g - δ)·d + ½ d·A d,   A = K_t + β Z Zᵀ,                                            (1)
///     K_t(i,j) = max(0, K(i,j) - K_R),   β = 4 K_R,                                           (2)
/// with K_R the larger of K(3,0) and K(0,3), so that K_t reaches two cells; Z holds the indicators of blocks
/// of 8 × 8 cells, whose load β holds where it is. Each cell in turn takes the pressure of the least E,
///     p + d ← clip(p + d - (g - δ + A d)/A₀₀, 0, c),                                          (3)
/// in sweeps forth and back. E never rises. It is a model: whether the energy falls is for the caller to see.
///
/// Rows are swept forth and back in strips of 64, all even strips before the odd ones: strips of a kind do
/// not reach each other and may run on several threads or ranks, and a strip stays in the cache. In a row
/// every eighth cell comes first, then their neighbours, and so on: those that are eight apart
/// neither reach each other nor share a block, and are relaxed in vector lanes.
///
/// Cost    25 operations a cell and sweep; four sweeps take 0.5 to 0.8 of a padded K.
/// Memory  none of its own but for the loads of blocks: d uses memory of K that is free then.
///
/// A. Brandt, C. W. Cryer, Multigrid algorithms for the solution of linear complementarity problems arising
/// from free boundary problems, SIAM J. Sci. Stat. Comput. 4 (1983) 655-684.
#pragma once

#include <array>

#include "contact/elastic_operator.hpp"

namespace asperity {

class Relaxation {
 public:
  static constexpr Index reach = 2;  ///< of K_t
  static constexpr Index block = 8, strip = 64;

  explicit Relaxation(ElasticOperator& body, int threads = 1);

  /// p ← p + d after so many sweeps, an even number, for a limit pressure c. Leaves g in another order.
  void relax(Field& p, Field& g, double approach, double cap, int sweeps);

 private:
  struct Sweeps;
  using Rows = Eigen::Map<Field>;
  void fetch_rows_beside(Rows& d) const;

  ElasticOperator& body_;
  Slabs slabs_;
  std::array<std::array<double, reach + 1>, reach + 1> near_;  ///< K_t [m/Pa]
  double held_;                                                ///< β [m/Pa]
  int threads_;
  Field loads_;  ///< Zᵀ d
};

}  // namespace asperity
