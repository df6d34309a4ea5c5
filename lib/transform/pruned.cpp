#include "transform/pruned.hpp"

#include <algorithm>

#include "grid/parallel.hpp"
#include "transform/columns.hpp"

namespace asperity {
namespace {

std::size_t size(Index n) { return static_cast<std::size_t>(n); }

}  // namespace

PrunedTransform::PrunedTransform(Shape field, Shape torus)
    : field_(field), torus_(torus), rows_(torus.ny), columns_(torus.nx, width) {}

HalfSpectrum PrunedTransform::half_spectrum() const {
  return HalfSpectrum(size(blocks() * field_.nx * width));
}

// visit(first, count, row, spectra) for groups of neighbouring rows, whose parts of a block lie side by side.
template <class Visit>
void PrunedTransform::by_groups(int threads, Visit visit) const {
  constexpr Index group = 8;
  parallel_ranges((field_.nx + group - 1) / group, threads, [&](Index begin, Index end, int) {
    AlignedVector<double> row(size(torus_.ny + 2));
    AlignedVector<Complex> spectra(size(group * blocks() * width));
    for (Index first = begin * group; first < std::min(end * group, field_.nx); first += group)
      visit(first, std::min(group, field_.nx - first), row.data(), spectra.data());
  });
}

void PrunedTransform::forward_rows(const Field& in, HalfSpectrum& half, int threads) const {
  const Index stride = blocks() * width;
  by_groups(threads, [&](Index first, Index count, double* row, Complex* spectra) {
    std::fill(row + field_.ny, row + torus_.ny, 0.0);
    for (Index r = 0; r < count; ++r) {
      std::copy_n(in.data() + (first + r) * field_.ny, field_.ny, row);
      rows_.forward(row, spectra + r * stride);
    }
    for (Index b = 0; b < blocks(); ++b)
      for (Index r = 0; r < count; ++r)
        std::copy_n(spectra + r * stride + b * width, width,
                    half.data() + (b * field_.nx + first + r) * width);
  });
}

void PrunedTransform::inverse_row(const HalfSpectrum& half, Index i, Complex* spectrum, double* row,
                                  Index filled) const {
  for (Index b = 0; b < filled; ++b)
    std::copy_n(half.data() + (b * field_.nx + i) * width, width, spectrum + b * width);
  std::fill(spectrum + filled * width, spectrum + blocks() * width, Complex{});
  rows_.inverse(spectrum, row);
}

void PrunedTransform::inverse_rows(HalfSpectrum& half, Field& out, int threads) const {
  const Index stride = blocks() * width;
  by_groups(threads, [&](Index first, Index count, double* row, Complex* spectra) {
    for (Index b = 0; b < blocks(); ++b)
      for (Index r = 0; r < count; ++r)
        std::copy_n(half.data() + (b * field_.nx + first + r) * width, width,
                    spectra + r * stride + b * width);
    for (Index r = 0; r < count; ++r) {
      rows_.inverse(spectra + r * stride, row);
      std::copy_n(row, field_.ny, out.data() + (first + r) * field_.ny);
    }
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
