/// A field's points in classes of height of equal width, and what the field's mean does to them.
///
/// Shares of heights measured from the field's own mean z̄ move with it by the density of the heights
/// (stats/uncertainty/share_error.hpp). It is estimated from the classes by a Gaussian kernel, of half the
/// bandwidth that is the best one for N_eff Gaussian heights, 0.53 Sq N_eff^{-1/5}: 0.17 Sq at N_eff = 300.
/// Wider ones blur the peaks of two populations, whose errors at 3 of their deviations apart come out at half
/// of the true ones; the noise of narrow ones adds a tenth to the errors of densities at most.
#pragma once

#include <algorithm>
#include <cmath>

#include "stats/uncertainty/share_error.hpp"

namespace asperity {

/// Of the density that moves with the mean of heights of this rms value.
inline double mean_bandwidth(double sq, const FieldExtent& extent) {
  return 0.53 * sq * std::pow(std::max(extent.patches, 1.0), -0.2);
}

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
  /// Values beyond the range belong to the outermost classes.
  HeightClasses(const Field& z, const Grid& grid, const FieldExtent& extent, const Range& range);

  const ShareErrors& errors() const { return errors_; }
  const Range& range() const { return range_; }

 private:
  Range range_;
  ShareErrors errors_;
};

/// The density of the heights by a kernel of a bandwidth, from sums over some quarter of it.
class SmoothDensity {
 public:
  SmoothDensity(const HeightClasses& classes, double bandwidth);

  double operator()(double height) const;
  double slope(double height) const;

 private:
  double bandwidth_;
  HeightClasses::Range range_;
  std::vector<double> shares_ = {};
};

}  // namespace asperity
