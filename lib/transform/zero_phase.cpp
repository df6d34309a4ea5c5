#include "transform/zero_phase.hpp"

#include <algorithm>

namespace asperity {
namespace {

constexpr Index group_width = ZeroPhaseTransform::width;

// The real and the imaginary parts of two complex numbers, as two complex numbers: a 2 × 2 tile, transposed.
void turn(const Complex& a, const Complex& b, Complex& real, Complex& imaginary) {
  const Complex x = a, y = b;
  real = {x.real(), y.real()};
  imaginary = {x.imag(), y.imag()};
}

// ---- even in both indices ----

class QuarterTransform : public ZeroPhaseTransform {
 public:
  QuarterTransform(Shape lags, Shape torus)
      : ZeroPhaseTransform(lags, torus, false),
        rows_(torus.ny),
        columns_(torus.nx),
        row_blocks_((lags.nx + group_width - 1) / group_width),
        between_stride_(ColumnTransform::stride_of(row_blocks_ * group_width)),
        between_(size(blocks_ * pairs * between_stride_)),
        row_(size(rows_.size())),
        row_spectrum_(row_.size()) {}

 private:
  void load(const double* part) override {
    const auto [n, m] = lags_;
    for (Index first = 0; first < n; first += group_width) {
      for (Index c = 0; c < pairs; ++c) {
        const Index k = first + 2 * c;
        Complex* row = row_.data() + c * rows_.stride();
        for (Index l = 0; l < m; ++l)
          row[l] = {k < n ? part[k * m + l] : 0, k + 1 < n ? part[(k + 1) * m + l] : 0};
      }
      rows_.apply(Parity::even, row_.data(), m, row_spectrum_.data());
      for (Index b = 0; b < blocks_; ++b)
        for (Index c = 0; c < pairs; ++c)
          for (Index r = 0; r < pairs; ++r) {
            const Complex* in = row_spectrum_.data() + r * rows_.stride() + b * group_width + 2 * c;
            Complex* out = between(b, c) + first + 2 * r;
            turn(in[0], in[1], out[0], out[1]);
          }
    }
  }

  void forward_block(Index b) override {
    for (Index c = 0; c < pairs; ++c) std::copy_n(between(b, c), lags_.nx, work_.data() + c * stride_);
    columns_.apply(Parity::even, work_.data(), lags_.nx, block_.data());
  }

  void inverse_block(Index b) override {
    columns_.apply(Parity::even, block_.data(), torus_.nx / 2 + 1, work_.data());
    for (Index c = 0; c < pairs; ++c) std::copy_n(work_.data() + c * stride_, lags_.nx, between(b, c));
  }

  void store(double* part) override {
    const auto [n, m] = lags_;
    for (Index first = 0; first < n; first += group_width) {
      for (Index b = 0; b < blocks_; ++b)
        for (Index c = 0; c < pairs; ++c)
          for (Index r = 0; r < pairs; ++r) {
            const Complex* in = between(b, c) + first + 2 * r;
            Complex* out = row_.data() + r * rows_.stride() + b * group_width + 2 * c;
            turn(in[0], in[1], out[0], out[1]);
          }
      rows_.apply(Parity::even, row_.data(), torus_.ny / 2 + 1, row_spectrum_.data());
      for (Index k = first; k < std::min(first + group_width, n); ++k) {
        const auto* row =
            reinterpret_cast<const double*>(row_spectrum_.data() + (k - first) / 2 * rows_.stride());
        for (Index l = 0; l < m; ++l) part[k * m + l] = row[2 * l + k % 2];
      }
    }
  }

  // Where pair c of block b begins in between_.
  Complex* between(Index b, Index c) { return between_.data() + (b * pairs + c) * between_stride_; }

  MirroredTransform rows_, columns_;
  Index row_blocks_, between_stride_;
  AlignedVector<Complex> between_;             // [block][pair][k < n], transformed in y only
  AlignedVector<Complex> row_, row_spectrum_;  // eight rows: four pairs
};

// ---- even under point reflection ----

class HalfPlaneTransform : public ZeroPhaseTransform {
 public:
  HalfPlaneTransform(Shape lags, Shape torus)
      : ZeroPhaseTransform(lags, torus, true),
        rows_({1, torus.ny}),
        columns_(torus.nx, pairs),
        between_(size(blocks_ * lags.nx * group_width)),
        row_(size(torus.ny)),
        row_spectrum_(size(blocks_ * group_width)) {}

 private:
  void load(const double* part) override {
    const auto [n, m] = lags_;
    const Index period = torus_.ny;
    for (Index k = 0; k < n; ++k) {
      const double* positive = k == 0 ? part : part + m + (k - 1) * (2 * m - 1) + m - 1;  // at l = 0
      std::fill(row_.begin() + m, row_.end(), 0.0);
      std::copy_n(positive, m, row_.begin());
      for (Index l = 1; l < m; ++l) row_[size(period - l)] = k == 0 ? positive[l] : positive[-l];
      rows_.forward(row_.data(), row_spectrum_.data());
      std::fill(row_spectrum_.begin() + period / 2 + 1, row_spectrum_.end(), row_spectrum_[size(period / 2)]);
      for (Index b = 0; b < blocks_; ++b)
        std::copy_n(row_spectrum_.data() + b * group_width, group_width,
                    between_.data() + (b * n + k) * group_width);
    }
  }

