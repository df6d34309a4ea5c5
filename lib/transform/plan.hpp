/// Discrete Fourier transforms: the plans, made once, and their execution.
///
/// The forward transform is X_k = Σ_j x_j exp(-2πi jk/n); no transform here is normalised: forward then
/// inverse multiplies by the number of points. All plans are estimated, so that results do not depend on the
/// load.
///
/// A plan may be executed by several threads at once on different data; transforms of the same size share
/// theirs, and the last few dozen are kept. Data must be aligned as AlignedVector aligns it.
///
/// Cost: about 5/2 N log2 N operations for N real points; a plan takes microseconds to a few milliseconds.
///
/// M. Frigo, S. G. Johnson, The design and implementation of FFTW3, Proc. IEEE 93 (2005) 216-231.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "core/field.hpp"

namespace asperity {

using Complex = std::complex<double>;

/// An allocator for SIMD: 64-byte aligned.
template <class T>
struct AlignedAllocator {
  using value_type = T;
  static constexpr std::align_val_t alignment{64};

  AlignedAllocator() = default;
  template <class U>
  AlignedAllocator(const AlignedAllocator<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), alignment)); }
  void deallocate(T* p, std::size_t) { ::operator delete(p, alignment); }
  bool operator==(const AlignedAllocator&) const = default;
};

template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

/// The least length ≥ n, a multiple of `multiple`, whose estimated plan is a good one: 2ᵃ 5ᵇ, b ≤ 2, from 768
/// on 3·2ᵃ 5ᵇ too. Other lengths without a prime factor above 5 take 1.5 to 3 times as long a point.
Index fast_length(Index n, Index multiple = 1);

/// The library of the transforms and its version.
std::string transform_version();

using Plan = std::shared_ptr<void>;  ///< FFTW's

enum class Ways { both, forward_only };

/// `width` columns of n complex points each, one after the other `stride` apart, out of place. Interleaved,
/// or in place, they would take twice as long; columns_from_rows separates them. Real: double or float.
template <class Real>
class BasicColumnTransform {
 public:
  using Number = std::complex<Real>;

  BasicColumnTransform(Index n, Index width, Ways ways = Ways::both);
  Index points() const { return n_; }
  Index width() const { return width_; }
  /// No power of two, for the cache.
  static constexpr Index stride_of(Index n) { return n + 64 / static_cast<Index>(sizeof(Number)); }
  Index stride() const { return stride_of(n_); }
  Index size() const { return width_ * stride(); }
  void forward(const Number* in, Number* out) const;
  void inverse(const Number* in, Number* out) const;

 private:
  Index n_, width_;
  Plan forward_, inverse_;
};
using ColumnTransform = BasicColumnTransform<double>;

/// `count` rows of `width` values to columns, `stride` apart, and back: neighbours in memory come one after
/// the other. Costs a tenth to a fifth of the columns' transform.
template <Index width, class Number>
void columns_from_rows(const Number* rows, Index count, Number* columns, Index stride) {
  for (Index i = 0; i < count; ++i)
    for (Index c = 0; c < width; ++c) columns[c * stride + i] = rows[i * width + c];
}

template <Index width, class Number>
void rows_from_columns(const Number* columns, Index stride, Index count, Number* rows) {
  for (Index i = 0; i < count; ++i)
    for (Index c = 0; c < width; ++c) rows[i * width + c] = columns[c * stride + i];
}

/// An nx × ny real field ↔ its nx × (ny/2+1) half spectrum; of 1 × n points the transform in one dimension.
class RealTransform2D {
 public:
  explicit RealTransform2D(Shape shape);
  Shape shape() const { return shape_; }
  Index spectrum_columns() const { return shape_.ny / 2 + 1; }
  Index spectrum_size() const { return shape_.nx * spectrum_columns(); }
  /// Leaves `in` unchanged.
  void forward(const double* in, Complex* out) const;
  /// Destroys `in`.
  void inverse(Complex* in, double* out) const;

 private:
  Shape shape_;
  Plan forward_, inverse_;
};

}  // namespace asperity
