#include "transform/rows.hpp"

#include <algorithm>

namespace asperity {
namespace {

// (1): the spectra of both rows, as far as k = n/2.
void part(const Complex* z, Index n, Complex* blocks, Index block_stride, bool second) {
  constexpr Index width = RowTransform::width;
  for (Index k = 0; k <= n / 2; ++k) {
    const Complex here = z[k], there = std::conj(z[k == 0 ? 0 : n - k]);
    Complex* out = blocks + k / width * block_stride + k % width;
    *out = 0.5 * (here + there);
    const Complex twice = here - there;
    if (second) out[width] = {0.5 * twice.imag(), -0.5 * twice.real()};
  }
}

// z^ of two rows; of the second alone, zeros.
void join(const Complex* blocks, Index block_stride, Index n, Complex* z, bool second) {
  constexpr Index width = RowTransform::width;
  for (Index k = 0; k <= n / 2; ++k) {
    const Complex* in = blocks + k / width * block_stride + k % width;
    const Complex a = in[0], b = second ? in[width] : Complex{};
    z[k] = {a.real() - b.imag(), a.imag() + b.real()};
    if (k == 0 || 2 * k == n)
      z[k] = {a.real(), b.real()};
    else
      z[n - k] = {a.real() + b.imag(), b.real() - a.imag()};
  }
}

}  // namespace

RowTransform::Work RowTransform::work() const {
  const auto size = static_cast<std::size_t>(columns_.size());
  return {AlignedVector<Complex>(size), AlignedVector<Complex>(size)};
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
  for (Index r = 0; r < count; r += 2)
    part(work.modes.data() + r / 2 * stride, n, blocks + r * width, block_stride, r + 1 < count);
  Complex* last = blocks + (this->blocks() - 1) * block_stride;
  for (Index r = 0; r < count; ++r)
    std::fill(last + r * width + (n / 2) % width + 1, last + (r + 1) * width, Complex{});
}

void RowTransform::inverse(const Complex* blocks, Index block_stride, Index count, Index wanted, double* out,
                           Index apart, Work& work) const {
  const Index n = points(), stride = columns_.stride();
  for (Index r = 0; r < count; r += 2)
    join(blocks + r * width, block_stride, n, work.modes.data() + r / 2 * stride, r + 1 < count);
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
