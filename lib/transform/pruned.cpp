#include "transform/pruned.hpp"

#include <algorithm>

#include "core/large_pages.hpp"

namespace asperity {

template <class Real>
BasicPrunedTransform<Real>::BasicPrunedTransform(Shape field, Shape torus, Ways ways)
    : field_(field), torus_(torus), rows_(torus.ny, ways), columns_(torus.nx, width, ways) {
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
template <class Visit>
void BasicPrunedTransform<Real>::by_groups(int threads, Visit visit) const {
  constexpr Index group = Rows::rows;
  parallel_ranges((field_.nx + group - 1) / group, threads, [&](Index begin, Index end, int) {
    typename Rows::Work work = row_work();
    for (Index first = begin * group; first < std::min(end * group, field_.nx); first += group)
      visit(first, std::min(group, field_.nx - first), work);
  });
}

template <class Real>
void BasicPrunedTransform<Real>::forward_rows(const Field& in, std::span<Number> half, int threads,
                                              double scale) const {
  by_groups(threads, [&](Index first, Index count, typename Rows::Work& work) {
    rows_.forward(in.data() + first * field_.ny, field_.ny, field_.ny, count, half.data() + first * width,
                  field_.nx * width, work, scale);
  });
}

template <class Real>
void BasicPrunedTransform<Real>::forward_each_row(const RowSource& in, std::span<Number> half,
                                                  int threads) const {
  by_groups(threads, [&](Index first, Index count, typename Rows::Work& work) {
    AlignedVector<double> rows(size(count * field_.ny));
    for (Index r = 0; r < count; ++r) in(first + r, rows.data() + r * field_.ny);
    rows_.forward(rows.data(), field_.ny, field_.ny, count, half.data() + first * width, field_.nx * width,
                  work);
  });
}

template <class Real>
void BasicPrunedTransform<Real>::inverse_rows(std::span<const Number> half, Field& out, int threads,
                                              double scale) const {
  by_groups(threads, [&](Index first, Index count, typename Rows::Work& work) {
    rows_.inverse(half.data() + first * width, field_.nx * width, count, field_.ny,
                  out.data() + first * field_.ny, field_.ny, work, scale);
  });
}

template <class Real>
void BasicPrunedTransform<Real>::forward_block(std::span<const Number> half, Index b, Number* block,
                                               Number* work) const {
  columns_from_rows<width>(half.data() + b * field_.nx * width, field_.nx, work, stride());
  for (Index c = 0; c < width; ++c)
    std::fill(work + c * stride() + field_.nx, work + c * stride() + torus_.nx, Number{});
  columns_.forward(work, block);
}

template <class Real>
void BasicPrunedTransform<Real>::inverse_block(const Number* block, Index b, std::span<Number> half,
                                               Number* work) const {
  columns_.inverse(block, work);
  rows_from_columns<width>(work, stride(), field_.nx, half.data() + b * field_.nx * width);
}

template class BasicPrunedTransform<double>;
template class BasicPrunedTransform<float>;

}  // namespace asperity
