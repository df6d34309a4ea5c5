/// Real spectra: the transforms of fields that are even under point reflection, a(-k,-l) = a(k,l).
///
/// Such a field has a real spectrum; a kernel of this kind shifts no phase. Two kinds are given by a part of
/// them and live on a torus of Px × Py points, zero beyond |k| < n, |l| < m:
///     a quarter     even in both indices: n × m values, k, l ≥ 0,
///     a half plane  even under point reflection: l = 0 … m-1 of row 0, then l = -(m-1) … m-1 of the others.
/// Rows that hold data are transformed in y; then columns in x, in blocks of eight that stay in the cache
/// while they are transformed, worked on and transformed back to the n × m part. Two real (or Hermitian)
/// sequences are one complex one, and come apart without arithmetic, or with one addition.
///
/// A spectrum is [block][pair][kx][2] doubles: column 8·block + 2·pair + 0 or 1, kx = 0 … Px/2 of a quarter,
/// 0 … Px-1 of a half plane. Columns beyond the last, Py/2, repeat others: minima and maxima are over all of
/// it.
///
/// Cost      there and back 0.11 to 0.2 (a quarter), 0.12 to 0.33 (a half plane) of a real transform of the
///           torus, for 31 to 255 lags. Memory: n Py doubles between rows and columns, 16 Px for a block.
/// Accuracy  ε log2(Px Py) Σ|a|.
#pragma once

#include <cstdlib>
#include <memory>
#include <span>
#include <vector>

#include "core/field.hpp"
#include "transform/mirrored.hpp"
#include "transform/plan.hpp"

namespace asperity {

class ZeroPhaseTransform {
 public:
  static constexpr Index width = MirroredTransform::width, pairs = MirroredTransform::pairs;

  virtual ~ZeroPhaseTransform() = default;
  Shape lags() const { return lags_; }    ///< n × m
  Shape torus() const { return torus_; }  ///< Px × Py
  Index blocks() const { return blocks_; }
  Index pair_size() const { return 2 * column_; }
  Index block_size() const { return pairs * pair_size(); }
  Index spectrum_size() const { return blocks() * block_size(); }

  /// How often each value of the given part occurs on the torus: 1, 2 or 4.
  std::vector<double> multiplicity() const;
  /// How often each value of the spectrum occurs on the torus: 0 in a column that repeats another.
  std::vector<double> spectrum_multiplicity() const;
  /// Where the value at (k, l), |k| < n, |l| < m, stands in the part.
  Index place(Index k, Index l) const;
  /// All (2n-1) × (2m-1) values.
  Field whole(std::span<const double> part) const;
  /// The part of a function of the lag (k, l).
  template <class Function>
  std::vector<double> part(Function f) const;
  /// The same, row by row: row(k, l, values) at l, l + 1, …
  template <class Row>
  std::vector<double> rows_of_part(Row row) const;

  /// Not for two threads at once on one object: it owns the work space.
  void forward(std::span<const double> part, std::span<double> spectrum);
  /// The part of the inverse transform; `spectrum` is left alone.
  void inverse(std::span<const double> spectrum, std::span<double> part);
  /// part → spectrum → work(offset, values) on each pair of columns, values[i] being the spectrum's at
  /// offset + i → `out`, which may be `part`.
  template <class Work>
  void filter(std::span<const double> part, std::span<double> out, Work work);
  /// The autocorrelation of a part on the torus, whose spectrum is the square of the part's. `out` may be
  /// `part`.
  void autocorrelate(std::span<const double> part, std::span<double> out);

 protected:
  ZeroPhaseTransform(Shape lags, Shape torus, bool half_plane);

  virtual void load(const double* part) = 0;  ///< rows, transformed in y
  virtual void forward_block(Index b) = 0;    ///< columns in x, into block_
  virtual void inverse_block(Index b) = 0;    ///< out of block_, which it may spoil
  virtual void store(double* part) = 0;

  Shape lags_, torus_;
  Index blocks_, stride_;
  AlignedVector<Complex> block_, work_;  ///< four columns, stride_ apart: pairs of real ones

 private:
  Index first(Index k) const { return half_plane_ && k > 0 ? 1 - lags_.ny : 0; }  ///< the least l of row k

  std::span<double> pair(Index c) {
    return {reinterpret_cast<double*>(block_.data() + c * stride_), size(pair_size())};
  }

  bool half_plane_;
  Index column_;  ///< points of a column that make the spectrum
};

/// For a half plane if `oriented`, otherwise for a quarter, on the smallest fast torus that holds the field
/// and has at least this many points.
std::unique_ptr<ZeroPhaseTransform> zero_phase_transform(Shape lags, Shape least, bool oriented);

inline Index ZeroPhaseTransform::place(Index k, Index l) const {
  const Index m = lags_.ny;
  if (!half_plane_) return std::abs(k) * m + std::abs(l);
  if (k < 0 || (k == 0 && l < 0)) return place(-k, -l);
  return k * (2 * m - 1) + l;
}

template <class Row>
std::vector<double> ZeroPhaseTransform::rows_of_part(Row row) const {
  std::vector<double> out(size(place(lags_.nx - 1, lags_.ny - 1) + 1));
  for (Index k = 0; k < lags_.nx; ++k) {
    const auto from = size(place(k, first(k)));
    row(k, first(k), std::span(out).subspan(from, size(lags_.ny - first(k))));
  }
  return out;
}

template <class Function>
std::vector<double> ZeroPhaseTransform::part(Function f) const {
  return rows_of_part([&](Index k, Index l, std::span<double> values) {
    for (double& value : values) value = f(k, l++);
  });
}

template <class Work>
void ZeroPhaseTransform::filter(std::span<const double> part, std::span<double> out, Work work) {
  load(part.data());
  for (Index b = 0; b < blocks_; ++b) {
    forward_block(b);
    for (Index c = 0; c < pairs; ++c) work(b * block_size() + c * pair_size(), pair(c));
    inverse_block(b);
  }
  store(out.data());
}

}  // namespace asperity
