/// The kernels of one component, transformed along y: a block of eight columns for each traction, [lag][8].
///
/// They are read block by block while the layer's half spectrum is written block by block, and lie where that
/// will be as far as there is room: two kernels of a free layer, three of a coarse one. A pressure with a
/// traction along an axis thus needs no memory for its kernels.
#pragma once

#include "stress/layer_influence.hpp"

namespace asperity {

class KernelColumns {
 public:
  KernelColumns() = default;
  KernelColumns(Index blocks, stress::Tractions acting) : blocks_(blocks), acting_(acting) {}

  Index blocks() const { return blocks_; }
  double* block(stress::Traction t, Index b) const { return place_[t].first + b * place_[t].stride; }

  /// For kernels of so many lags.
  void settle(Index lags, KernelRoom room) {
    const Index needed = lags * LayerInfluence::width;
    Index taken = 0;
    for (stress::Traction t : stress::tractions) {
      if (!acting_[t]) continue;
      if (room.first != nullptr && taken + needed <= room.stride) {
        place_[t] = {room.first + taken, room.stride};
        taken += needed;
      } else {
        own_[t].resize(size(blocks_ * needed));
        place_[t] = {own_[t].data(), needed};
      }
    }
  }

 private:
  Index blocks_ = 0;
  stress::Tractions acting_;
  std::array<KernelRoom, 3> place_{};
  std::array<AlignedVector<double>, 3> own_;
};

}  // namespace asperity
