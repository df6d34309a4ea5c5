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

void PrunedTransform::forward_rows(const Field& in, HalfSpectrum& half, int threads) const {
  parallel_ranges(field_.nx, threads, [&](Index begin, Index end, int) {
    AlignedVector<double> row(size(torus_.ny));
    AlignedVector<Complex> spectrum(size(blocks() * width));
    for (Index i = begin; i < end; ++i) {
      std::copy_n(in.data() + i * field_.ny, field_.ny, row.data());
      rows_.forward(row.data(), spectrum.data());
      for (Index b = 0; b < blocks(); ++b)
        std::copy_n(spectrum.data() + b * width, width, half.data() + (b * field_.nx + i) * width);
    }
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
  parallel_ranges(field_.nx, threads, [&](Index begin, Index end, int) {
    AlignedVector<double> row(size(torus_.ny));
    AlignedVector<Complex> spectrum(size(blocks() * width));
    for (Index i = begin; i < end; ++i) {
      inverse_row(half, i, spectrum.data(), row.data());
      std::copy_n(row.data(), field_.ny, out.data() + i * field_.ny);
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
