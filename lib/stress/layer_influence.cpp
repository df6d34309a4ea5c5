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
        along_x_(r.transform.torus().nx),
        along_y_(r.transform.torus().ny),
        work_(size(threads), Work(*this)) {
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
    Work& work = work_[size(worker)];
    const Parity along = parity(odd_in_x(c_, t));
    std::copy_n(columns(c_).block(t, b), work.rows.size(), work.rows.begin());
    difference(along, work.rows.data(), taper_[0], along_x_.period());
    transform(along_x_, along, work.rows.data(), grid_.shape.nx, work, work.transfer[t].data());
    return {work.transfer[t], along_x_.stride()};
  }

  std::span<const double> by_lags(Traction t, Index b, int) override {
    return {columns(c_).block(t, b), size(lags_ * block_columns)};
  }

 private:
  KernelColumns& columns(Component c) { return columns_[ready_.any() ? c : stress::xx]; }

  struct Work {
    explicit Work(const HalfSpaceInfluence& of)
        : rows(size(of.grid_.shape.nx * block_columns)),
          columns(size(std::max(of.along_x_.size(), of.along_y_.size()))),
          along_y_pairs(
              size(of.along_y_.size() + block_columns)) {  // the last block of few columns is read whole
      for (Traction t : stress::tractions)
        if (of.acting_[t]) {
          transfer[t].resize(size(of.along_x_.size()));
        }
    }

    std::array<std::array<AlignedVector<double>, 6>, 3> tile;  ///< eight rows: [j][8]
    AlignedVector<double> rows;
    AlignedVector<Complex> columns, along_y_pairs;
    std::array<AlignedVector<Complex>, 3> transfer;  ///< of the block last requested, by traction
  };

  // Kernels that are evaluated together share their roots and arcs.
  void compute(stress::Set asked, KernelRoom room) {
    Extent own;
    for (Component c : stress::components) {
      if (!asked[c]) continue;
      columns(c).settle(lags_, room);
      own = columns(c).own_lags();
    }
    const int threads = static_cast<int>(work_.size());
    parallel_ranges((own.count + block_columns - 1) / block_columns, threads,
                    [&](Index begin, Index end, int worker) {
                      for (Index k = begin; k < end; ++k)
                        transform_rows(asked, own.first + k * block_columns, work_[size(worker)]);
                    });
    for (Component c : stress::components)
      if (asked[c]) columns(c).complete(threads);
  }

  void transform_rows(stress::Set asked, Index first_row, Work& work) {
    double* out[3][6] = {};
    for (Traction t : stress::tractions)
      for (Component c : stress::components) {
        if (!acting_[t] || !asked[c]) continue;
        work.tile[t][c].resize(size(block_columns * grid_.shape.ny));
        out[t][c] = work.tile[t][c].data();
      }
    corner_tile(static_cast<double>(first_row) + 0.5, grid_.dy / grid_.dx, grid_.shape.ny, z_ / grid_.dx,
                poisson_, out);
    for (Traction t : stress::tractions)
      for (Component c : stress::components)
        if (out[t][c] != nullptr) transform_along_y(t, c, first_row, work);
  }

  void transform_along_y(Traction t, Component c, Index first_row, Work& work) {
    double* tile = work.tile[t][c].data();
    const Parity along = parity(odd_in_y(c, t));
    difference(along, tile, taper_[1], along_y_.period());
    transform(along_y_, along, tile, grid_.shape.ny, work, work.along_y_pairs.data());
    const Index rows = std::min(block_columns, lags_ - first_row);
    for (Index b = 0; b < columns(c).blocks(); ++b)
      for (Index l = 0; l < rows; ++l) {
        const auto* row = reinterpret_cast<const double*>(work.along_y_pairs.data() +
                                                          l / 2 * along_y_.stride() + b * block_columns);
        double* column = columns(c).place(t, b, first_row + l);
        for (Index q = 0; q < block_columns; ++q) column[q] = scale * row[2 * q + l % 2];
      }
  }

  // Eight interleaved sequences, transformed, by pairs.
  static void transform(const MirroredTransform& along, Parity parity, const double* interleaved, Index given,
                        Work& work, Complex* pairs) {
    columns_from_rows<MirroredTransform::pairs>(reinterpret_cast<const Complex*>(interleaved), given,
                                                work.columns.data(), along.stride());
    along.apply(parity, work.columns.data(), given, pairs);
  }

  Grid grid_;
  std::array<std::vector<double>, 2> taper_;
  double poisson_, z_ = 0;
  stress::Tractions acting_;
  Component c_ = stress::xx;
  Index lags_ = 0;
  MirroredTransform along_x_, along_y_;
  std::array<KernelColumns, 6> columns_;  ///< transformed along y only; unless ready, in the first
  stress::Set ready_;                     ///< of a small layer: computed together
  std::vector<Work> work_;
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
