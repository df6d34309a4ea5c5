/// The transform of a field padded with zeros, without touching the zeros.
///
/// A linear convolution of an nx × ny field pads it to Px × Py, Px ≥ 2nx - 1, Py ≥ 2ny - 1: three quarters
/// are zeros, and three quarters of the result are thrown away. Here only the rows that hold data are
/// transformed in y; the columns of the half spectrum follow in blocks of eight that stay in the cache while
/// they are transformed in x, multiplied and transformed back; only nx rows are kept and return from y. Rows
/// go to and from the half spectrum eight at a time, a kilobyte of every block.
///
///     rows → half spectrum → (per block: load, forward, multiply, inverse, store) → half spectrum → rows
///
/// Cost: there and back 0.4 of one padded real-to-complex transform from 1024² on, where the plain way takes
/// 2; below, in the cache, 1.0 to 1.2 (validation/contact_error_time.cpp).
/// Memory: 2 nx (Py/2 + 8) doubles for a half spectrum, 16 Px for a block.
///
/// On several ranks (core/ranks.hpp) each holds its rows of field and half spectrum, and works on its share
/// of the blocks, whose rows come from all ranks, some blocks at a time, and go back: what goes to a rank is
/// one piece of memory. Results have the bits of one rank.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "core/field.hpp"
#include "core/parallel.hpp"
#include "core/ranks.hpp"
#include "transform/block_exchange.hpp"
#include "transform/plan.hpp"
#include "transform/rows.hpp"

namespace asperity {

/// Rows transformed in y, columns not yet in x: block b holds columns 8b … 8b+7 of nx rows, [b][i][8].
template <class Real>
using BasicHalfSpectrum = AlignedVector<std::complex<Real>>;
using HalfSpectrum = BasicHalfSpectrum<double>;

/// Writes row i of a field that is never whole in memory; called by several threads at once.
using RowSource = std::function<void(Index i, double* row)>;

template <class Real>
class BasicPrunedTransform {
 public:
  using Number = std::complex<Real>;
  using HalfSpectrum = BasicHalfSpectrum<Real>;
  using Rows = BasicRowTransform<Real>;
  static constexpr Index width = 8;  ///< columns in a block

  /// `torus` may equal `field`: a periodic transform, nothing pruned. Of all ranks' rows.
  BasicPrunedTransform(Shape field, Shape torus, Ways ways = Ways::both, const Ranks& ranks = alone());

  Shape field() const { return field_; }
  const Slabs& slabs() const { return slabs_; }
  Shape torus() const { return torus_; }
  Index columns() const { return torus_.ny / 2 + 1; }
  Index blocks() const { return (columns() + width - 1) / width; }
  Index stride() const { return columns_.stride(); }  ///< from one column of a block to the next
  Index block_size() const { return columns_.size(); }
  Index half_size() const { return blocks() * rows_here() * width; }  ///< points of a half spectrum
  /// The blocks that a rank works on: its share of columns.
  Extent blocks_of(int rank) const { return blocks_of(torus_, slabs_.ranks(), rank); }
  Extent own_blocks() const { return blocks_of(slabs_.ranks().rank()); }
  static Extent blocks_of(Shape torus, const Ranks& ranks, int rank) {
    return asperity::blocks_of((torus.ny / 2 + width) / width, ranks, rank);
  }
  HalfSpectrum half_spectrum() const;

  /// The rows of `in`, times `scale`, into the half spectrum.
  void forward_rows(const Field& in, std::span<Number> half, int threads = 1, double scale = 1) const;
  /// The same, without a copy of the field.
  void forward_each_row(const RowSource& in, std::span<Number> half, int threads = 1) const;
  /// The rows of `out` from the half spectrum, multiplied by Px Py and `scale`.
  void inverse_rows(std::span<const Number> half, Field& out, int threads = 1, double scale = 1) const;
  /// The rows first ≤ i < first + count alone, eight at most: the first `wanted` points of each, to out +
  /// (i - first)·apart.
  void inverse_group(std::span<const Number> half, Index first, Index count, Index wanted, double* out,
                     Index apart, typename Rows::Work& work) const {
    rows_.inverse(half.data() + first * width, rows_here() * width, count, wanted, out, apart, work);
  }
  typename Rows::Work row_work() const { return rows_.work(); }

