/// Writes a dataset of stresses row by row, so that neither a volume nor a layer need fit into memory.
///
/// Into a regular file each row goes to its place as soon as it is computed, and the ranges that stand in
/// front are put right in the end. Into a pipe, which has to begin with the ranges, the result is kept, or,
/// when it is larger than the memory allowed, computed once for the ranges and once for each variable.
#pragma once

#include <mutex>

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

  /// Computes the layers of the scene and writes its dataset with them. When they are computed, `finish` sets
  /// the last attributes of the scene.
  void write(const std::function<void()>& finish);
  /// What was the largest value of an output [Pa]; 0 where it was not requested.
  double largest(std::string_view output) const;

 private:
  using Values = std::span<const double>;
  /// A row of an output, from any thread.
  using Take = std::function<void(std::size_t output, Index layer, Index i, Values values)>;

  /// What the first rank writes.
  void write_all(const std::function<void()>& finish);
  /// How often all layers are computed, by the word of the first rank.
  Index agreed_passes(Index of_the_first) const;
  /// Every row of every layer, and what there is to do after each layer; on the first rank.
  void layers(const Take& take, const std::function<void(Index layer)>& finished = {});
  void agree_on_ranges();
  bool hides(std::size_t output) const { return scene_.least > 0 && outputs_[output].is_stress(); }
  void survey(std::size_t output, Values values);
  void note_largest(Index layer, Values values);
  /// The progress, after layer l.
  void report(std::size_t l);
  void record();
  void write_file(DatasetStream& out);
  void write_again(DatasetStream& out, std::size_t output);
  std::vector<Field> keep();

  const Tool& tool_;
  StressScene& scene_;
  const StressSelection& selection_;
  const StressSolver& solver_;
  const std::vector<StressOutput>& outputs_;
  Shape shape_;                  ///< of a layer
  std::vector<double> depths_;   ///< where values large enough to be kept can be: the first ones
  std::vector<Range> ranges_;    ///< of each output
  std::vector<double> largest_;  ///< of each layer, for --verbose
  std::mutex mutex_;             ///< of both
  Progress progress_;
  StepTable steps_;
  std::size_t done_ = 0, passes_ = 1;  ///< layers computed, times that each is
};

// ---- the stress at points, as a table: stress/points.cpp ----

/// Prints the selected quantities at each point of a file: x, y and depth a line, with their units, or under
/// a header that has them, '# x [um] y [um] depth [um]'; # begins a comment. Throws DataError("points", …),
/// also where the table needs more memory than is allowed. Warns of points above accurate_depth and of
/// stresses above the yield stress.
void print_points(const Tool& tool, StressOptions& options, const StressSelection& selection);

}  // namespace asperity::cli
