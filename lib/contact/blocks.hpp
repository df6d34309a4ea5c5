/// Passes over the cells of fields, in blocks that stay in the cache.
///
/// A step of the solver reads the same cells for several sums and updates: block by block, once from memory.
/// The sums of blocks are added in order, so that no result depends on the number of threads.
#pragma once

#include <algorithm>
#include <type_traits>
#include <vector>

#include "core/field.hpp"
#include "core/parallel.hpp"

namespace asperity {

struct Block {
  Index begin = 0, size = 0;

  /// Of a field or a vector.
  template <class Cells>
  auto of(Cells& cells) const {
    using Value = std::remove_pointer_t<decltype(cells.data())>;
    using Part = Eigen::Array<std::remove_const_t<Value>, Eigen::Dynamic, 1>;
    return Eigen::Map<std::conditional_t<std::is_const_v<Value>, const Part, Part>>(cells.data() + begin,
                                                                                    size);
  }
};

/// As many as pay for a pass over so many cells.
inline int useful_threads(Index cells, int threads) {
  constexpr Index worth_a_thread = 1 << 18;
  return cells < worth_a_thread ? 1 : threads;
}

/// Blocks of `cells` cells; how many depends on nothing else.
class Blocks {
 public:
  Blocks(Index cells, int threads) : cells_(cells), threads_(useful_threads(cells, threads)) {}

  /// visit(block) returns the block's part; the parts are added by +=, in order.
  template <class Visit>
  auto sum(Visit visit) const {
    using Part = decltype(visit(Block{}));
    std::vector<Part> parts(static_cast<std::size_t>((cells_ + length - 1) / length));
    parallel_ranges(static_cast<Index>(parts.size()), threads_, [&](Index begin, Index end, int) {
      for (Index k = begin; k < end; ++k)
        parts[static_cast<std::size_t>(k)] = visit(Block{k * length, std::min(length, cells_ - k * length)});
    });
    for (std::size_t k = 1; k < parts.size(); ++k) parts.front() += parts[k];
    return parts.front();
  }

  /// visit(block), nothing summed.
  template <class Visit>
  void each(Visit visit) const {
    sum([&](Block block) {
      visit(block);
      return 0;
    });
  }

 private:
  static constexpr Index length = 1024;

  Index cells_;
  int threads_;
};

}  // namespace asperity
