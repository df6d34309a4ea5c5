/// The stress at single points below a load of many cells, fast: cells near one by one, others in blocks.
///
/// The load is that of stress/points.hpp (1), on a free half-space. The cells are gathered in blocks of 64,
/// as nearly square as powers of two allow, these by two in each direction into blocks twice as long, and so
/// on. The load of a block acts at 8 × 8 Chebyshev points x_m, with the weights of the interpolation of the
/// field that it meets [1],
///     w_mn = Σ_cells p ∫∫ l_m(x) l_n(y) dx dy,   l_m the polynomial that is 1 at x_m and 0 at the others.
/// A block acts as a whole on places farther from its middle than 1.7 of its longer sides; a place less deep
/// than two blocks of cells has the 5 × 5 about it summed cell by cell, in corners (stress/influence.hpp).
///
/// Accuracy  1e-7 of the largest pressure (tests/stress/cell_tree.cpp).
/// Cost      30 operations a cell to gather; then a point takes 0.1 ms on 512 × 512 cells, and longer as the
///           logarithm of their number. Memory: 1⅓ doubles a cell.
///
/// [1] W. Fong, E. Darve, The black-box fast multipole method, J. Comp. Physics 228 (2009) 8712-8725.
#pragma once

#include <vector>

#include "stress/load.hpp"

namespace asperity {

class CellTree {
 public:
  /// The body is kept by reference, and its check() is the caller's. It is not periodic.
  explicit CellTree(const LoadedBody& body);

  stress::Tensor at(double x, double y, double z) const;

 private:
  static constexpr Index q = 8;  ///< points along a side of a block
  using Matrix = Eigen::Array<double, q, Eigen::Dynamic>;

  struct Level {
    Index nx = 0, ny = 0;         ///< blocks
    double sx = 0, sy = 0;        ///< their sides [m]
    std::vector<double> weights;  ///< [block][8][8] [N]
    std::vector<unsigned char> loaded;
  };
  /// Blocks that are summed by cells: i0 ≤ i < i1, j0 ≤ j < j1.
  struct Near {
    Index i0 = 0, i1 = 0, j0 = 0, j1 = 0;
  };
  struct Target;

  void gather_cells();
  void gather_blocks();
  void add_block(Target& target, std::size_t level, Index i, Index j) const;
  void add_cells(Target& target) const;

  const LoadedBody& body_;
  LoadWeights weights_;
  Index bx_, by_;  ///< cells of a block
  double x0_, y0_;
  std::vector<Level> levels_;
};

}  // namespace asperity
