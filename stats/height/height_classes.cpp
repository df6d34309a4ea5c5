#include "stats/height/height_classes.hpp"

#include <gsl/gsl_randist.h>

namespace asperity {
namespace {

constexpr double reach = 5;  // of the kernel, in bandwidths

}  // namespace

HeightClasses::HeightClasses(const Field& z, const Grid& grid, const FieldExtent& extent, const Range& range)
    : range_(range), errors_(grid, extent, range.classes) {
  const double width = range.width(), last = static_cast<double>(range.classes - 1);
  errors_.add(z, [&](double value) {
    return static_cast<Index>(std::clamp((value - range.lowest) / width, 0.0, last));
  });
}

SmoothDensity::SmoothDensity(const HeightClasses& classes, double bandwidth)
    : bandwidth_(bandwidth), range_(classes.range()) {
  const Index together = static_cast<Index>(
      std::clamp(bandwidth / (4 * range_.width()), 1.0, static_cast<double>(range_.classes)));
  shares_.resize(size((range_.classes + together - 1) / together));
  for (Index b = 0; b < range_.classes; ++b) shares_[size(b / together)] += classes.errors().share(b);
  const double width = range_.width() * static_cast<double>(together);
  range_.classes = static_cast<Index>(shares_.size());
  range_.highest = range_.lowest + width * static_cast<double>(shares_.size());
}

double SmoothDensity::operator()(double height) const {
  double sum = 0;
  range_.for_each_near(height, reach * bandwidth_, [&](Index b) {
    sum += shares_[size(b)] * gsl_ran_gaussian_pdf(height - range_.centre(b), bandwidth_);
  });
  return sum;
}

double SmoothDensity::slope(double height) const {
  double sum = 0;
  range_.for_each_near(height, reach * bandwidth_, [&](Index b) {
    const double d = (height - range_.centre(b)) / bandwidth_;
    sum -= shares_[size(b)] * d / bandwidth_ * gsl_ran_gaussian_pdf(d * bandwidth_, bandwidth_);
  });
  return sum;
}

}  // namespace asperity
