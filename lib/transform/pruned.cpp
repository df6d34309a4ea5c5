#include "transform/pruned.hpp"

#include <algorithm>

#include "core/large_pages.hpp"

namespace asperity {
namespace {
constexpr Index width = PrunedTransform::width;
}

template <class Real>
BasicPrunedTransform<Real>::BasicPrunedTransform(Shape field, Shape torus, Ways ways, const Ranks& ranks)
    : field_(field),
      torus_(torus),
      slabs_(field.nx, ranks),
      rows_(torus.ny, ways),
      columns_(torus.nx, width, ways) {
  static_assert(width == Rows::width);
}

template <class Real>
auto BasicPrunedTransform<Real>::half_spectrum() const -> HalfSpectrum {
  const std::size_t room = size(half_size());
  HalfSpectrum out;
  out.reserve(room);
  prefer_large_pages(out.data(), room * sizeof(Number));
  out.resize(room);
  return out;
}

// visit(first, count, work) for groups of neighbouring rows, whose parts of a block lie side by side.
template <class Real>
template <class Group>
void BasicPrunedTransform<Real>::by_groups(int threads, Group visit) const {
  constexpr Index group = Rows::rows;
  const Index nx = rows_here();
  parallel_ranges((nx + group - 1) / group, threads, [&](Index begin, Index end, int) {
    typename Rows::Work work = row_work();
    for (Index first = begin * group; first < std::min(end * group, nx); first += group)
      visit(first, std::min(group, nx - first), work);
  });
}

template <class Real>
void BasicPrunedTransform<Real>::forward_rows(const Field& in, std::span<Number> half, int threads,
                                              double scale) const {
  by_groups(threads, [&](Index first, Index count, typename Rows::Work& work) {
    rows_.forward(in.data() + first * field_.ny, field_.ny, field_.ny, count, half.data() + first * width,
                  rows_here() * width, work, scale);
  });
}

template <class Real>
void BasicPrunedTransform<Real>::forward_each_row(const RowSource& in, std::span<Number> half,
                                                  int threads) const {
  by_groups(threads, [&](Index first, Index count, typename Rows::Work& work) {
    AlignedVector<double> rows(size(count * field_.ny));
    for (Index r = 0; r < count; ++r) in(first + r, rows.data() + r * field_.ny);
    rows_.forward(rows.data(), field_.ny, field_.ny, count, half.data() + first * width, rows_here() * width,
                  work);
  });
}

template <class Real>
void BasicPrunedTransform<Real>::inverse_rows(std::span<const Number> half, Field& out, int threads,
                                              double scale) const {
  by_groups(threads, [&](Index first, Index count, typename Rows::Work& work) {
    rows_.inverse(half.data() + first * width, rows_here() * width, count, field_.ny,
                  out.data() + first * field_.ny, field_.ny, work, scale);
  });
}

template <class Real>
void BasicPrunedTransform<Real>::forward_block(std::span<const Number> half, Index b, Number* block,
                                               Number* work) const {
  columns_from_rows<width>(half.data() + b * field_.nx * width, field_.nx, work, stride());
  forward_columns(work, block);
}

template <class Real>
void BasicPrunedTransform<Real>::forward_columns(Number* columns, Number* block) const {
  for (Index c = 0; c < width; ++c)
    std::fill(columns + c * stride() + field_.nx, columns + c * stride() + torus_.nx, Number{});
  columns_.forward(columns, block);
}

template <class Real>
void BasicPrunedTransform<Real>::inverse_block(const Number* block, Index b, std::span<Number> half,
                                               Number* work) const {
  columns_.inverse(block, work);
  rows_from_columns<width>(work, stride(), field_.nx, half.data() + b * field_.nx * width);
}

namespace {

// A step of a pass over the blocks of all ranks: which of them each rank has, and where their rows lie.
template <class Number>
struct Step {
  const Slabs& slabs;
  std::span<Number> come;  // of this rank's blocks, rank by rank [block][row][8]
  Extent mine;

  std::span<Number> from(int rank) const {
    const Extent rows = slabs.of(rank);
    return come.subspan(size(mine.count * rows.first * width), size(mine.count * rows.count * width));
  }
  void to_columns(Index b, Number* columns, Index stride) const {
    for (int r = 0; r < slabs.ranks().count(); ++r) {
      const Extent rows = slabs.of(r);
      columns_from_rows<width>(from(r).data() + b * rows.count * width, rows.count, columns + rows.first,
                               stride);
    }
  }
  void from_columns(Index b, const Number* columns, Index stride) const {
    for (int r = 0; r < slabs.ranks().count(); ++r) {
      const Extent rows = slabs.of(r);
      rows_from_columns<width>(columns + rows.first, stride, rows.count,
                               from(r).data() + b * rows.count * width);
    }
  }
};

}  // namespace

template <class Real>
void BasicPrunedTransform<Real>::shared_pass(std::span<const Number> half,
                                             std::optional<std::span<Number>> back, int threads,
                                             const Visit& work, bool inverse) const {
  constexpr Index points_at_a_time = 1 << 17;  // of a column of blocks: some megabytes come and go
  const Ranks& ranks = slabs_.ranks();
  const Index most = std::max<Index>(1, points_at_a_time / torus_.nx), here = rows_here() * width;
  Index longest = 0;
  for (int r = 0; r < ranks.count(); ++r) longest = std::max(longest, blocks_of(r).count);
  HalfSpectrum come(size(most * field_.nx * width));
  for (Index done = 0; done < longest; done += most) {
    auto part_of = [&](int rank) -> Extent {
      const Extent blocks = blocks_of(rank);
      const Index before = std::min(done, blocks.count);
      return {blocks.first + before, std::min(most, blocks.count - before)};
    };
    const Step<Number> step{slabs_, come, part_of(ranks.rank())};
    Ranks::Pieces to, results;
    Ranks::Room from, into;
    for (int r = 0; r < ranks.count(); ++r) {
      const Extent theirs = part_of(r);
      const std::size_t begin = size(theirs.first * here), count = size(theirs.count * here);
      to.push_back(std::as_bytes(half.subspan(begin, count)));
      from.push_back(std::as_writable_bytes(step.from(r)));
      results.push_back(std::as_bytes(step.from(r)));
      if (back) into.push_back(std::as_writable_bytes(back->subspan(begin, count)));
    }
    ranks.exchange(to, from);
    parallel_ranges(step.mine.count, threads, [&](Index begin, Index end, int) {
      HalfSpectrum block(size(block_size())), scratch(block.size());
      for (Index b = begin; b < end; ++b) {
        step.to_columns(b, scratch.data(), stride());
        forward_columns(scratch.data(), block.data());
        work(step.mine.first + b, block.data());
        if (!back) continue;
        if (inverse) columns_.inverse(block.data(), scratch.data());
        step.from_columns(b, (inverse ? scratch : block).data(), stride());
      }
    });
    if (back) ranks.exchange(results, into);
  }
}

template class BasicPrunedTransform<double>;
template class BasicPrunedTransform<float>;

}  // namespace asperity
