/// A field prepared for measurement: form removed, filtered, with the correlation that its errors rest on.
///
/// Heights are measured from the form, the F-operation of ISO 25178-2 (stats/filter/form.hpp). The S-filter
/// removes waves shorter than λs, the L-filter those longer than λc (stats/filter/preparation.hpp).
/// Errors rest on the autocorrelation that the field was drawn with, if it is known and the field unfiltered,
/// and otherwise on an estimate.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/field.hpp"
#include "marginal/translation.hpp"
#include "stats/filter/preparation.hpp"
#include "stats/spatial/pairs.hpp"
#include "stats/uncertainty/effective_size.hpp"
#include "stats/uncertainty/long_waves.hpp"

namespace asperity {

struct Preparation {
  Form form = {};
  Cutoff shorter = {}, longer = {};  ///< at λs, at λc

  bool filters() const { return shorter.given() || longer.given(); }
};

/// Missing heights are NaN.
struct Surface {
  Grid grid;
  Field heights = {};  ///< empty until they are read
  double level = 0;    ///< the mean that was subtracted
  int degree = 0;      ///< of the form that was, now or before
  double filled = 0;   ///< share of the points that were missing and filled before
  double aligned = 0;  ///< share of Sq that aligning scan lines took before
  double step = 0;     ///< of the heights before the form was removed; 0: none, or smoothed since
  double largest = 0;  ///< of the absolute values, form included; 0: not known
  std::string variable = "heights", units = "m";
  std::optional<LagField> correlation = {};      ///< known, normalised; none: estimate it
  std::optional<Translation> distribution = {};  ///< known, where it is not Gaussian
  std::vector<std::string> doubts = {};          ///< of filters that have not converged
  bool flat = false;                             ///< FlatSurface's: all heights are 0
};

/// Of heights that are all the same, or differ by round-off.
class FlatSurface : public DataError {
 public:
  FlatSurface(const DataError& why, Surface of);
  std::shared_ptr<const Surface> surface;  ///< with 0 in place of round-off
};

/// Throws ParameterError("remove-form"), ("lambda-s") or ("lambda-c") as the form and the filters do, and
/// DataError(variable) where the field is not of the grid's shape, and FlatSurface where only rounding
/// remains (refuse_round_off).
Surface prepared(Surface surface, const Preparation& preparation, int threads = 1);

/// The longest lags at which errors, tests and simulated surfaces ask for a known correlation: those of a
/// torus of twice the field, whole or by so many points more that its transform is fast, and the two beyond
/// the field that differences reach. Of a periodic field half a period.
Shape lags_of_errors(const Grid& grid);

/// What subtraction may leave of values up to `size` that cancel.
constexpr double round_off_of(double size) { return 32 * std::numeric_limits<double>::epsilon() * size; }
/// Throws DataError(variable, …) if heights up to `largest` are round-off of values up to `size`.
void refuse_round_off(double largest, double size, const Form& form, const std::string& variable);

/// The correlation that errors rest on, known or estimated, and the pairs of points that the field has.
struct ErrorBasis {
  LagField correlation;
  bool estimated;
  Pairs pairs;
  FormModes form = {};  ///< that heights were measured from

  EffectiveSampleSize size() const { return size(correlation); }
  /// For another correlation, known or estimated as this one.
  EffectiveSampleSize size(const LagField& rho) const {
    return estimated ? EffectiveSampleSize::of_estimate(rho, pairs, form)
                     : EffectiveSampleSize(rho, pairs, form);
  }
  /// The correlation; zero at lags where an estimate is not significant.
  LagField known_lags() const { return estimated ? significant_lags(correlation, pairs) : correlation; }
  /// What the long waves of the field depend on.
  FieldExtent extent() const;

 private:
  template <class Visit>
  void for_each_known(Visit visit) const;
};

/// The known correlation, else the estimate up to half the field.
ErrorBasis error_basis(const Surface& surface, int threads = 1);

/// A number of independent heights or profiles, rounded to a tenth.
std::string rounded(double independent);
/// Why errors cannot be given, "N_eff = 3.2 is below 5" or a form that took too much; "" where they can.
std::string too_few(const EffectiveSampleSize& size);

}  // namespace asperity
