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
#include "core/ranks.hpp"

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

/// Blocks of the rows that a rank has: runs of cells within eight rows, whatever the number of ranks.
class Blocks {
 public:
  Blocks(const Slabs& slabs, Index columns, int threads)
      : ranks_(slabs.ranks()),
        cells_(slabs.own().count * columns),
        group_(rows * columns),
        threads_(useful_threads(cells_, threads)) {}

  /// visit(block) returns the block's part, plain data; the parts are added by +=, in order: those of eight
  /// rows, then those of all ranks.
  template <class Visit>
  auto sum(Visit visit) const {
    auto parts = parts_of(visit);
    if (ranks_.count() > 1) parts = gathered(ranks_, parts);
    for (std::size_t k = 1; k < parts.size(); ++k) parts.front() += parts[k];
    return parts.front();
  }

  /// visit(block), nothing summed.
  template <class Visit>
  void each(Visit visit) const {
    parts_of([&](Block block) {
      visit(block);
      return 0;
    });
  }

 private:
  static constexpr Index length = 1024, rows = 8;

  template <class Visit>
  auto parts_of(Visit visit) const {
    using Part = decltype(visit(Block{}));
    std::vector<Part> parts(size((cells_ + group_ - 1) / group_));
    parallel_ranges(std::ssize(parts), threads_, [&](Index first, Index last, int) {
      for (Index k = first; k < last; ++k) {
        const Index end = std::min((k + 1) * group_, cells_);
        Index begin = k * group_;
        auto next = [&] {
          const Block block{begin, std::min(length, end - begin)};
          begin = block.begin + block.size;
          return visit(block);
        };
        Part& part = parts[size(k)] = next();
        while (begin < end) part += next();
      }
    });
    return parts;
  }

  const Ranks& ranks_;
  Index cells_, group_;
  int threads_;
};

}  // namespace asperity
