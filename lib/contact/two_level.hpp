/// A preconditioner of K on a free set F, as good for sparse sets on fine grids as for dense ones.
///
/// On a set that fills a share φ of the cells, P_F M P_F sees waves far longer than its gaps as (1-φ) M₀₀,
/// however long they are: the condition number grows as φ (1-φ) L/Δx. Here blocks of 8 × 8 cells carry the
/// long waves, and M the rest:
///     B = Π M Π + Z N⁻¹ (K_c + D)⁻¹ N⁻¹ Zᵀ,                                                   (1)
///     D = b² K₀₀ [1/n + (1 - 1/n)/(b+1) - 1/b].                                               (2)
/// Z holds the indicators of F in the blocks, N their counts n; Π subtracts from a field its mean over F in
/// each block. K_c is K on cells b = 8 times as long and wide, over the blocks that F meets; D is by how much
/// a block is stiffer that is filled in part, 0 where n = b². Both terms are symmetric, the first positive
/// definite on fields without block means, the second on those that are nothing else: B is definite on F.
///
/// (K_c + D) x = y is solved by conjugate gradients with the preconditioner s M_c s + D/(k+D)², s² = k/(k+D),
/// k that of K_c. They end early, so that B varies a little from step to step: contact/subspace_cg.hpp allows
/// for it.
///
/// Accuracy  (K_c + D) x = y to a residual of 0.01 |y|.
/// Cost      M, some passes over the cells, up to ten K_c and M_c, each of 1/64 of K or M.
/// Memory    the symbols and some fields of the blocks.
///
/// J. H. Bramble, J. E. Pasciak, J. Xu, Parallel multilevel preconditioners, Math. Comput. 55 (1990) 1-22.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "contact/blocks.hpp"
#include "contact/calibration.hpp"
#include "contact/elastic_operator.hpp"

namespace asperity {

/// When conjugate gradients on blocks end.
struct BlockEnd {
  double tolerance = contact::block_tolerance;  ///< of |y|
  int steps = contact::block_steps;
};

class TwoLevel {
 public:
  static constexpr Index side = 8;  ///< b

  explicit TwoLevel(ElasticOperator& body, int threads = 1, BlockEnd end = {});

  /// Whether a grid has so many cells that it may pay.
  static bool suits(Shape shape) {
    return std::min(shape.nx, shape.ny) >= 2 * side && shape.cells() >= contact::fine_cells;
  }

  /// F from now on: 1 for its cells, 0 for the others.
  void set(const std::vector<std::int8_t>& mask);
  /// The blocks that F fills in part, over those of a disc that meets as many blocks: about 1 for smooth
  /// bodies on any grid, √N for N alike. It grows as the grid is refined where holes and islands of any size
  /// appear, the sets for which M alone does not do.
  double raggedness() const { return raggedness_; }
  /// z = B r of an r that is 0 off F, as z is. `z` may be `r`.
  void apply(const Field& r, Field& z);
  /// Of K_c, and of M_c, since F was set, by their share of the cells.
  double coarse_applications() const;

 private:
  template <class Visit>
  void each_block_row(Visit visit) const;
  Blocks blocks() const { return {coarse_->slabs(), coarse_->shape().ny, 1}; }
  double sum(const Field& f) const {
    return blocks().sum([&](Block b) { return b.of(f).sum(); });
  }
  // From the rows of blocks of this rank's cells to those that it has of K_c, and back.
  Field to_coarse(Field here) const;
  Field from_coarse(const Field& coarse) const;
  void remove_means(const Field& r, Field& z);
  void solve();
  void add_blocks(Field& z) const;
  Field precondition(const Field& r);

  ElasticOperator& body_;
  std::unique_ptr<ElasticOperator> coarse_;
  const std::int8_t* mask_ = nullptr;
  Shape shape_;  ///< of the cells here
  int threads_, applications_ = 0;
  BlockEnd end_;
  double raggedness_ = 0;
  Field inverse_here_;       ///< 1/n, or 0 where n is, of the cells here
  Field inverse_, stiffer_;  ///< the same for K_c; D
  Field scale_, rest_;       ///< s and D/(k+D)², 0 where n is
  Field y_, x_, x_here_;     ///< block means of r; (K_c + D)⁻¹ of them
};

}  // namespace asperity
