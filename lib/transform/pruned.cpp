#include "transform/pruned.hpp"

#include <algorithm>

#include "core/memory.hpp"

namespace asperity {

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
  os::prefer_large_pages(out.data(), room * sizeof(Number));
  out.resize(room);
  return out;
}

// visit(first, count, work) for groups of neighbouring rows, whose parts of a block are neighbours in memory.
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

template <class Real>
void BasicPrunedTransform<Real>::shared_pass(const Shared& blocks, int threads, const Visit& work) const {
  BlockExchange<Number> exchange(slabs_, blocks.count, threads);
  const int ranks = slabs_.ranks().count();
  for (Index step = 0; step < exchange.steps(); ++step) {
    if (blocks.half) exchange.fetch(step, *blocks.half);
    const Extent own = exchange.at_hand(step);
    parallel_ranges(own.count, threads, [&](Index begin, Index end, int worker) {
      HalfSpectrum block(size(block_size())), scratch(block.size());
      for (Index b = begin; b < end; ++b) {
        auto rows = [&](int r) { return slabs_.of(r); };
        if (blocks.half) {
          for (int r = 0; r < ranks; ++r)
            columns_from_rows<width>(exchange.part(step, b, r).data(), rows(r).count,
                                     scratch.data() + rows(r).first, stride());
          forward_columns(scratch.data(), block.data());
        }
        work(own.first + b, block.data(), worker);
        if (!blocks.back) continue;
        columns_.inverse(block.data(), scratch.data());
        for (int r = 0; r < ranks; ++r)
          rows_from_columns<width>(scratch.data() + rows(r).first, stride(), rows(r).count,
                                   exchange.part(step, b, r).data());
      }
    });
    if (blocks.back) exchange.give_back(step, *blocks.back);
  }
}

template class BasicPrunedTransform<double>;
template class BasicPrunedTransform<float>;

}  // namespace asperity
