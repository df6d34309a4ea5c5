/// A histogram of the heights, its standard errors, and the Gaussian of the same mean and Sq.
///
/// Bins of equal width from the lowest to the highest height, or over a given range; their number follows
/// Scott's rule,
///     width ≤ (24 √π / N)^{1/3} Sq = 3.49 Sq N^{-1/3},                                             (1)
/// the optimum for N Gaussian heights. N is not reduced for correlation, whose error does not depend on the
/// width. Each bin holds lower ≤ z < upper; the last one includes its upper edge.
///
/// The share of the heights in a bin has the error and the interval of stats/uncertainty/share_error.hpp,
/// from the field's own long waves, whatever the distribution. The misfit, the count less that of the
/// Gaussian, asks whether heights are Gaussian, and is compared with the error that it has if they are. The
/// count c of a bin [a,b], in units of Sq about the mean, sums indicators of Hermite coefficients
///     c_k = He_{k-1}(a) φ(a) - He_{k-1}(b) φ(b),                                                   (2)
/// and of these the fitted mean and Sq remove k = 1 and 2 (stats/uncertainty/effective_size.hpp):
///     Var[c - N f] = N Σ_{k≥3} (c_k²/k!) S_k,     f = Φ(b) - Φ(a).                                 (3)
///
/// Symbols   c  count      φ, Φ  the Gaussian's density and distribution      S_k  sums over the correlation
/// Accuracy  (3) to first order in 1/N, for Gaussian heights. Errors of neighbouring bins are correlated.
/// Cost      one pass over the data, 512 terms a bin; another pass for errors.
///
/// D. W. Scott, On optimal and data-based histograms, Biometrika 66 (1979) 605-610.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/field.hpp"
#include "stats/sample/moments.hpp"
#include "stats/uncertainty/effective_size.hpp"
#include "stats/uncertainty/share_error.hpp"

namespace asperity {

/// In the unit of the field.
struct HeightRange {
  double lowest = 0, highest = 0;

  double width() const { return highest - lowest; }
};
/// From the lowest to the highest value that is not missing.
HeightRange height_range(const Field& z);

/// In the unit of the field.
struct Bin {
  double lower = 0, upper = 0;
  double count = 0;
  double expected = 0;      ///< N f
  double misfit_error = 0;  ///< √(3), of count - expected
  Frequency share = {};     ///< of the heights

  double centre() const { return 0.5 * (lower + upper); }
  double width() const { return upper - lower; }
};

/// (1), at least 1, at most a million or the number of points.
int scott_bins(const Moments& moments, double points);

/// Over the range of the heights, or a given one that includes it. Throws ParameterError("bins", …) below 1,
/// DataError("heights", …) if bin edges coincide as doubles.
std::vector<Bin> histogram(const Field& z, int bins, std::optional<HeightRange> range = {});
/// Sets what a Gaussian of these moments would have.
void compare_with_gaussian(std::vector<Bin>& bins, const Moments& moments, const EffectiveSampleSize& size);
/// Sets the shares, of all bins of `z`; `sq` is the rms height of heights measured from their own mean, 0 of
/// values that are not.
void set_errors(std::vector<Bin>& bins, const Field& z, const Grid& grid, const FieldExtent& extent,
                double sq = 0);

/// Σ w(k) S_k/N over k ≥ 3, for Hermite weights w(k), k ≥ 1, that add up to `total`.
double misfit_variance(const std::function<double(int)>& weight, double total,
                       const EffectiveSampleSize& size);

}  // namespace asperity
