/// What asperity-stress can write: the components of the stress, and what follows from them point by point.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stress/equivalent.hpp"
#include "stress/layers.hpp"

namespace asperity::cli {

/// A variable of a dataset, or a column of a table.
struct StressOutput {
  std::string name, long_name, units = "Pa";

  bool is_stress() const { return units == "Pa"; }
};

/// One word of --components, and the outputs that it stands for.
struct StressQuantity {
  std::string word;
  stress::Set needs;  ///< components of which it is made
  std::vector<StressOutput> outputs;
  std::function<void(const StressRow& stress, RowOutputs out)> compute;  ///< all outputs along a row
  double of_mises = 0;  ///< how many times the von Mises stress it is, if it is that
};

/// The words of all quantities, in the order of their variables in a dataset, separated by commas.
std::string stress_words();

/// The quantities that were requested, each once.
class StressSelection {
 public:
  /// A list of words, "all" standing for all stresses but not for their directions; throws
  /// ParameterError("components", …) for any other.
  explicit StressSelection(const std::string& list);

  stress::Set needs() const { return needs_; }
  const std::vector<StressOutput>& outputs() const { return outputs_; }
  const std::vector<const StressQuantity*>& chosen() const { return chosen_; }
  /// out[k], a row of output k of outputs().
  void compute(const StressRow& stress, RowOutputs out) const;

 private:
  std::vector<const StressQuantity*> chosen_;
  stress::Set needs_;
  std::vector<StressOutput> outputs_;
};

/// The requested quantities of layers, row by row, in as little memory as they allow.
///
/// Components and the von Mises stress are computed from one component after the other
/// of less than 768² cells, where memory matters less than what components have in common.
class LayerRows {
 public:
  /// A row of an output, which may be changed; called as StressSolver::layer calls its sink.
  using Take = std::function<void(std::size_t output, Index i, std::span<double> values)>;

  LayerRows(const StressSelection& selection, const StressSolver& solver);
  /// Layer l at depth z, within a job of StressSolver::each_layer; `after` as StressSolver::layer calls it.
  void compute(Index l, double z, StressSolver::Workspace& work, const Take& take, const BehindRows& after);

 private:
  struct Placed {
    const StressQuantity* quantity;
    std::size_t first;  ///< of its outputs
  };
  void at_once(double z, StressSolver::Workspace& work, const Take& take, const BehindRows& after) const;
  void one_by_one(double z, StressSolver::Workspace& work, std::optional<MisesLayer>& mises, const Take& take,
                  const BehindRows& after) const;

  const StressSelection& selection_;
  const StressSolver& solver_;
  std::vector<Placed> placed_;
  bool together_ = false, mises_ = false;          ///< six components at once; their sum is wanted
  std::vector<std::optional<MisesLayer>> layers_;  ///< of each job
};

}  // namespace asperity::cli
