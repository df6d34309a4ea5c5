#include "stress/layer_influence.hpp"

#include <algorithm>
#include <numbers>

#include "stress/corner_tile.hpp"
#include "stress/images.hpp"
#include "stress/wave.hpp"
#include "transform/mirrored.hpp"

namespace asperity {
namespace {

using stress::Component;
using stress::Traction;

constexpr Index width = LayerInfluence::width;
constexpr double scale = 0.5 / std::numbers::pi;  // of the corner sum
static_assert(width == corner_lanes && width == MirroredTransform::width);

Parity parity(bool odd) { return odd ? Parity::odd : Parity::even; }

// x[i] ← taper[i] (x[i] - x[i-1]), where x[-1] = x[0] for an odd kernel (even corner function) and -x[0] for
// an even one. The lag of half a period, which is its own negative, is 0 in an odd kernel.
void difference(Parity kernel, double* x, const std::vector<double>& taper, Index period) {
  const auto rows = static_cast<Index>(taper.size());
  for (Index i = rows - 1; i > 0; --i)
    for (Index q = 0; q < width; ++q)
      x[i * width + q] = taper[size(i)] * (x[i * width + q] - x[(i - 1) * width + q]);
  const double first = kernel == Parity::even ? 2 : 0;
  for (Index q = 0; q < width; ++q) x[q] *= first;
  if (kernel == Parity::odd && 2 * (rows - 1) == period) std::fill_n(x + (rows - 1) * width, width, 0.0);
}

// First along y, eight rows i at a time, as the corners come; along x when a block is requested.
class HalfSpaceInfluence : public LayerInfluence {
 public:
  HalfSpaceInfluence(const Resolution& r, double poisson, stress::Tractions acting)
      : grid_(r.cells),
        taper_(r.taper),
        poisson_(poisson),
        acting_(acting),
        along_x_(r.transform.torus().nx),
        along_y_(r.transform.torus().ny),
        blocks_(r.transform.blocks()),
        rows_(size(grid_.shape.nx * width)),
        work_(size(std::max(along_x_.size(), along_y_.size()))),
        along_y_pairs_(size(along_y_.size() + width)) {  // the last block of few columns is read whole
    for (Traction t : stress::tractions)
      if (acting[t]) transfer_[t].resize(size(along_x_.size()));
  }

  void set_depth(double z, stress::Set asked, Index lags) override {
    for (Traction t : stress::tractions)
      for (Component c : stress::components) {
        const Index needed = acting_[t] && asked[c] ? width : 0;
        kernels_[t][c].tile.resize(size(needed * grid_.shape.ny));
        kernels_[t][c].columns.resize(size(needed * blocks_ * grid_.shape.nx));
      }
    const Index rows = lags == all_lags ? grid_.shape.nx : lags;
    for (Index i = 0; i < rows; i += width) {
      evaluate_corners(i, z);
      for (Traction t : stress::tractions)
        for (Component c : stress::components)
          if (acting_[t] && asked[c]) transform_along_y(t, c, i);
    }
  }

  TransferFunction transfer_function(Traction t, Component c, Index b) override {
    const Index nx = grid_.shape.nx;
    const Parity along = parity(odd_in_x(c, t));
    std::ranges::copy(by_lags(t, c, b), rows_.begin());
    difference(along, rows_.data(), taper_[0], along_x_.period());
    transform(along_x_, along, rows_.data(), nx, transfer_[t].data());
    return {transfer_[t], along_x_.stride()};
  }

  std::span<const double> by_lags(Traction t, Component c, Index b) override {
    const Index count = grid_.shape.nx * width;
    return std::span(kernels_[t][c].columns).subspan(size(b * count), size(count));
  }

 private:
  struct Kernel {
    AlignedVector<double> tile;     ///< eight rows: [j][8]
    AlignedVector<double> columns;  ///< [block][i][8], transformed along y only
  };

  void evaluate_corners(Index i, double z) {
    double* out[3][6];
    for (Traction t : stress::tractions)
      for (Component c : stress::components)
        out[t][c] = kernels_[t][c].tile.empty() ? nullptr : kernels_[t][c].tile.data();
    corner_tile(static_cast<double>(i) + 0.5, grid_.dy / grid_.dx, grid_.shape.ny, z / grid_.dx, poisson_,
                out);
  }

