/// The options that say which heights a surface shall have.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "marginal/prescribed.hpp"
#include "tools/cli/tool.hpp"
#include "tools/surface/marginal_dataset.hpp"

namespace asperity::cli {

struct MarginalOptions {
  std::string marginal = "gaussian";
  double skewness = 0, kurtosis = NAN;  ///< NAN: as the skewness has it

  void declare(Tool& tool);
  /// The first of them that was given, or nothing.
  static std::string given(const Tool& tool);

  /// The moments requested; none for Gaussian heights. Throws UsageError where a measured distribution is
  /// meant.
  std::optional<PrescribedHeights> moments(const Tool& tool, const HeightsWithAcf& table,
                                           InfeasiblePolicy answer) const;
  /// Of the heights; none where they are Gaussian. `table` is what came with the autocorrelation, `answer`
  /// what to do about a kurtosis that no distribution has.
  std::optional<Marginal> wanted(const Tool& tool, const HeightsWithAcf& table,
                                 InfeasiblePolicy answer) const;

 private:
  bool chosen_by_moments(const Tool& tool) const;
};

/// Warns of heights whose kurtosis is another than the one prescribed.
void tell_kurtosis(const Tool& tool, const PrescribedHeights& prescribed, double kurtosis);

}  // namespace asperity::cli
