/// The kernels of one component, transformed along y: a block of eight columns for each traction, [lag][8].
///
/// They are read block by block while the layer's half spectrum is written block by block, and are stored
/// where that will be as far as there is room: two kernels of a free layer, three of a coarse one. A pressure
/// with a traction along an axis thus needs no memory for its kernels. Of several ranks each writes some lags
/// of all blocks there, and keeps all lags of its own blocks in memory of its own.
#pragma once

#include <algorithm>
#include <vector>

#include "stress/layer_influence.hpp"
#include "transform/block_exchange.hpp"
#include "transform/mirrored.hpp"

namespace asperity {

inline Parity parity(bool odd) { return odd ? Parity::odd : Parity::even; }

class KernelColumns {
 public:
  KernelColumns() = default;
  KernelColumns(Index blocks, stress::Tractions acting, const Ranks& ranks)
      : blocks_(blocks), acting_(acting), lags_(0, ranks) {}

  Index blocks() const { return blocks_; }
  /// The lags that this rank writes, in eights.
  Extent own_lags() const { return lags_.own(); }
  /// Where it writes the eight values of a lag.
  double* place(stress::Traction t, Index b, Index lag) const {
    return place_[t].first + b * place_[t].stride + (lag - own_lags().first) * width;
  }
  /// All lags of a block, when they are complete.
  const double* block(stress::Traction t, Index b) const {
    return lags_.shared() ? own_[t].data() + (b - own_blocks().first) * lags_.rows() * width
                          : place_[t].first + b * place_[t].stride;
  }

  /// For kernels of so many lags.
  void settle(Index lags, KernelRoom room) {
    lags_ = Slabs(lags, lags_.ranks(), width);
    const Index needed = own_lags().count * width;
    Index taken = 0;
    for (stress::Traction t : stress::tractions) {
      if (!acting_[t]) continue;
      if (room.first != nullptr && taken + needed <= room.stride) {
        // What goes to other ranks is contiguous.
        place_[t] = lags_.shared() ? KernelRoom{room.first + taken * blocks_, needed}
                                   : KernelRoom{room.first + taken, room.stride};
        taken += needed;
      } else {
        written_[t].resize(size(blocks_ * needed));
        place_[t] = {written_[t].data(), needed};
      }
    }
  }

  /// When all lags are written; collective.
  void complete(int threads) {
    if (!lags_.shared()) return;
    for (stress::Traction t : stress::tractions)
      if (acting_[t]) complete(t, threads);
  }

 private:
  static constexpr Index width = LayerInfluence::width;
  static_assert(width == BlockExchange<double>::width);

  Extent own_blocks() const { return blocks_of(blocks_, lags_.ranks(), lags_.ranks().rank()); }
  void complete(stress::Traction t, int threads) {
    own_[t].resize(size(own_blocks().count * lags_.rows() * width));
    double* to = own_[t].data();
    BlockExchange<double> exchange(lags_, blocks_, threads);
    for (Index step = 0; step < exchange.steps(); ++step) {
      exchange.fetch(step, {place_[t].first, size(blocks_ * place_[t].stride)});
      for (Index k = 0; k < exchange.at_hand(step).count; ++k)
        for (int r = 0; r < lags_.ranks().count(); ++r)
          to = std::ranges::copy(exchange.part(step, k, r), to).out;
    }
  }

  Index blocks_ = 0;
  stress::Tractions acting_;
  Slabs lags_{0};
  std::array<KernelRoom, 3> place_{};
  std::array<AlignedVector<double>, 3> written_, own_;
};

/// Transforms kernels, which are even or odd in x and in y: eight rows of lags along y, as they come, and
/// eight columns along x, when their block is requested. Several threads may do so, each as one worker.
class KernelTransforms {
 public:
  KernelTransforms(const Resolution& r, stress::Tractions acting, int threads)
      : lags_(r.cells.shape),
        along_x_(r.transform.torus().nx),
        along_y_(r.transform.torus().ny),
        work_(size(threads)) {
    for (Work& work : work_) {
      work.lags.resize(size(std::max(lags_.nx, lags_.ny) * width));
      work.columns.resize(size(std::max(along_x_.size(), along_y_.size())));
      work.spectrum.resize(size(along_y_.size() + width));  // the last block of few columns is read whole
      for (stress::Traction t : stress::tractions)
        if (acting[t]) work.transfer[t].resize(size(along_x_.size()));
    }
  }

  int threads() const { return static_cast<int>(work_.size()); }
  Shape period() const { return {along_x_.period(), along_y_.period()}; }
  /// Of a worker, room for eight rows or columns, [lag][8].
  double* room(int worker) { return work_[size(worker)].lags.data(); }

  /// `rows` [lag in y][8] of the `count` lags in x from `first` on, transformed and times a factor, to `to`;
  /// what is scratch, from column `modes` on, as 0.
  void put_rows(stress::Component c, stress::Traction t, const double* rows, double factor, Index modes,
                Index first, Index count, const KernelColumns& to, int worker) {
    Work& work = work_[size(worker)];
    transform(along_y_, parity(odd_in_y(c, t)), rows, lags_.ny, work, work.spectrum.data());
    for (Index b = 0; b < to.blocks(); ++b)
      for (Index l = 0; l < count; ++l) {
        const auto* row =
            reinterpret_cast<const double*>(work.spectrum.data() + l / 2 * along_y_.stride() + b * width);
        double* column = to.place(t, b, first + l);
        for (Index q = 0; q < width; ++q) column[q] = b * width + q < modes ? factor * row[2 * q + l % 2] : 0;
      }
  }
  /// The transfer function of a block of columns [lag in x][8].
  LayerInfluence::TransferFunction of_columns(stress::Component c, stress::Traction t, const double* block,
                                              int worker) {
    Work& work = work_[size(worker)];
    transform(along_x_, parity(odd_in_x(c, t)), block, lags_.nx, work, work.transfer[t].data());
    return {work.transfer[t], along_x_.stride()};
  }

 private:
  static constexpr Index width = LayerInfluence::width;
  static_assert(width == MirroredTransform::width);

  struct Work {
    AlignedVector<double> lags;
    AlignedVector<Complex> columns, spectrum;
    std::array<AlignedVector<Complex>, 3> transfer;  ///< of the block last requested, by traction
  };

  // Eight interleaved sequences, by pairs.
  static void transform(const MirroredTransform& along, Parity parity, const double* interleaved, Index given,
                        Work& work, Complex* pairs) {
    columns_from_rows<MirroredTransform::pairs>(reinterpret_cast<const Complex*>(interleaved), given,
                                                work.columns.data(), along.stride());
    along.apply(parity, work.columns.data(), given, pairs);
  }

  Shape lags_;
  MirroredTransform along_x_, along_y_;
  std::vector<Work> work_;
};

}  // namespace asperity
