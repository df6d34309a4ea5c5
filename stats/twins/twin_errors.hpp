/// Errors of any parameter by simulation: what it does on twins of the field (stats/twins/twin_fields.hpp), a
/// parametric bootstrap.
///
/// Of K twins, scaled to the rms height of the field and with the same form removed, a parameter has the
/// values t_k of mean m and standard deviation s, which is its standard error. With x = t, or ln t where all
/// t and the value are positive, the 95 % interval is
///     x(value) - β ± u s_x,     u the quantile of Student's t at 97.5 %,                                (1)
/// of 1/ν = 1/(K-1) + 1/ν_S degrees of freedom, ν_S those of an estimated correlation
/// (stats/uncertainty/effective_size.hpp). β is the bias m_x - x(θ) where a twin's own parameter θ is known:
/// the mean, the lengths of its correlation, and the scale of heights, which the form has lowered. Angles are
/// those of axes, of period π.
///
/// Symbols   K  twins      x(·)  logarithm or identity
/// Scope     What twins share with the field: its correlation and the distribution of its heights.
/// Accuracy  s to 1/√(2(K-1)), 9 % for 60 twins, besides the error of the correlation.
/// Cost      K drawings and measurements of the groups asked for.
///
/// B. Efron, R. J. Tibshirani, An Introduction to the Bootstrap, Chapman & Hall 1993, 6.5, 10.2.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "stats/measure.hpp"
#include "stats/spatial/acf_length.hpp"
#include "stats/twins/twin_fields.hpp"

namespace asperity {

struct TwinOptions {
  Index twins = 60;
  int threads = 1;
  std::uint64_t seed = 1;
  std::function<void(Index done)> each = {};  ///< called after each round of threads
};

/// Which parameters of a sample have errors by twins, and which have right ones without.
class TwinScope {
 public:
  explicit TwinScope(const Sample& sample);

  /// False for counts; for slopes, curvatures and summits if the correlation is estimated and points are
  /// missing or heights are not Gaussian; and for extremes of heights whose distribution is measured.
  bool holds(const Parameter& parameter) const;
  /// False without an error, unless it is said why.
  bool needs_none(const Parameter& parameter) const;

 private:
  bool known_, complete_, given_, gaussian_;  ///< given_: the distribution of the heights
  bool stepped_;                              ///< heights are in steps, as those of no twin
};

class TwinErrors {
 public:
  /// Of the groups that `asked` names, tests of Gaussianity aside.
  TwinErrors(const Sample& sample, const MeasureOptions& asked, const TwinOptions& options);

  /// Sets error and interval of the parameters for which `wanted` returns true and which vary between twins.
  void apply(Parameters& parameters, const std::function<bool(const Parameter&)>& wanted) const;
  Index twins() const { return twins_; }

 private:
  struct Law {
    double error;
    Interval interval;
    std::string why = {};  ///< why there is none
  };
  void set_truths(const CentralLobe& lobe);  ///< of the twins' correlation
  std::optional<Law> law_of(const Parameter& parameter) const;

  Index twins_ = 0;
  double quantile_ = 0;  ///< u
  double scale_bias_ = 0;
  std::map<std::string, std::vector<double>> values_ = {};
  std::set<std::string> heights_ = {};  ///< parameters that the form has lowered
  std::map<std::string, double> truths_ = {};
};

/// All parameters that twins have, or those that need them.
enum class TwinUse { everywhere, where_needed, where_quick };

/// Whether twins take about two seconds on one core: 512x512 points for one group of parameters, 256x256 for
/// all.
bool twins_are_quick(const Grid& grid, const MeasureOptions& asked);

/// Sets errors and intervals by twins; `where_quick` only if they are, else it returns false.
bool errors_by_twins(const Sample& sample, const MeasureOptions& asked, TwinUse use,
                     const TwinOptions& options, Parameters& parameters);

}  // namespace asperity
