/// One surface, drawn and written: whole in memory where it fits, else strip by strip as it is made.
///
/// The range stands in front of the heights, and `exact_rq` needs their moments first. A surface in memory
/// gives both; one that does not fit is drawn twice. A regular file needs no first pass for the range alone:
/// it is entered in the end. The bytes are the same each way.
#pragma once

#include "surface/synthesis.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

struct Drawing {
  const Synthesis& synthesis;
  WhiteNoise noise;
  double rms;          ///< of the ensemble [m]
  bool exact_rq;       ///< give the heights mean zero and this rms
  bool with_noise;     ///< write noise(x, y) too
  bool first;          ///< of those that are drawn: said of it is what holds of all
  std::size_t memory;  ///< bytes that the work and, where it fits, the surface may take
  std::function<void(double share)> progress;  ///< told how much of it is done

  /// Into the file of this name, which it gets in order (cli/ordered_work.hpp); `data` has the grid and the
  /// autocorrelation.
  void write(const Tool& tool, Dataset data, const std::string& name) const;
};

}  // namespace asperity::cli
