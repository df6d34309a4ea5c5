#include "transform/pruned.hpp"

#include <algorithm>

#include "core/large_pages.hpp"

namespace asperity {

PrunedTransform::PrunedTransform(Shape field, Shape torus, ColumnTransform::Ways ways)
    : field_(field), torus_(torus), rows_(torus.ny, ways), columns_(torus.nx, width, ways) {
  static_assert(width == RowTransform::width);
}

HalfSpectrum PrunedTransform::half_spectrum() const {
  const std::size_t room = size(blocks() * field_.nx * width);
  HalfSpectrum out;
  out.reserve(room);
  prefer_large_pages(out.data(), room * sizeof(Complex));
  out.resize(room);
  return out;
}

// visit(first, count, work) for groups of neighbouring rows, whose parts of a block lie side by side.
template <class Visit>
void PrunedTransform::by_groups(int threads, Visit visit) const {
  constexpr Index group = RowTransform::rows;
  parallel_ranges((field_.nx + group - 1) / group, threads, [&](Index begin, Index end, int) {
    RowTransform::Work work = row_work();
    for (Index first = begin * group; first < std::min(end * group, field_.nx); first += group)
      visit(first, std::min(group, field_.nx - first), work);
  });
}

void PrunedTransform::forward_rows(const Field& in, HalfSpectrum& half, int threads) const {
  by_groups(threads, [&](Index first, Index count, RowTransform::Work& work) {
    rows_.forward(in.data() + first * field_.ny, field_.ny, field_.ny, count, half.data() + first * width,
                  field_.nx * width, work);
  });
}

void PrunedTransform::forward_each_row(const RowSource& in, HalfSpectrum& half, int threads) const {
  by_groups(threads, [&](Index first, Index count, RowTransform::Work& work) {
    AlignedVector<double> rows(size(count * field_.ny));
    for (Index r = 0; r < count; ++r) in(first + r, rows.data() + r * field_.ny);
    rows_.forward(rows.data(), field_.ny, field_.ny, count, half.data() + first * width, field_.nx * width,
                  work);
  });
}

void PrunedTransform::inverse_rows(const HalfSpectrum& half, Field& out, int threads) const {
  by_groups(threads, [&](Index first, Index count, RowTransform::Work& work) {
    inverse_group(half, first, count, field_.ny, out.data() + first * field_.ny, field_.ny, work);
  });
}

void PrunedTransform::forward_block(const HalfSpectrum& half, Index b, Complex* block, Complex* work) const {
  columns_from_rows<width>(half.data() + b * field_.nx * width, field_.nx, work, stride());
  for (Index c = 0; c < width; ++c)
    std::fill(work + c * stride() + field_.nx, work + c * stride() + torus_.nx, Complex{});
  columns_.forward(work, block);
}

void PrunedTransform::inverse_block(const Complex* block, Index b, HalfSpectrum& half, Complex* work) const {
  columns_.inverse(block, work);
  rows_from_columns<width>(work, stride(), field_.nx, half.data() + b * field_.nx * width);
}

}  // namespace asperity
