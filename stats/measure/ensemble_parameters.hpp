/// The parameters of an ensemble: mean, spread and standard error over the surfaces that have them; and how
/// far they are from those of another surface.
///
/// The expected spread is the rms of the standard errors of the single surfaces. If the spread differs from
/// it by more than its own relative error, 1/√(2(n-1)), the surfaces differ in kind or are not Gaussian.
///
/// Directions [rad] are those of axes, with a period of half a turn: with C the mean of exp(2iθ) their mean
/// is ½ arg C and their spread ½ √(-2 ln |C|), with n - 1 in place of n as for other parameters.
///
/// A parameter of one surface, x, and the mean y of n others differ by
///     z = (y - x)/√(e_x² + e_y²)                                                                      (1)
/// standard errors. e_x, and e_y of one other, are theory's, with the degrees of freedom ν of the Student's t
/// that gives their 95 % intervals. Of several others e_y is the larger of spread and expected spread over
/// √n, with the n ν degrees of all their errors while the two agree within twice the relative error of the
/// spread, and n - 1 otherwise, or where theory gives no errors. z is judged by Student's t of Welch's 1/ν =
/// (e_x⁴/ν_x + e_y⁴/ν_y)/(e_x² + e_y²)². Of several others as large as the first, or where theory gives no
/// e_x, it is e_y √n, x being one more of them, and ν that of e_y: a scratch does not excuse itself by the
/// errors that it makes. Of a single other, and of p-values, there is no z without e_x. Of K parameters with
/// a z those with p ≤ 0.01/K differ (Bonferroni). y is a mean of estimates, and not pooled, so that x and y
/// have the same bias.
///
/// Scope     Independent surfaces. Of a surface before and after a filter most of the errors are common: what
///           differs by (1) does so all the more, and what agrees may differ.
/// Accuracy  Of 400 pairs of one model, 128 × 128 points, known or estimated correlations, K = 28 to 31,
///           one had a parameter that differs; of 100 surfaces against four others each, exponential
///           correlation estimated, K = 58, one: the direction of a contour that is a circle.
///
/// B. L. Welch, Biometrika 34 (1947) 28-35.
/// K. V. Mardia, P. E. Jupp, Directional Statistics (Wiley 2000), 2.3.
#pragma once

#include <string>
#include <vector>

#include "stats/measure/parameter.hpp"
#include "stats/sample/ensemble.hpp"

namespace asperity {

class PooledMaps;

struct EnsembleParameter {
  std::string name, unit;
  double mean, standard_error, spread, expected_spread, surfaces;
  double expected_degrees = unknown;  ///< of freedom of the errors of all surfaces, n ν
  bool is_bound = false;              ///< of the mean, where a value is one
};

class EnsembleParameters {
 public:
  /// The parameters of one surface; numbers of points count alike.
  void add(const Parameters& parameters, double weight = 1);
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

/// Puts the values and errors of pooled maps (stats/measure/pooled_maps.hpp) in place of means; Sal, Str and
/// the slowest decay have no error. Of maps of several spacings what is not pooled has no value, but for the
/// mean and numbers of points.
void take_pooled(std::vector<EnsembleParameter>& means, const Parameters& pooled, const PooledMaps& maps);

struct ComparedParameter {
  std::string name, unit;
  double first = unknown, first_error = unknown;    ///< x, e_x
  double others = unknown, others_error = unknown;  ///< y, e_y
  double number = 0;                                ///< of the others that have it
  double z = unknown, p = unknown;                  ///< (1); unknown without both errors
  bool differs = false;
};
/// All that the first or the others have. `other` is the one that `others` holds, where it holds one.
std::vector<ComparedParameter> compared(const Parameters& first, const EnsembleParameters& others,
                                        const Parameters& other);

}  // namespace asperity
