#include "transform/rows.hpp"

#include <algorithm>

namespace asperity {
namespace {

constexpr Index row_group = RowTransform::width;

// (1) for the k of a block, from `first` on: the spectra of both rows.
template <class Number>
void part(const Number* z, Index n, Index first, Number* block, bool second) {
  using Real = typename Number::value_type;
  constexpr Real half = 0.5;
  for (Index k = first; k < std::min(first + row_group, n / 2 + 1); ++k, ++block) {
    const Number here = z[k], there = std::conj(z[k == 0 ? 0 : n - k]), twice = here - there;
    block[0] = half * (here + there);
    if (second) block[row_group] = {half * twice.imag(), -half * twice.real()};
  }
}

// z^ of two rows for the k of a block; without a second row, of the first.
template <class Number>
void join(const Number* block, Index first, Index n, Number* z, bool second) {
  for (Index k = first; k < std::min(first + row_group, n / 2 + 1); ++k, ++block) {
    const Number a = block[0], b = second ? block[row_group] : Number{};
    z[k] = {a.real() - b.imag(), a.imag() + b.real()};
    if (k == 0 || 2 * k == n)
      z[k] = {a.real(), b.real()};
    else
      z[n - k] = {a.real() + b.imag(), b.real() - a.imag()};
  }
}

}  // namespace

template <class Real>
auto BasicRowTransform<Real>::work() const -> Work {
  const AlignedVector<Number> columns(size(columns_.size()));
  return {columns, columns};
}

template <class Real>
void BasicRowTransform<Real>::forward(const double* in, Index apart, Index given, Index count, Number* blocks,
                                      Index block_stride, Work& work, double scale) const {
  auto real = [scale](double x) { return static_cast<Real>(scale * x); };
  const Index n = points(), stride = columns_.stride();
  for (Index r = 0; r < count; r += 2) {
    const double *a = in + r * apart, *b = a + apart;
    Number* z = work.points.data() + r / 2 * stride;
    if (r + 1 < count)
      for (Index j = 0; j < given; ++j) z[j] = {real(a[j]), real(b[j])};
    else
      for (Index j = 0; j < given; ++j) z[j] = real(a[j]);
    std::fill(z + given, z + n, Number{});
  }
  columns_.forward(work.points.data(), work.modes.data());
  for (Index b = 0; b < this->blocks(); ++b)
    for (Index r = 0; r < count; r += 2)
      part(work.modes.data() + r / 2 * stride, n, b * row_group, blocks + b * block_stride + r * row_group,
           r + 1 < count);
  Number* last = blocks + (this->blocks() - 1) * block_stride;
  for (Index r = 0; r < count; ++r)
    std::fill(last + r * row_group + (n / 2) % row_group + 1, last + (r + 1) * row_group, Number{});
}

template <class Real>
void BasicRowTransform<Real>::inverse(const Number* blocks, Index block_stride, Index count, Index wanted,
                                      double* out, Index apart, Work& work, double scale) const {
  const Index n = points(), stride = columns_.stride();
  for (Index b = 0; b < this->blocks(); ++b)
    for (Index r = 0; r < count; r += 2)
      join(blocks + b * block_stride + r * row_group, b * row_group, n, work.modes.data() + r / 2 * stride,
           r + 1 < count);
  columns_.inverse(work.modes.data(), work.points.data());
  for (Index r = 0; r < count; r += 2) {
    const Number* z = work.points.data() + r / 2 * stride;
    double *a = out + r * apart, *b = a + apart;
    for (Index j = 0; j < wanted; ++j) a[j] = scale * double{z[j].real()};
    if (r + 1 < count)
      for (Index j = 0; j < wanted; ++j) b[j] = scale * double{z[j].imag()};
  }
}

template class BasicRowTransform<double>;
template class BasicRowTransform<float>;

}  // namespace asperity
