#include "marginal/johnson_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/bracketed_root.hpp"

namespace asperity {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The y of (2) for the upper sign: of S_B where the left side crosses the right one from below.
std::vector<double> scores_of_peaks(const Johnson& j) {
  if (j.family == Johnson::Family::lognormal) return {-1 / j.delta};
  const double centre = std::abs(j.gamma), d = j.delta;
  auto rise = [&](double y) { return std::tanh((y - centre) / (2 * d)) - d * y; };
  auto root = [&](double a, double b) { return bracketed_root(rise, {a, rise(a)}, {b, rise(b)}, 1e-13); };
  // Where the right side's slope is that of the left, on both sides of the centre.
  const double steep = d * d < 0.5 ? 2 * d * std::acosh(1 / (std::sqrt(2.0) * d)) : 0;
  std::vector<double> out{root(-1 / d, centre - steep)};
  if (rise(centre + steep) > 0) out.push_back(root(centre + steep, 1 / d));
  return out;
}

}  // namespace

JohnsonShape shape_of(const Johnson& j) {
  const bool bounded = j.family == Johnson::Family::bounded;
  if (!bounded && j.family != Johnson::Family::lognormal) return {-infinity, infinity, {}};
  const double far = bounded ? j.slope * std::exp(std::abs(j.gamma) / j.delta) - j.offset : infinity;
  JohnsonShape out{-(j.slope + j.offset), far, {}};
  if (j.sign < 0) out = {-out.high, -out.low, {}};
  for (double y : scores_of_peaks(j)) out.peaks.push_back(j(j.sign * y));
  std::ranges::sort(out.peaks);
  return out;
}

}  // namespace asperity
