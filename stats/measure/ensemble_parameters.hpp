/// The parameters of an ensemble: mean, spread and standard error over the surfaces that have them.
///
/// The expected spread is the rms of the standard errors of the single surfaces. If the spread differs from
/// it by more than its own relative error, 1/√(2(n-1)), the surfaces differ in kind or are not Gaussian.
///
/// Directions [rad] are those of axes, with a period of half a turn: with C the mean of exp(2iθ) their mean
/// is ½ arg C and their spread ½ √(-2 ln |C|), with n - 1 in place of n as for other parameters.
///
/// K. V. Mardia, P. E. Jupp, Directional Statistics (Wiley 2000), 2.3.
#pragma once

#include <string>
#include <vector>

#include "stats/measure/parameter.hpp"
#include "stats/sample/ensemble.hpp"

namespace asperity {

struct EnsembleParameter {
  std::string name, unit;
  double mean, spread, expected_spread, surfaces;
  bool is_bound = false;  ///< of the mean, where a value is one

  double standard_error() const { return spread / std::sqrt(surfaces); }
};

class EnsembleParameters {
 public:
  /// The parameters of one surface.
  void add(const Parameters& parameters);
  int surfaces() const { return surfaces_; }
  /// In the order of their first appearance.
  std::vector<EnsembleParameter> all() const;

 private:
  struct Quantity {
    std::string name, unit;
    Ensemble values = {};
    bool is_bound = false;
  };

  std::vector<Quantity> quantities_;
  int surfaces_ = 0;
};

}  // namespace asperity
