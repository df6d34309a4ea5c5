/// Writes a dataset of stresses layer by layer, so that a volume need not fit into memory.
///
/// Into a regular file each layer goes to its places as soon as it is computed, and the ranges that stand in front
/// are put right in the end; memory is that of as many layers as there are threads. Into a pipe, which has to begin
/// with the ranges, the result is kept, or, when it is larger than --memory, computed once for the ranges and once
/// for each variable.
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
               const StressOptions& options);

  /// Computes the layers of the scene and writes its dataset with them. In the end `finish` gives attributes that
  /// are there already their values.
  void write(const std::function<void(Attributes&)>& finish);
  /// What was the largest value of an output [Pa]; 0 where it was not asked for.
  double largest(std::string_view output) const;

 private:
  using Values = std::span<const double>;
  using Take = std::function<void(std::size_t output, Index layer, Values values)>;

  /// Every layer of every output, each output's in order.
  void layers(const Take& take);
  void compute(const std::vector<double>& depths, const LayerRowSink& row,
               const LayersFinished& finished) const;
  bool hides(std::size_t output) const { return scene_.least > 0 && outputs_[output].units == "Pa"; }
  void survey(std::size_t output, Values values);
  /// Of layer l, whose first output is `values`.
  void tell(std::size_t l, const Field& values);
  void record();
  void write_file(DatasetStream& out);
  std::vector<Field> keep();

  const Tool& tool_;
  StressScene& scene_;
  const StressSelection& selection_;
  std::vector<StressQuantity::Output> outputs_;
  Index rows_, columns_;  ///< of a layer: the grid's, or one row of a section
  std::size_t threads_, memory_;
  std::vector<double> depths_;  ///< where values large enough to be kept can be: the first ones
  std::optional<StressSolver> volume_;
  std::optional<StressSection> section_;
  std::vector<Range> ranges_;  ///< of each output
  Progress progress_;
  StepTable told_;
  std::size_t done_ = 0, passes_ = 1;  ///< layers computed, times that each is
};

}  // namespace asperity::cli
