/// A field's points in classes of height of equal width, and what the error of its mean does to shares.
///
/// Heights are measured from the field's own mean, which is off by δ with the standard error e. A share of
/// heights at fixed distances from it is G(δ), that of the heights δ further up. It moves by the slope
///     s = [G(e) - G(-e)]/(2e),                                                                        (1)
/// which the field itself tells, whatever the distribution. At the ends of the interval, δ = ± 2e, it has
/// moved by G(δ) - G(0) - s δ besides, upwards or downwards: at an edge of the distribution, as that of a
/// population or a plateau, by as much as the share itself strays.
///
/// Symbols   G  share or density, linear between classes
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "stats/uncertainty/share_error.hpp"

namespace asperity {

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
    Frequency out{of.mean(), of.error(), points};
    if (!(of_mean_ > 0)) return out;
    const double here = G(0), above = G(of_mean_), under = G(-of_mean_),
                 slope = (above - under) / (2 * of_mean_);
    out.error = of.error(slope);
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

}  // namespace asperity
