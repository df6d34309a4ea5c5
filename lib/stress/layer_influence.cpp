#include "stress/layer_influence.hpp"

#include <algorithm>
#include <numbers>

#include "core/parallel.hpp"
#include "stress/corner.hpp"
#include "stress/images.hpp"
#include "stress/influence.hpp"
#include "stress/kernel_columns.hpp"

namespace asperity {
namespace {

using stress::Component;
using stress::Traction;

constexpr double scale = 0.5 / std::numbers::pi;  // of the corner sum
static_assert(block_columns == corner_lanes && block_columns == MirroredTransform::width);

// x[i] ← taper[i] (x[i] - x[i-1]), where x[-1] = x[0] for an odd kernel (even corner function) and -x[0] for
// an even one. The lag of half a period, which is its own negative, is 0 in an odd kernel.
void difference(Parity kernel, double* x, const std::vector<double>& taper, Index period) {
  const auto rows = static_cast<Index>(taper.size());
  for (Index i = rows - 1; i > 0; --i)
    for (Index q = 0; q < block_columns; ++q)
      x[i * block_columns + q] = taper[size(i)] * (x[i * block_columns + q] - x[(i - 1) * block_columns + q]);
  const double first = kernel == Parity::even ? 2 : 0;
  for (Index q = 0; q < block_columns; ++q) x[q] *= first;
  if (kernel == Parity::odd && 2 * (rows - 1) == period)
    std::fill_n(x + (rows - 1) * block_columns, block_columns, 0.0);
}

// First along y, eight rows i at a time, as the corners come; along x when a block is requested.
class HalfSpaceInfluence : public LayerInfluence {
 public:
  HalfSpaceInfluence(const Resolution& r, double poisson, stress::Tractions acting, int threads)
      : grid_(r.cells),
        taper_(r.taper),
        poisson_(poisson),
        acting_(acting),
        transforms_(r, acting, threads),
        tiles_(size(threads)) {
    columns_.fill({r.transform.blocks(), acting, r.transform.slabs().ranks()});
  }

  void set_depth(double z, stress::Set asked, Index lags) override {
    z_ = z;
    lags_ = lags == all_lags ? grid_.shape.nx : lags;
    ready_ = asked.count() > 1 && grid_.shape.cells() < shared_layer ? asked : stress::Set();
    if (ready_.any()) compute(ready_, {});
  }

  void set_component(Component c, KernelRoom room) override {
    c_ = c;
    if (!ready_[c]) compute(stress::Set().set(c), room);
  }

  TransferFunction transfer_function(Traction t, Index b, int worker) override {
    double* block = transforms_.room(worker);
    std::copy_n(columns(c_).block(t, b), grid_.shape.nx * block_columns, block);
    difference(parity(odd_in_x(c_, t)), block, taper_[0], transforms_.period().nx);
    return transforms_.of_columns(c_, t, block, worker);
  }

  std::span<const double> by_lags(Traction t, Index b, int) override {
    return {columns(c_).block(t, b), size(lags_ * block_columns)};
  }

 private:
  KernelColumns& columns(Component c) { return columns_[ready_.any() ? c : stress::xx]; }

  // Kernels that are evaluated together share their roots and arcs.
  void compute(stress::Set asked, KernelRoom room) {
    Extent own;
    for (Component c : stress::components) {
      if (!asked[c]) continue;
      columns(c).settle(lags_, room);
      own = columns(c).own_lags();
    }
    const int threads = transforms_.threads();
    parallel_ranges((own.count + block_columns - 1) / block_columns, threads,
                    [&](Index begin, Index end, int worker) {
                      for (Index k = begin; k < end; ++k)
                        put_rows(asked, own.first + k * block_columns, worker);
                    });
    for (Component c : stress::components)
      if (asked[c]) columns(c).complete(threads);
  }

