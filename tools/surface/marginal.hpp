/// The distribution of heights: the options that prescribe it, and its place in a dataset.
///
/// Of a kernel whose heights are not Gaussian:
///     kernel_heights                       S_L, S_U, S_B or measured
///     kernel_skewness, kernel_kurtosis     of the heights
///     kernel_quantiles(normal_score)       measured heights of mean 0 and variance 1 at even scores
/// The kernel is then that of the Gaussian field below the heights, of unit variance; acf_target and
/// acf_achieved are those of the heights.
///
/// Of a surface, by asperity-acf: the attributes acf_skewness and acf_kurtosis, and
/// acf_quantiles(normal_score).
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "dataset/dataset.hpp"
#include "marginal/measured.hpp"
#include "marginal/prescribed.hpp"
#include "marginal/translation.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

struct Marginal {
  Translation translation;
  double skewness, kurtosis;
  std::optional<MeasuredHeights> measured = {};

  static Marginal of(MeasuredHeights measured);
};

/// Writes that of a kernel.
void set_marginal(Dataset& data, const Marginal& marginal);
/// That of a kernel; none where its heights are Gaussian. Throws DataError("kernel_heights") or
/// ("kernel_quantiles").
std::optional<Marginal> marginal_of(const Dataset& data);

/// What asperity-acf found of the heights besides their autocorrelation; NAN and none where it did not.
struct HeightsWithAcf {
  double skewness = NAN, kurtosis = NAN;
  std::optional<MeasuredHeights> measured = {};
  bool gaussian = true;  ///< otherwise they evidently are not
};
HeightsWithAcf measured_with_acf(const Dataset& data);

/// A quantile table as a variable.
void set_quantiles(Dataset& data, const std::string& name, const MeasuredHeights& measured);

// ---- the options ----

struct MarginalOptions {
  std::string marginal = "";            ///< as the table says, else gaussian
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
void warn_of_kurtosis(const Tool& tool, const PrescribedHeights& prescribed, double kurtosis);

}  // namespace asperity::cli
