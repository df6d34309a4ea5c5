#include "stats/spectrum/pooled_degrees.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

constexpr double left_by_chance = 1.5;

double relative_variance(const SpectrumPoint& p) { return std::pow(p.standard_error / p.density, 2); }

// ū at point i; the point of the mean height, which is not one of the others, alone.
double pooled(const std::vector<SpectrumPoint>& points, Index i, PointKind kind) {
  const Index first = kind == PointKind::ring ? 1 : 0, k = first + i;
  if (k == 0) return relative_variance(points.front());
  const Index h = pooled_reach(k), from = std::max<Index>(k - h, 1) - first,
              to = std::min(i + h, static_cast<Index>(points.size()) - 1);
  double sum = 0;
  for (Index j = from; j <= to; ++j) {
    const double share =
        kind == PointKind::ring ? static_cast<double>(first + j) / static_cast<double>(k) : 1;
    sum += share * relative_variance(points[static_cast<std::size_t>(j)]);
  }
  return sum / static_cast<double>(to - from + 1);
}

}  // namespace

void pool_degrees(std::vector<SpectrumPoint>& points, PointKind kind) {
  std::vector<double> all(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) all[i] = pooled(points, static_cast<Index>(i), kind);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(all[i])) continue;  // a density of zero is near
    const double from_mean = std::max(2 / all[i] - 2, 0.0);
    const double degrees =
        std::max(from_mean * from_mean / (from_mean + left_by_chance), std::min(from_mean, 2.0));
    points[i].degrees = degrees;
    points[i].standard_error = points[i].density * std::sqrt(2 / (degrees + 2));
  }
}

}  // namespace asperity