  void put_rows(stress::Set asked, Index first, int worker) {
    double* out[3][6] = {};
    for (Traction t : stress::tractions)
      for (Component c : stress::components) {
        if (!acting_[t] || !asked[c]) continue;
        AlignedVector<double>& tile = tiles_[size(worker)][t][c];
        tile.resize(size(block_columns * grid_.shape.ny));
        out[t][c] = tile.data();
      }
    corner_tile(static_cast<double>(first) + 0.5, grid_.dy / grid_.dx, grid_.shape.ny, z_ / grid_.dx,
                poisson_, out);
    for (Traction t : stress::tractions)
      for (Component c : stress::components) {
        if (out[t][c] == nullptr) continue;
        difference(parity(odd_in_y(c, t)), out[t][c], taper_[1], transforms_.period().ny);
        const Index count = std::min(block_columns, lags_ - first),
                    whole = columns(c).blocks() * block_columns;
        transforms_.put_rows(c, t, out[t][c], scale, whole, first, count, columns(c), worker);
      }
  }

  Grid grid_;
  std::array<std::vector<double>, 2> taper_;
  double poisson_, z_ = 0;
  stress::Tractions acting_;
  Component c_ = stress::xx;
  Index lags_ = 0;
  KernelTransforms transforms_;
  std::array<KernelColumns, 6> columns_;  ///< transformed along y only; unless ready, in the first
  stress::Set ready_;                     ///< of a small layer: computed together
  std::vector<std::array<std::array<AlignedVector<double>, 6>, 3>> tiles_;  ///< of each worker: rows [j][8]
};

class PeriodicInfluence : public LayerInfluence {
 public:
  PeriodicInfluence(const Grid& grid, double poisson, stress::Tractions acting, int threads)
      : grid_(grid),
        poisson_(poisson),
        stride_(grid.shape.nx / 2 + 1),
        transfer_(size(threads)),
        modes_(size(threads)) {
    for (auto& transfer : transfer_)
      for (Traction t : stress::tractions)
        if (acting[t]) transfer[t].resize(size(stride_ * block_columns / 2));
  }

  void set_depth(double z, stress::Set, Index) override { z_ = z; }
  void set_component(Component c, KernelRoom) override { c_ = c; }

  TransferFunction transfer_function(Traction t, Index b, int worker) override {
    AlignedVector<Complex>& transfer = transfer_[size(worker)][t];
    for (Index q = 0; q < block_columns; q += 2)
      for (Index kx = 0; kx < stride_; ++kx)
        transfer[size(q / 2 * stride_ + kx)] = {mode(t, kx, b * block_columns + q),
                                                mode(t, kx, b * block_columns + q + 1)};
    return {transfer, stride_};
  }

  std::span<const double> by_lags(Traction t, Index b, int worker) override {
    AlignedVector<double>& modes = modes_[size(worker)];
    modes.resize(size(stride_ * block_columns));
    for (Index kx = 0; kx < stride_; ++kx)
      for (Index q = 0; q < block_columns; ++q)
        modes[size(kx * block_columns + q)] = mode(t, kx, b * block_columns + q);
    return modes;
  }

 private:
  double mode(Traction t, Index kx, Index ky) const {
    const bool nyquist_x = 2 * kx == grid_.shape.nx, nyquist_y = 2 * ky == grid_.shape.ny;
    if ((odd_in_x(c_, t) && nyquist_x) || (odd_in_y(c_, t) && nyquist_y)) return 0;
    const double qx = 2 * std::numbers::pi * static_cast<double>(kx) / grid_.size_x();
    const double qy = 2 * std::numbers::pi * static_cast<double>(ky) / grid_.size_y();
    return stress::Wave{qx, qy, z_, poisson_}(t, c_);
  }

  Grid grid_;
  double poisson_, z_ = 0;
  Component c_ = stress::xx;
  Index stride_;
  std::vector<std::array<AlignedVector<Complex>, 3>> transfer_;  ///< of each worker's last block, by traction
  std::vector<AlignedVector<double>> modes_;                     ///< likewise
};

}  // namespace

std::unique_ptr<LayerInfluence> make_layer_influence(const Resolution& resolution, double poisson,
                                                     stress::Tractions acting, int threads) {
  if (resolution.cells.periodic.both())
    return std::make_unique<PeriodicInfluence>(resolution.cells, poisson, acting, threads);
  if (resolution.cells.periodic.any()) return make_image_influence(resolution, poisson, acting, threads);
  return std::make_unique<HalfSpaceInfluence>(resolution, poisson, acting, threads);
}

}  // namespace asperity
