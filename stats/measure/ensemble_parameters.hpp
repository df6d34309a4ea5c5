/// The parameters of an ensemble: mean, spread and standard error over its surfaces.
///
/// A parameter that some surface lacks counts the surfaces that have it. Beside the spread stands the one that the
/// surfaces' own standard errors lead to expect, their root mean square: where the two differ by more than the
/// spread's own error, 1/√(2(n-1)) of it, the surfaces are not alike, or not the Gaussian ones that errors assume.
///
/// Directions [rad] are those of axes, the same after half a turn: with C the mean of exp(2iθ) their mean is ½ arg C, their
/// spread ½ √(-2 ln |C|), here with n - 1 in place of n as of other parameters.
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

  double standard_error() const { return spread / std::sqrt(surfaces); }
};

class EnsembleParameters {
 public:
  /// Of one surface.
  void add(const Parameters& parameters);
  int surfaces() const { return surfaces_; }
  /// In the order in which they came first.
  std::vector<EnsembleParameter> all() const;

 private:
  struct Quantity {
    std::string name, unit;
    Ensemble values = {}, squared_errors = {};
  };

  std::vector<Quantity> quantities_;
  int surfaces_ = 0;
};

}  // namespace asperity
