/// What asperity-stats can print: groups of parameters, each computed only when asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/table.hpp"
#include "measured.hpp"
#include "stats/derivative_error.hpp"

namespace asperity::cli {

struct StatsOptions {
  std::string groups = "height", quantiles, direction;
  std::array<double, 2> material_ratios{0.1, 0.8};
  double acf_level = 0.2;
  std::string profile;  ///< x or y: profile parameters in place of the areal ones

  void declare(Tool& tool);
  /// Throws ParameterError for an option of a group that is not asked for.
  void check(const Tool& tool) const;
  /// Whether --parameters names the group, or all; throws ParameterError("parameters", …) for unknown words.
  bool asks_for(const std::string& group) const;
};

/// A measured field and what several groups need of it, computed once, when first needed.
class Sample {
 public:
  Sample(Measured measured, const std::string& variable, int threads);

  const Measured& measured() const { return measured_; }
  const Grid& grid() const { return measured_.grid; }
  const Field& heights() const { return measured_.heights; }
  const std::string& units() const { return measured_.units; }
  const std::string& variable() const { return variable_; }
  int threads() const { return threads_; }
  const Moments& moments() const { return moments_; }
  const Pairs& pairs();
  const LagField& acf();  ///< estimated up to default_max_lag
  const EffectiveSize& size();
  DerivativeErrors derivative_errors();

 private:
  Measured measured_;
  std::string variable_;
  int threads_;
  Moments moments_;
  std::optional<Pairs> pairs_;
  std::optional<LagField> acf_;
  std::optional<EffectiveSize> size_;
};

using Rows = std::vector<Quantities::Row>;

Rows height_rows(Sample& sample);
Rows quantile_rows(Sample& sample, const StatsOptions& options);
/// Each test's statistic and p-value, with and without the correlation of the heights.
Rows gaussianity_rows(Sample& sample);
Rows material_rows(Sample& sample, const StatsOptions& options);
Rows spatial_rows(const Tool& tool, Sample& sample, const StatsOptions& options);
/// Named P…, or R… where long waves were filtered out by a cut-off, `section`; NaN: none was.
Rows profile_rows(Sample& sample, const StatsOptions& options, double section);
/// Throws DataError when the field is no length.
Rows hybrid_rows(Sample& sample, const StatsOptions& options);

}  // namespace asperity::cli
