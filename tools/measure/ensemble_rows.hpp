/// The parameters of an ensemble: mean, spread and standard error over its surfaces, a row a parameter.
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

#include "stats/hypothesis/ensemble.hpp"
#include "tools/measure/groups.hpp"

namespace asperity::cli {

class EnsembleRows {
 public:
  /// Of one surface.
  void add(const Rows& rows);
  int surfaces() const { return surfaces_; }
  Table table() const;

 private:
  struct Quantity {
    std::string name, unit;
    Ensemble values = {}, squared_errors = {};
  };

  Quantity& quantity(const Quantities::Row& row);

  std::vector<Quantity> quantities_;  ///< in the order in which they came first
  int surfaces_ = 0;
};

}  // namespace asperity::cli
