#include "stats/spectrum/pooled_degrees.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

constexpr double left_by_chance = 1.5;
constexpr double most_bias = 0.5;  // relative errors

struct Range {
  Index first, last;
};

// The neighbours of point i, with it; the mean height is not one of the others'.
Range neighbours(Index i, Index count, PointKind kind) {
  const Index first = kind == PointKind::ring ? 1 : 0, k = first + i, reach = 1 + k / 8;
  if (k == 0) return {0, 0};
  return {std::max<Index>(k - reach, 1) - first, std::min(i + reach, count - 1)};
}

double relative_variance(const SpectrumPoint& p) { return std::pow(p.standard_error / p.density, 2); }

// ū at point i; the point of the mean height, which is not one of the others, alone.
double pooled(const std::vector<SpectrumPoint>& points, Index i, PointKind kind) {
  const Index first = kind == PointKind::ring ? 1 : 0, k = first + i;
  const auto [from, to] = neighbours(i, std::ssize(points), kind);
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

std::vector<double> pooled_bias(const std::vector<double>& once_more, const std::vector<double>& densities,
                                PointKind kind) {
  const Index count = std::ssize(densities);
  Eigen::ArrayXd single(count);
  for (Index i = 0; i < count; ++i) {
    const double b =
        std::log(once_more[static_cast<std::size_t>(i)] / densities[static_cast<std::size_t>(i)]);
    single(i) = std::isnan(b) ? 0 : std::clamp(b, -2.0, 2.0);
  }
  std::vector<double> out;
  for (Index i = 0; i < count; ++i) {
    const auto [from, to] = neighbours(i, count, kind);
    out.push_back(single.segment(from, to - from + 1).mean());
  }
  return out;
}

bool hidden_by(double bias, const SpectrumPoint& point) {
  return std::abs(bias) * point.density > most_bias * point.standard_error;
}

}  // namespace asperity
