#include "transform/rows.hpp"

#include <algorithm>

namespace asperity {
namespace {

constexpr Index width = RowTransform::width;

// (1) for the k of a block, from `first` on: the spectra of both rows.
void part(const Complex* z, Index n, Index first, Complex* block, bool second) {
  for (Index k = first; k < std::min(first + width, n / 2 + 1); ++k, ++block) {
    const Complex here = z[k], there = std::conj(z[k == 0 ? 0 : n - k]), twice = here - there;
    block[0] = 0.5 * (here + there);
    if (second) block[width] = {0.5 * twice.imag(), -0.5 * twice.real()};
  }
}

// z^ of two rows for the k of a block; without a second row, of the first.
void join(const Complex* block, Index first, Index n, Complex* z, bool second) {
  for (Index k = first; k < std::min(first + width, n / 2 + 1); ++k, ++block) {
    const Complex a = block[0], b = second ? block[width] : Complex{};
    z[k] = {a.real() - b.imag(), a.imag() + b.real()};
    if (k == 0 || 2 * k == n)
      z[k] = {a.real(), b.real()};
    else
      z[n - k] = {a.real() + b.imag(), b.real() - a.imag()};
  }
}

}  // namespace

RowTransform::Work RowTransform::work() const {
  const AlignedVector<Complex> columns(size(columns_.size()));
  return {columns, columns};
}

void RowTransform::forward(const double* in, Index apart, Index given, Index count, Complex* blocks,
                           Index block_stride, Work& work) const {
  const Index n = points(), stride = columns_.stride();
  for (Index r = 0; r < count; r += 2) {
    const double *a = in + r * apart, *b = a + apart;
    Complex* z = work.points.data() + r / 2 * stride;
    if (r + 1 < count)
      for (Index j = 0; j < given; ++j) z[j] = {a[j], b[j]};
    else
      std::copy_n(a, given, z);
    std::fill(z + given, z + n, Complex{});
  }
  columns_.forward(work.points.data(), work.modes.data());
  for (Index b = 0; b < this->blocks(); ++b)
    for (Index r = 0; r < count; r += 2)
      part(work.modes.data() + r / 2 * stride, n, b * width, blocks + b * block_stride + r * width,
           r + 1 < count);
  Complex* last = blocks + (this->blocks() - 1) * block_stride;
  for (Index r = 0; r < count; ++r)
    std::fill(last + r * width + (n / 2) % width + 1, last + (r + 1) * width, Complex{});
}

void RowTransform::inverse(const Complex* blocks, Index block_stride, Index count, Index wanted, double* out,
                           Index apart, Work& work) const {
  const Index n = points(), stride = columns_.stride();
  for (Index b = 0; b < this->blocks(); ++b)
    for (Index r = 0; r < count; r += 2)
      join(blocks + b * block_stride + r * width, b * width, n, work.modes.data() + r / 2 * stride,
           r + 1 < count);
  columns_.inverse(work.modes.data(), work.points.data());
  for (Index r = 0; r < count; r += 2) {
    const Complex* z = work.points.data() + r / 2 * stride;
    double *a = out + r * apart, *b = a + apart;
    for (Index j = 0; j < wanted; ++j) a[j] = z[j].real();
    if (r + 1 < count)
      for (Index j = 0; j < wanted; ++j) b[j] = z[j].imag();
  }
}

}  // namespace asperity
