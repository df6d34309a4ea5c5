/// Blocks of eight columns whose rows ranks share: each rank works on some of the blocks, with all rows.
///
/// A rank has its own rows of all blocks, [block][row][8]. What goes to another is one piece; the blocks
/// come some at a time, so that the buffer stays small.
///
///     BlockExchange<Complex> blocks(rows, count, threads);
///     for (Index step = 0; step < blocks.steps(); ++step) {
///       blocks.fetch(step, own_rows);           // collective
///       … blocks.part(step, k, rank) of blocks.at_hand(step) …
///       blocks.give_back(step, own_rows);       // collective
///     }
///
/// Cost      each way, all of a rank's rows but its own share goes to others. Memory: 2^19 numbers, or a
///           block for each thread.
#pragma once

#include <algorithm>
#include <complex>
#include <span>

#include "core/ranks.hpp"
#include "transform/plan.hpp"

namespace asperity {

/// The blocks of `count` that a rank works on.
inline Extent blocks_of(Index count, const Ranks& ranks, int rank) {
  const Index first = count * rank / ranks.count();
  return {first, count * (rank + 1) / ranks.count() - first};
}

template <class Number>
class BlockExchange {
 public:
  static constexpr Index width = 8;

  /// Of so many blocks; at a time at least one for each thread.
  BlockExchange(const Slabs& rows, Index count, int threads);

  Index steps() const { return steps_; }
  Extent at_hand(Index step) const { return at_hand(step, rows_.ranks().rank()); }
  void fetch(Index step, std::span<const Number> own);
  void give_back(Index step, std::span<Number> own);
  /// [row][8] of a rank's rows, of the k-th block at hand.
  std::span<Number> part(Index step, Index k, int rank) {
    const Index points = rows_.of(rank).count * width;
    return all_of(step, rank).subspan(size(k * points), size(points));
  }

 private:
  Extent at_hand(Index step, int rank) const {
    const Extent own = blocks_of(count_, rows_.ranks(), rank);
    const Index before = std::min(step * most_, own.count);
    return {own.first + before, std::min(most_, own.count - before)};
  }
  std::span<Number> all_of(Index step, int rank) {
    const Extent rows = rows_.of(rank);
    const Index count = at_hand(step).count;
    return std::span(here_).subspan(size(count * rows.first * width), size(count * rows.count * width));
  }
  // Of this rank's rows, what a rank works on at a step.
  template <class Values>
  auto piece(Index step, int rank, Values own) const {
    const Extent theirs = at_hand(step, rank);
    const Index points = rows_.own().count * width;
    return own.subspan(size(theirs.first * points), size(theirs.count * points));
  }

  const Slabs rows_;
  Index count_, most_, steps_;
  AlignedVector<Number> here_;  ///< rank by rank [block][row][8]
};

}  // namespace asperity
