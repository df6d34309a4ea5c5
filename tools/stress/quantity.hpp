/// What asperity-stress can write: the components of the stress, and what follows from them point by point.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "stress/equivalent.hpp"

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

}  // namespace asperity::cli