  void transform_along_y(Traction t, Component c, Index first_row) {
    double* tile = kernels_[t][c].tile.data();
    const Parity along = parity(odd_in_y(c, t));
    difference(along, tile, taper_[1], along_y_.period());
    transform(along_y_, along, tile, grid_.shape.ny, along_y_pairs_.data());
    const Index rows = std::min(width, grid_.shape.nx - first_row);
    for (Index b = 0; b < blocks_; ++b)
      for (Index l = 0; l < rows; ++l) {
        const auto* row =
            reinterpret_cast<const double*>(along_y_pairs_.data() + l / 2 * along_y_.stride() + b * width);
        double* column = kernels_[t][c].columns.data() + (b * grid_.shape.nx + first_row + l) * width;
        for (Index q = 0; q < width; ++q) column[q] = scale * row[2 * q + l % 2];
      }
  }

  // Eight interleaved sequences, transformed, by pairs.
  void transform(const MirroredTransform& along, Parity parity, const double* interleaved, Index given,
                 Complex* pairs) {
    columns_from_rows<MirroredTransform::pairs>(reinterpret_cast<const Complex*>(interleaved), given,
                                                work_.data(), along.stride());
    along.apply(parity, work_.data(), given, pairs);
  }

  Grid grid_;
  std::array<std::vector<double>, 2> taper_;
  double poisson_;
  stress::Tractions acting_;
  MirroredTransform along_x_, along_y_;
  Index blocks_;
  std::array<std::array<Kernel, 6>, 3> kernels_;  ///< [traction][component]
  AlignedVector<double> rows_;
  AlignedVector<Complex> work_, along_y_pairs_;
  std::array<AlignedVector<Complex>, 3> transfer_;  ///< of the block last requested, by traction
};

class PeriodicInfluence : public LayerInfluence {
 public:
  PeriodicInfluence(const Grid& grid, double poisson, stress::Tractions acting)
      : grid_(grid), poisson_(poisson), stride_(grid.shape.nx / 2 + 1) {
    for (Traction t : stress::tractions)
      if (acting[t]) transfer_[t].resize(size(stride_ * width / 2));
  }

  void set_depth(double z, stress::Set, Index) override { z_ = z; }

  TransferFunction transfer_function(Traction t, Component c, Index b) override {
    for (Index q = 0; q < width; q += 2)
      for (Index kx = 0; kx < stride_; ++kx)
        transfer_[t][size(q / 2 * stride_ + kx)] = {mode(t, c, kx, b * width + q),
                                                    mode(t, c, kx, b * width + q + 1)};
    return {transfer_[t], stride_};
  }

  std::span<const double> by_lags(Traction t, Component c, Index b) override {
    modes_.resize(size(stride_ * width));
    for (Index kx = 0; kx < stride_; ++kx)
      for (Index q = 0; q < width; ++q) modes_[size(kx * width + q)] = mode(t, c, kx, b * width + q);
    return modes_;
  }

 private:
  double mode(Traction t, Component c, Index kx, Index ky) const {
    const bool nyquist_x = 2 * kx == grid_.shape.nx, nyquist_y = 2 * ky == grid_.shape.ny;
    if ((odd_in_x(c, t) && nyquist_x) || (odd_in_y(c, t) && nyquist_y)) return 0;
    const double qx = 2 * std::numbers::pi * static_cast<double>(kx) / grid_.size_x();
    const double qy = 2 * std::numbers::pi * static_cast<double>(ky) / grid_.size_y();
    return stress::Wave{qx, qy, z_, poisson_}(t, c);
  }

  Grid grid_;
  double poisson_, z_ = 0;
  Index stride_;
  std::array<AlignedVector<Complex>, 3> transfer_;  ///< of the block last requested, by traction
  AlignedVector<double> modes_;                     ///< likewise
};

}  // namespace

std::unique_ptr<LayerInfluence> make_layer_influence(const Resolution& resolution, double poisson,
                                                     stress::Tractions acting) {
  if (resolution.cells.periodic.both())
    return std::make_unique<PeriodicInfluence>(resolution.cells, poisson, acting);
  if (resolution.cells.periodic.any()) return make_image_influence(resolution, poisson, acting);
  return std::make_unique<HalfSpaceInfluence>(resolution, poisson, acting);
}

}  // namespace asperity
