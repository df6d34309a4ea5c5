#include "transform/zero_phase.hpp"

#include <algorithm>

namespace asperity {
namespace {

constexpr Index width = ZeroPhaseTransform::width;

std::size_t size(Index n) { return static_cast<std::size_t>(n); }

// An 8 × 8 tile, transposed; rows `from` and `to` apart.
void transpose(const double* in, Index from, double* out, Index to) {
  for (Index i = 0; i < width; ++i)
    for (Index j = 0; j < width; ++j) out[j * to + i] = in[i * from + j];
}

}  // namespace

ZeroPhaseTransform::ZeroPhaseTransform(Shape lags, Shape torus, bool half_plane)
    : lags_(lags),
      torus_(torus),
      blocks_((torus.ny / 2 + width) / width),
      block_rows_(half_plane ? torus.nx : torus.nx / 2 + 1),
      half_plane_(half_plane),
      block_(size(torus.nx * width)) {}

std::vector<double> ZeroPhaseTransform::multiplicity() const {
  return part([&](Index k, Index l) {
    if (half_plane_) return k == 0 && l == 0 ? 1.0 : 2.0;
    return (k == 0 ? 1.0 : 2.0) * (l == 0 ? 1.0 : 2.0);
  });
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
    forward_block(b, block_.data());
    std::copy_n(block_.data(), block_size(), spectrum.data() + b * block_size());
  }
}

void ZeroPhaseTransform::inverse(std::span<const double> spectrum, std::span<double> part) {
  for (Index b = 0; b < blocks_; ++b) {
    std::copy_n(spectrum.data() + b * block_size(), block_size(), block_.data());
    inverse_block(b, block_.data());
  }
  const double scale = 1 / static_cast<double>(torus_.cells());
  store(part.data());
  for (double& a : part) a *= scale;
}

std::unique_ptr<ZeroPhaseTransform> zero_phase_transform(Shape lags, Shape least, bool oriented) {
  auto side = [](Index n, Index points) { return fast_length(std::max({points, 2 * n, width}), 2); };
  const Shape torus{side(lags.nx, least.nx), side(lags.ny, least.ny)};
  if (oriented) return std::make_unique<HalfPlaneTransform>(lags, torus);
  return std::make_unique<QuarterTransform>(lags, torus);
}

// ---- even in both indices ----

QuarterTransform::QuarterTransform(Shape lags, Shape torus)
    : ZeroPhaseTransform(lags, torus, false),
      rows_(torus.ny),
      columns_(torus.nx),
      row_blocks_((lags.nx + width - 1) / width),
      between_(size(blocks_ * row_blocks_ * width * width)),
      row_(size(torus.ny * width)) {}

void QuarterTransform::load(const double* part) {
  const auto [n, m] = lags_;
  const Index block_stride = row_blocks_ * width * width;
  for (Index r = 0; r < row_blocks_; ++r) {
    const Index rows = std::min(width, n - r * width);
    std::fill_n(row_.data(), m * width, 0.0);
    for (Index i = 0; i < rows; ++i)
      for (Index l = 0; l < m; ++l) row_[size(l * width + i)] = part[(r * width + i) * m + l];
    rows_.apply(Parity::even, row_.data(), m);
    for (Index b = 0; b < blocks_; ++b)
      transpose(row_.data() + b * width * width, width,
                between_.data() + b * block_stride + r * width * width, width);
  }
}

void QuarterTransform::forward_block(Index b, double* block) {
  std::copy_n(between_.data() + b * row_blocks_ * width * width, lags_.nx * width, block);
  columns_.apply(Parity::even, block, lags_.nx);
}

void QuarterTransform::inverse_block(Index b, double* block) {
  columns_.apply(Parity::even, block, torus_.nx / 2 + 1);
  std::copy_n(block, lags_.nx * width, between_.data() + b * row_blocks_ * width * width);
}

void QuarterTransform::store(double* part) {
  const auto [n, m] = lags_;
  const Index block_stride = row_blocks_ * width * width, columns = torus_.ny / 2 + 1;
  for (Index r = 0; r < row_blocks_; ++r) {
    for (Index b = 0; b < blocks_; ++b)
      transpose(between_.data() + b * block_stride + r * width * width, width,
                row_.data() + b * width * width, width);
    rows_.apply(Parity::even, row_.data(), columns);
    const Index rows = std::min(width, n - r * width);
    for (Index i = 0; i < rows; ++i)
      for (Index l = 0; l < m; ++l) part[(r * width + i) * m + l] = row_[size(l * width + i)];
  }
}

// ---- even under point reflection ----

HalfPlaneTransform::HalfPlaneTransform(Shape lags, Shape torus)
    : ZeroPhaseTransform(lags, torus, true),
      rows_(torus.ny),
      columns_(torus.nx, width / 2),
      between_(size(blocks_ * lags.nx * width)),
      row_(size(torus.ny)),
      row_spectrum_(size(blocks_ * width)) {}

void HalfPlaneTransform::load(const double* part) {
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
      std::copy_n(row_spectrum_.data() + b * width, width, between_.data() + (b * n + k) * width);
  }
}

// Two Hermitian columns c, d are the halves of c + i d, whose transform has theirs as real and imaginary
// part.
void HalfPlaneTransform::forward_block(Index b, double* block) {
  const auto [n, period] = Shape{lags_.nx, torus_.nx};
  std::fill_n(block, period * width, 0.0);
  const Complex* in = between_.data() + b * n * width;
  for (Index k = 0; k < n; ++k, in += width)
    for (Index w = 0; w < width; w += 2) {
      const Complex c = in[w], d = in[w + 1];
      double* ahead = block + k * width + w;
      double* behind = block + (k == 0 ? 0 : period - k) * width + w;
      ahead[0] = c.real() - d.imag(), ahead[1] = c.imag() + d.real();
      behind[0] = c.real() + d.imag(), behind[1] = d.real() - c.imag();
    }
  columns_.forward(reinterpret_cast<Complex*>(block));
}

void HalfPlaneTransform::inverse_block(Index b, double* block) {
  columns_.inverse(reinterpret_cast<Complex*>(block));
  const auto [n, period] = Shape{lags_.nx, torus_.nx};
  Complex* out = between_.data() + b * n * width;
  for (Index k = 0; k < n; ++k, out += width)
    for (Index w = 0; w < width; w += 2) {
      const double* ahead = block + k * width + w;
      const double* behind = block + (k == 0 ? 0 : period - k) * width + w;
      out[w] = {(ahead[0] + behind[0]) / 2, (ahead[1] - behind[1]) / 2};
      out[w + 1] = {(ahead[1] + behind[1]) / 2, (behind[0] - ahead[0]) / 2};
    }
}

void HalfPlaneTransform::store(double* part) {
  const auto [n, m] = lags_;
  const Index period = torus_.ny;
  for (Index k = 0; k < n; ++k) {
    for (Index b = 0; b < blocks_; ++b)
      std::copy_n(between_.data() + (b * n + k) * width, width, row_spectrum_.data() + b * width);
    rows_.inverse(row_spectrum_.data(), row_.data());
    double* positive = k == 0 ? part : part + m + (k - 1) * (2 * m - 1) + m - 1;
    std::copy_n(row_.begin(), m, positive);
    if (k > 0)
      for (Index l = 1; l < m; ++l) positive[-l] = row_[size(period - l)];
  }
}

}  // namespace asperity
