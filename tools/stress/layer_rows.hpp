/// The requested quantities of layers, row by row, in as little memory as they allow.
///
/// Components and the von Mises stress are computed from one component after the other
/// (MisesLayer); principal stresses and what follows from them need all six at once. So do layers
/// of less than 768² cells, where memory matters less than what components have in common.
#pragma once

#include <optional>
#include <vector>

#include "stress/equivalent.hpp"
#include "stress/layers.hpp"
#include "tools/stress/quantity.hpp"

namespace asperity::cli {

class LayerRows {
 public:
  /// A row of an output, which may be changed; called as StressSolver::layer calls its sink.
  using Take = std::function<void(std::size_t output, Index i, std::span<double> values)>;

  LayerRows(const StressSelection& selection, const StressSolver& solver);
  /// Layer l at depth z, within a job of StressSolver::each_layer; `behind` as StressSolver::layer calls it.
  void compute(Index l, double z, StressSolver::Workspace& work, const Take& take, const BehindRows& behind);

 private:
  struct Placed {
    const StressQuantity* quantity;
    std::size_t first;  ///< of its outputs
  };
  void at_once(double z, StressSolver::Workspace& work, const Take& take, const BehindRows& behind) const;
  void one_by_one(double z, StressSolver::Workspace& work, std::optional<MisesLayer>& mises, const Take& take,
                  const BehindRows& behind) const;
  void hand_over(const Placed& placed, const StressRow& row, Index i, const Take& take) const;

  const StressSelection& selection_;
  const StressSolver& solver_;
  std::vector<Placed> placed_;
  bool together_ = false, mises_ = false;          ///< six components at once; their sum is wanted
  std::vector<std::optional<MisesLayer>> layers_;  ///< of each job
};

}  // namespace asperity::cli