  /// work(b, block) of every block of the half spectrum that is this rank's, transformed in x as by
  /// forward_block.
  template <class Work>
  void each_block(std::span<const Number> half, int threads, Work work) const {
    each_block(half, blocks(), threads, work);
  }
  /// The same of the first `count` blocks alone, in equal shares.
  template <class Work>
  void each_block(std::span<const Number> half, Index count, int threads, Work work) const {
    if (slabs_.shared())
      return shared_pass({half, std::nullopt, count}, threads,
                         [&](Index b, Number* block, int) { work(b, block); });
    pass(count, threads, [&](Index b, Number* block, Number* scratch, int) {
      forward_block(half, b, block, scratch);
      work(b, block);
    });
  }
  /// The same, and what work has made of it back into the half spectrum.
  template <class Work>
  void filter(std::span<Number> half, int threads, Work work) const {
    if (slabs_.shared())
      return shared_pass({half, half, blocks()}, threads,
                         [&](Index b, Number* block, int) { work(b, block); });
    pass(blocks(), threads, [&](Index b, Number* block, Number* scratch, int) {
      forward_block(half, b, block, scratch);
      work(b, block);
      inverse_block(block, b, half, scratch);
    });
  }
  /// Writes the half spectrum, without reading it: each block as work(b, block, worker) fills it.
  template <class Work>
  void compose(std::span<Number> half, int threads, Work work) const {
    if (slabs_.shared()) return shared_pass({std::nullopt, half, blocks()}, threads, work);
    pass(blocks(), threads, [&](Index b, Number* block, Number* scratch, int worker) {
      work(b, block, worker);
      inverse_block(block, b, half, scratch);
    });
  }
  /// As filter(), but transformed no more: the half spectrum gets the first nx rows of what work has made. Of
  /// one rank alone.
  template <class Work>
  void change_each_block(std::span<Number> half, int threads, Work work) const {
    pass(blocks(), threads, [&](Index b, Number* block, Number* scratch, int) {
      forward_block(half, b, block, scratch);
      work(b, block);
      rows_from_columns<width>(block, stride(), field_.nx, half.data() + b * field_.nx * width);
    });
  }

  // Of one rank alone.
  /// Block b of the half spectrum, zeros below it, transformed in x: `block` [8][kx] of block_size() points,
  /// as `work` has.
  void forward_block(std::span<const Number> half, Index b, Number* block, Number* work) const;
  /// Back again: transforms `block` and keeps the first nx rows.
  void inverse_block(const Number* block, Index b, std::span<Number> half, Number* work) const;

 private:
  template <class Group>
  void by_groups(int threads, Group visit) const;
  template <class Work>
  void pass(Index count, int threads, Work work) const {
    parallel_ranges(count, threads, [&](Index begin, Index end, int worker) {
      HalfSpectrum block(size(block_size())), scratch(block.size());
      for (Index b = begin; b < end; ++b) work(b, block.data(), scratch.data(), worker);
    });
  }

  // Blocks of all ranks' rows: the half spectrum that they come from, if any, and the one they go to.
  struct Shared {
    std::optional<std::span<const Number>> half;
    std::optional<std::span<Number>> back;
    Index count;
  };
  using Visit = std::function<void(Index b, Number* block, int worker)>;
  void shared_pass(const Shared& blocks, int threads, const Visit& work) const;
  // Behind the rows of the field, `columns` are filled with zeros.
  void forward_columns(Number* columns, Number* block) const;
  Index rows_here() const { return slabs_.own().count; }

  Shape field_, torus_;
  Slabs slabs_;
  Rows rows_;
  BasicColumnTransform<Real> columns_;
};
using PrunedTransform = BasicPrunedTransform<double>;

}  // namespace asperity
