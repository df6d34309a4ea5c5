#include "stats/height/height_classes.hpp"

namespace asperity {

HeightClasses::HeightClasses(const Field& z, const Grid& grid, const FieldExtent& extent, const Range& range,
                             bool own_mean)
    : range_(range), errors_(grid, extent, range.classes) {
  const double width = range.width(), last = static_cast<double>(range.classes - 1);
  errors_.add(z, [&](double value) {
    return static_cast<Index>(std::clamp((value - range.lowest) / width, 0.0, last));
  });
  for (Index b = 0; b < range.classes; ++b) below_.push_back(below_.back() + errors_.share(b));
  if (own_mean) of_mean_ = ShareErrors::Function(errors_).error(1);
}

double HeightClasses::below(double height) const {
  const double place =
      std::clamp((height - range_.lowest) / range_.width(), 0.0, static_cast<double>(range_.classes));
  const auto b = std::min(static_cast<std::size_t>(place), below_.size() - 2);
  return below_[b] + (place - static_cast<double>(b)) * (below_[b + 1] - below_[b]);
}

}  // namespace asperity