  // Two Hermitian columns c, d are the halves of c + i d, whose transform has theirs as real and imaginary
  // part.
  void forward_block(Index b) override {
    const auto [n, period] = Shape{lags_.nx, torus_.nx};
    for (Index w = 0; w < pairs; ++w) {
      const Complex* in = between_.data() + b * n * group_width + 2 * w;
      Complex* column = work_.data() + w * stride_;
      std::fill(column + n, column + period - n + 1, Complex{});
      for (Index k = 0; k < n; ++k, in += group_width) {
        const Complex c = in[0], d = in[1];
        column[k] = {c.real() - d.imag(), c.imag() + d.real()};
        column[k == 0 ? 0 : period - k] = {c.real() + d.imag(), d.real() - c.imag()};
      }
    }
    columns_.forward(work_.data(), block_.data());
  }

  void inverse_block(Index b) override {
    columns_.inverse(block_.data(), work_.data());
    const auto [n, period] = Shape{lags_.nx, torus_.nx};
    for (Index w = 0; w < pairs; ++w) {
      const Complex* column = work_.data() + w * stride_;
      Complex* out = between_.data() + b * n * group_width + 2 * w;
      for (Index k = 0; k < n; ++k, out += group_width) {
        const Complex ahead = column[k], behind = column[k == 0 ? 0 : period - k];
        out[0] = {(ahead.real() + behind.real()) / 2, (ahead.imag() - behind.imag()) / 2};
        out[1] = {(ahead.imag() + behind.imag()) / 2, (behind.real() - ahead.real()) / 2};
      }
    }
  }

  void store(double* part) override {
    const auto [n, m] = lags_;
    const Index period = torus_.ny;
    for (Index k = 0; k < n; ++k) {
      for (Index b = 0; b < blocks_; ++b)
        std::copy_n(between_.data() + (b * n + k) * group_width, group_width,
                    row_spectrum_.data() + b * group_width);
      rows_.inverse(row_spectrum_.data(), row_.data());
      double* positive = k == 0 ? part : part + m + (k - 1) * (2 * m - 1) + m - 1;
      std::copy_n(row_.begin(), m, positive);
      if (k > 0)
        for (Index l = 1; l < m; ++l) positive[-l] = row_[size(period - l)];
    }
  }

  RealTransform2D rows_;
  ColumnTransform columns_;
  AlignedVector<Complex> between_;  // [block][k < n][8]
  AlignedVector<double> row_;
  AlignedVector<Complex> row_spectrum_;
};

}  // namespace

ZeroPhaseTransform::ZeroPhaseTransform(Shape lags, Shape torus, bool half_plane)
    : lags_(lags),
      torus_(torus),
      blocks_((torus.ny / 2 + group_width) / group_width),
      stride_(ColumnTransform::stride_of(torus.nx)),
      block_(size(pairs * stride_)),
      work_(block_.size()),
      half_plane_(half_plane),
      column_(half_plane ? torus.nx : torus.nx / 2 + 1) {}

std::vector<double> ZeroPhaseTransform::multiplicity() const {
  return part([&](Index k, Index l) {
    if (half_plane_) return k == 0 && l == 0 ? 1.0 : 2.0;
    return (k == 0 ? 1.0 : 2.0) * (l == 0 ? 1.0 : 2.0);
  });
}

std::vector<double> ZeroPhaseTransform::spectrum_multiplicity() const {
  auto times = [](Index k, Index period) {
    return 2 * k > period ? 0.0 : k == 0 || 2 * k == period ? 1.0 : 2.0;
  };
  std::vector<double> out(size(spectrum_size()));
  for (Index i = 0; i < spectrum_size(); ++i) {
    const Index column = i / pair_size() * 2 + i % 2, row = i % pair_size() / 2;
    out[size(i)] = times(column, torus_.ny) * (half_plane_ ? 1.0 : times(row, torus_.nx));
  }
  return out;
}

Field ZeroPhaseTransform::whole(std::span<const double> part) const {
  const auto [n, m] = lags_;
  return Field::NullaryExpr(2 * n - 1, 2 * m - 1, [&, n = n, m = m](Index row, Index column) {
    return part[size(place(row - n + 1, column - m + 1))];
  });
}

void ZeroPhaseTransform::forward(std::span<const double> part, std::span<double> spectrum) {
  load(part.data());
  for (Index b = 0; b < blocks_; ++b) {
    forward_block(b);
    for (Index c = 0; c < pairs; ++c)
      std::copy_n(pair(c).begin(), pair_size(), spectrum.data() + b * block_size() + c * pair_size());
  }
}

void ZeroPhaseTransform::inverse(std::span<const double> spectrum, std::span<double> part) {
  for (Index b = 0; b < blocks_; ++b) {
    for (Index c = 0; c < pairs; ++c)
      std::copy_n(spectrum.data() + b * block_size() + c * pair_size(), pair_size(), pair(c).begin());
    inverse_block(b);
  }
  const double scale = 1 / static_cast<double>(torus_.cells());
  store(part.data());
  for (double& a : part) a *= scale;
}

void ZeroPhaseTransform::autocorrelate(std::span<const double> part, std::span<double> out) {
  const double scale = 1 / static_cast<double>(torus_.cells());
  filter(part, out, [scale](Index, std::span<double> block) {
    for (double& a : block) a *= scale * a;
  });
}

std::unique_ptr<ZeroPhaseTransform> zero_phase_transform(Shape lags, Shape least, bool oriented) {
  auto side = [](Index n, Index points) { return fast_length(std::max({points, 2 * n, group_width}), 2); };
  const Shape torus{side(lags.nx, least.nx), side(lags.ny, least.ny)};
  if (oriented) return std::make_unique<HalfPlaneTransform>(lags, torus);
  return std::make_unique<QuarterTransform>(lags, torus);
}

}  // namespace asperity
