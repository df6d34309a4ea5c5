/// What asperity-stress can write: the components of the stress, and what follows from them point by point.
#pragma once

#include <string>
#include <vector>

#include "dataset/layout.hpp"
#include "stress/component.hpp"
#include "stress/layers.hpp"

namespace asperity::cli {

/// One word of --components, and the variables that it stands for.
struct StressQuantity {
  struct Output {
    std::string name, long_name, units = "Pa";
  };

  std::string word;
  stress::Set needs;  ///< components of which it is made
  std::vector<Output> outputs;
  /// For `count` points: out[k][j] of output k, from the needed components.
  void (*compute)(const StressRow& stress, Index count, double* const* out);
};

/// All that there are, in the order of their variables in a dataset.
const std::vector<StressQuantity>& stress_quantities();
/// Their words, separated by commas.
std::string stress_words();

/// The quantities that were asked for, each once.
class StressSelection {
 public:
  /// A list of words, "all" standing for all stresses but not for their directions; throws
  /// ParameterError("components", …) for any other.
  explicit StressSelection(const std::string& list);

  stress::Set needs() const;
  std::vector<StressQuantity::Output> outputs() const;
  /// out[k] of output k of outputs().
  void compute(const StressRow& stress, Index count, double* const* out) const;

 private:
  std::vector<const StressQuantity*> chosen_;
};

}  // namespace asperity::cli
