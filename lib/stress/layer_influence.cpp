#include "stress/layer_influence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stress/corner_tile.hpp"
#include "transform/columns.hpp"
#include "transform/mirrored.hpp"

namespace asperity {
namespace {

using stress::Component;

constexpr Index width = LayerInfluence::width;
constexpr double scale = 0.5 / std::numbers::pi;  // of the corner sum
static_assert(width == corner_lanes && width == MirroredTransform::width);

std::size_t size(Index n) { return static_cast<std::size_t>(n); }
Index blocks_of(Index n) { return (n + width - 1) / width; }
Parity parity(bool odd) { return odd ? Parity::odd : Parity::even; }

// x[i] ← x[i] - x[i-1], where x[-1] = x[0] for an odd kernel (even corner function) and -x[0] for an even
// one. The lag of half a period, which is its own negative, is 0 in an odd kernel.
void difference(Parity kernel, double* x, Index rows, Index period) {
  for (Index i = rows - 1; i > 0; --i)
    for (Index q = 0; q < width; ++q) x[i * width + q] -= x[(i - 1) * width + q];
  const double first = kernel == Parity::even ? 2 : 0;
  for (Index q = 0; q < width; ++q) x[q] *= first;
  if (kernel == Parity::odd && 2 * (rows - 1) == period) std::fill_n(x + (rows - 1) * width, width, 0.0);
}

// First along y, eight rows i at a time, as the corners are evaluated; along x when a block of columns is
// asked for.
class HalfSpaceInfluence : public LayerInfluence {
 public:
  HalfSpaceInfluence(const Grid& grid, Shape torus, double poisson)
      : grid_(grid),
        poisson_(poisson),
        along_x_(torus.nx),
        along_y_(torus.ny),
        blocks_(blocks_of(torus.ny / 2 + 1)),
        rows_(size(grid.shape.nx * width)),
        work_(size(std::max(along_x_.size(), along_y_.size()))),
        pairs_(work_.size()) {}

  void descend(double z, stress::Set asked) override {
    for (Component c : stress::components) {
      tile_[c].resize(asked[c] ? size(grid_.shape.ny * width) : 0);
      columns_[c].resize(asked[c] ? size(blocks_ * grid_.shape.nx * width) : 0);
    }
    for (Index i = 0; i < grid_.shape.nx; i += width) {
      evaluate_corners(i, z);
      for (Component c : stress::components)
        if (asked[c]) transform_along_y(c, i);
    }
  }

  Symbol symbol(Component c, Index b) override {
    const Index nx = grid_.shape.nx;
    std::copy_n(columns_[c].data() + b * nx * width, nx * width, rows_.data());
    difference(parity(odd_in_x(c)), rows_.data(), nx, along_x_.period());
    transform(along_x_, parity(odd_in_x(c)), rows_.data(), nx);
    return {pairs_.data(), along_x_.stride()};
  }

 private:
  void evaluate_corners(Index i, double z) {
    double* out[6];
    for (Component c : stress::components) out[c] = tile_[c].empty() ? nullptr : tile_[c].data();
    corner_tile(static_cast<double>(i) + 0.5, grid_.dy / grid_.dx, grid_.shape.ny, z / grid_.dx, poisson_,
                out);
  }

  void transform_along_y(Component c, Index first_row) {
    double* tile = tile_[c].data();
    difference(parity(odd_in_y(c)), tile, grid_.shape.ny, along_y_.period());
    transform(along_y_, parity(odd_in_y(c)), tile, grid_.shape.ny);
    const Index rows = std::min(width, grid_.shape.nx - first_row);
    for (Index b = 0; b < blocks_; ++b)
      for (Index l = 0; l < rows; ++l) {
        const auto* row =
            reinterpret_cast<const double*>(pairs_.data() + l / 2 * along_y_.stride() + b * width);
        double* column = columns_[c].data() + (b * grid_.shape.nx + first_row + l) * width;
        for (Index q = 0; q < width; ++q) column[q] = scale * row[2 * q + l % 2];
      }
  }

  // Eight interleaved sequences into pairs_.
  void transform(const MirroredTransform& along, Parity parity, const double* interleaved, Index given) {
    columns_from_rows<MirroredTransform::pairs>(reinterpret_cast<const Complex*>(interleaved), given,
                                                work_.data(), along.stride());
    along.apply(parity, work_.data(), given, pairs_.data());
  }

  Grid grid_;
  double poisson_;
  MirroredTransform along_x_, along_y_;
  Index blocks_;
  std::array<AlignedVector<double>, 6> tile_;     ///< eight rows: [j][8]
  std::array<AlignedVector<double>, 6> columns_;  ///< [block][i][8], transformed along y only
  AlignedVector<double> rows_;
  AlignedVector<Complex> work_, pairs_;
};

class PeriodicInfluence : public LayerInfluence {
 public:
  PeriodicInfluence(const Grid& grid, double poisson)
      : grid_(grid), poisson_(poisson), stride_(grid.shape.nx / 2 + 1), pairs_(size(stride_ * width / 2)) {}

  void descend(double z, stress::Set) override { z_ = z; }

  Symbol symbol(Component c, Index b) override {
    for (Index q = 0; q < width; q += 2)
      for (Index kx = 0; kx < stride_; ++kx)
        pairs_[size(q / 2 * stride_ + kx)] = {mode(c, kx, b * width + q), mode(c, kx, b * width + q + 1)};
    return {pairs_.data(), stride_};
  }

 private:
  double mode(Component c, Index kx, Index ky) const {
    if (kx == 0 && ky == 0) return mean(c);
    const bool nyquist_x = 2 * kx == grid_.shape.nx, nyquist_y = 2 * ky == grid_.shape.ny;
    if ((odd_in_x(c) && nyquist_x) || (odd_in_y(c) && nyquist_y)) return 0;
    const double qx = 2 * std::numbers::pi * static_cast<double>(kx) / grid_.size_x();
    const double qy = 2 * std::numbers::pi * static_cast<double>(ky) / grid_.size_y();
    const double q = std::hypot(qx, qy), e = std::exp(-q * z_), bend = ((1 - 2 * poisson_) / q - z_) / q;
    switch (c) {
      case stress::xx:
        return -(2 * poisson_ + qx * qx * bend) * e;
      case stress::yy:
        return -(2 * poisson_ + qy * qy * bend) * e;
      case stress::zz:
        return -(1 + q * z_) * e;
      case stress::xy:
        return qx * qy * bend * e;
      case stress::xz:
        return -qx * z_ * e;
      case stress::yz:
        return -qy * z_ * e;
    }
    return 0;
  }

  double mean(Component c) const {
    if (c == stress::zz) return -1;
    return c == stress::xx || c == stress::yy ? -poisson_ / (1 - poisson_) : 0;
  }

  Grid grid_;
  double poisson_, z_ = 0;
  Index stride_;
  AlignedVector<Complex> pairs_;
};

}  // namespace

std::unique_ptr<LayerInfluence> make_layer_influence(const Grid& grid, Shape torus, double poisson) {
  if (grid.periodic) return std::make_unique<PeriodicInfluence>(grid, poisson);
  return std::make_unique<HalfSpaceInfluence>(grid, torus, poisson);
}

}  // namespace asperity
