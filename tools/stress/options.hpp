/// The options of asperity-stress.
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "tools/cli/ensemble_input.hpp"

namespace asperity::cli {

struct StressOptions {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  EnsembleInput surfaces;  ///< pressed ones
  std::string depths, section, above, components = "von_mises";
  bool maximum = false;
  std::string of = "von_mises", below, result = "dataset";
  std::vector<std::string> add;  ///< further results
  std::string points;
  double poisson = none, friction = 0;
  std::string friction_angle = "0deg";
  int body = 1;
  int threads = 1;     ///< after check()
  MemoryBound memory;  ///< likewise
  std::string resolution = "adapted";

  bool adds(std::string_view word) const { return std::ranges::find(add, word) != add.end(); }
  void declare(Tool& tool);
  /// After parsing: throws ParameterError when options do not go together or are out of bounds. Reads
  /// the list of the surfaces, if there is one.
  void check(Tool& tool);
  bool several() const { return surfaces_ > 1; }
  /// Instead of a dataset.
  bool prints_table() const { return !points.empty() || result == "maxima" || several(); }

 private:
  void check_content(const Tool& tool) const;
  void check_ranks(const Tool& tool) const;
  void check_output(Tool& tool) const;
  void declare_maximum(Tool& tool);
  void declare_content(Tool& tool);
  void declare_body(Tool& tool);

  std::size_t surfaces_ = 1;
};

}  // namespace asperity::cli
