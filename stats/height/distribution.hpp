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

#include <algorithm>
#include <cmath>
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

// ---- classes of height ----

/// A field's points in classes of height of equal width, and what the error of its mean does to shares.
///
/// Heights are measured from the field's own mean, which is off by δ with the standard error e. A share of
/// heights at fixed distances from it is G(δ), that of the heights δ further up. It moves by the slope
///     s = [G(e) - G(-e)]/(2e),                                                                        (1)
/// which the field itself tells, whatever the distribution. At the ends of the interval, δ = ± 2e, it has
/// moved by G(δ) - G(0) - s δ besides, upwards or downwards: at an edge of the distribution, as that of a
/// population or a plateau, by as much as the share itself varies.
///
/// Symbols   G  share or density, linear between classes

class HeightClasses {
 public:
  struct Range {
    double lowest, highest;
    Index classes;

    double width() const { return (highest - lowest) / static_cast<double>(classes); }
    double centre(Index b) const { return lowest + (static_cast<double>(b) + 0.5) * width(); }
    /// The classes whose centres are at most so far from a height.
    void for_each_near(double height, double distance, const auto& visit) const {
      const double first = std::ceil((height - distance - lowest) / width() - 0.5),
                   last = std::floor((height + distance - lowest) / width() - 0.5);
      for (auto b = static_cast<Index>(std::max(first, 0.0)); static_cast<double>(b) <= last && b < classes;
           ++b)
        visit(b);
    }
  };
  /// Values beyond the range belong to the outermost classes. `own_mean`: they are measured from their mean.
  HeightClasses(const Field& z, const Grid& grid, const FieldExtent& extent, const Range& range,
                bool own_mean);

  const ShareErrors& errors() const { return errors_; }
  const Range& range() const { return range_; }
  /// The share of the heights below this one.
  double below(double height) const;
  /// The mean of `of`, a function G of the displacement, with its error and what the ends add.
  Frequency frequency(const ShareErrors::Function& of, double points, const auto& G) const {
    Frequency out{.value = of.mean(), .points = points};
    auto set_error = [&](double slope) {
      const auto [error, degrees] = of.error(slope);
      out.error = error, out.degrees = degrees;
    };
    if (!(of_mean_ > 0)) return set_error(0), out;
    const double here = G(0), above = G(of_mean_), under = G(-of_mean_),
                 slope = (above - under) / (2 * of_mean_);
    set_error(slope);
    for (const double delta : {-2 * of_mean_, 2 * of_mean_}) {
      const double left = G(delta) - here - slope * delta;
      out.rise = std::max(out.rise, left), out.fall = std::max(out.fall, -left);
    }
    return out;
  }

 private:
  Range range_;
  ShareErrors errors_;
  double of_mean_ = 0;               // e
  std::vector<double> below_ = {0};  // class b, of all
};

// ---- steps of an instrument ----

/// The steps of an instrument that heights stand on, and bins that hold whole steps.
///
/// Heights z = z₀ + k s with whole k come from converters of few bits and from files of few digits. In bins
/// of another width than a multiple of s some hold one step more than others, or none: a comb. Of bins
///     edges z₀ - s/2 + j m s,     m = max(1, ⌊w/s⌋),                                              (1)
/// each holds m steps, and no height lies near an edge.
///
/// Symbols   s  step      w  width wanted, of Scott's rule (stats/height/distribution.hpp)
/// Scope     Heights closer than 1e-6 of their range are one value. Steps are found if there are at most 1e5
///           of them in the range, if half of the points share their value, and if all differences between
///           neighbouring values are multiples of s to a tenth of s.
/// Accuracy  s to a tenth of itself over the steps in the range.
/// Cost      that of sorting the heights.

struct HeightSteps {
  Index values = 0;  ///< different ones
  double lowest = 0;
  double step = 0;  ///< 0 where they stand on none
  Index steps = 0;  ///< in the range
};
/// Equal heights.
struct HeightRun {
  double count = 0, height = 0;
};
/// Ascending, without missing points.
std::vector<HeightRun> runs_of_equal(const Field& z);
HeightSteps height_steps(const std::vector<HeightRun>& runs);
inline HeightSteps height_steps(const Field& z) { return height_steps(runs_of_equal(z)); }

/// The step of heights that come in parts, from neighbours: their least difference, where one pair in a
/// hundred or more is equal; else 0. Heights of many bits have none, and a tilt that was taken off hides it.
double neighbour_step(const Field& z);

struct Bins {
  int number = 1;
  HeightRange range;
};
/// (1), about as wide as those given.
Bins bins_on_steps(const HeightSteps& steps, const Bins& wanted);

}  // namespace asperity
