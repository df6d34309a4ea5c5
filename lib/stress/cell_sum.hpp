/// The stress at single points as stress/points.hpp has it, of a free load much faster.
///
/// The sum (1) there over the corners of the cells, each corner function times the twist of the pressures
/// about it (stress/influence.hpp), by the vector forms of stress/corner_tile.hpp; corners without a twist
/// are left out. Where corners cancel, deeper than 100 √m cells below m that are loaded, and below loads
/// that repeat, it is StressPoints that sums.
///
/// Accuracy  1e-10 of the stress below the load.
/// Cost      11 to 30 ns a corner; one double a corner.
#pragma once

#include <vector>

#include "stress/points.hpp"

namespace asperity {

class CellSum {
 public:
  explicit CellSum(LoadedBody body, int threads = 1);

  stress::Tensor at(double x, double y, double z) const;

 private:
  /// Rows of eight corners, some of which have a twist.
  struct Block {
    Index i, j, rows;  ///< of the first corner
    std::size_t twists;
  };
  void add(const Block& block, double x, double y, double z, stress::Tensor& sum) const;

  Grid grid_;
  double poisson_, deepest_;
  LoadWeights weights_;
  StressPoints points_;
  std::vector<Block> blocks_;
  std::vector<double> twists_;  ///< [block][row][8]
};

}  // namespace asperity
