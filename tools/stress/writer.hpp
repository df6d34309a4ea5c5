/// Writes a dataset of stresses layer by layer, so that a volume need not fit into memory.
///
/// Into a regular file each layer goes to its places as soon as it is computed, and the ranges that stand in
/// front are put right in the end; memory is that of as many layers as there are threads. Into a pipe, which
/// has to begin with the ranges, the result is kept, or, when it is larger than the memory allowed, computed
/// once for the ranges and once for each variable.
#pragma once

#include "dataset/layout.hpp"
#include "tools/cli/dataset_stream.hpp"
#include "tools/cli/progress.hpp"
#include "tools/stress/quantity.hpp"
#include "tools/stress/scene.hpp"

namespace asperity::cli {

class StressWriter {
 public:
  StressWriter(const Tool& tool, StressScene& scene, const StressSelection& selection,
               const StressSolver& solver);

  /// Computes the layers of the scene and writes its dataset with them. In the end `finish` sets attributes.
  void write(const std::function<void(Attributes&)>& finish);
  /// What was the largest value of an output [Pa]; 0 where it was not requested.
  double largest(std::string_view output) const;

 private:
  using Values = std::span<const double>;
  using Take = std::function<void(std::size_t output, Index layer, Values values)>;

  /// Every layer of every output, each output's in order.
  void layers(const Take& take);
  bool hides(std::size_t output) const { return scene_.least > 0 && outputs_[output].is_stress(); }
  void survey(std::size_t output, Values values);
  /// Of layer l, whose first output is `values`.
  void tell(std::size_t l, const Field& values);
  void record();
  void write_file(DatasetStream& out);
  std::vector<Field> keep();

  const Tool& tool_;
  StressScene& scene_;
  const StressSelection& selection_;
  const StressSolver& solver_;
  const std::vector<StressOutput>& outputs_;
  Shape shape_;                 ///< of a layer
  std::vector<double> depths_;  ///< where values large enough to be kept can be: the first ones
  std::vector<Range> ranges_;   ///< of each output
  Progress progress_;
  StepTable steps_;
  std::size_t done_ = 0, passes_ = 1;  ///< layers computed, times that each is
};

}  // namespace asperity::cli
