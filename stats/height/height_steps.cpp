#include "stats/height/height_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

constexpr double same = 1e-6, most_steps = 1e5;  // of the range
constexpr double near = 50;                      // steps that a first estimate counts well
constexpr double off = 0.1;                      // of a step

// Runs apart by more than the least difference are different values.
std::vector<double> different(const std::vector<HeightRun>& runs) {
  std::vector<double> out;
  if (runs.empty()) return out;
  const double least = same * (runs.back().height - runs.front().height);
  for (const auto& [count, height] : runs)
    if (out.empty() || height - out.back() > least) out.push_back(height);
  return out;
}

}  // namespace

std::vector<HeightRun> runs_of_equal(const Field& z) {
  std::vector<double> sorted(z.data(), z.data() + z.size());
  std::erase_if(sorted, [](double height) { return !std::isfinite(height); });
  std::ranges::sort(sorted);
  std::vector<HeightRun> out;
  for (const double height : sorted)
    if (!out.empty() && out.back().height == height)
      ++out.back().count;
    else
      out.push_back({1, height});
  return out;
}

HeightSteps height_steps(const std::vector<HeightRun>& runs) {
  const std::vector<double> values = different(runs);
  HeightSteps out{.values = std::ssize(values), .lowest = values.empty() ? NAN : values.front()};
  double points = 0;
  for (const HeightRun& run : runs) points += run.count;
  if (values.size() < 2 || static_cast<double>(values.size()) > 0.5 * points) return out;
  std::vector<double> gaps;
  for (std::size_t k = 1; k < values.size(); ++k) gaps.push_back(values[k] - values[k - 1]);
  const double least = *std::ranges::min_element(gaps);
  double length = 0, count = 0, steps = 0;
  for (const double gap : gaps)
    if (gap < near * least) length += gap, count += std::round(gap / least);
  const double step = length / count;
  for (const double gap : gaps) {
    if (!(std::abs(gap / step - std::round(gap / step)) <= off)) return out;
    steps += std::round(gap / step);
  }
  if (steps > most_steps) return out;
  out.step = (values.back() - values.front()) / steps;
  out.steps = static_cast<Index>(steps);
  return out;
}

double neighbour_step(const Field& z) {
  double equal = 0, pairs = 0, least = std::numeric_limits<double>::infinity();
  auto add_pair = [&](double a, double b) {
    const double difference = std::abs(a - b);
    if (std::isnan(difference)) return;
    ++pairs;
    if (difference > 0)
      least = std::min(least, difference);
    else
      ++equal;
  };
  for (Index i = 0; i < z.rows(); ++i)
    for (Index j = 0; j < z.cols(); ++j) {
      if (i > 0) add_pair(z(i, j), z(i - 1, j));
      if (j > 0) add_pair(z(i, j), z(i, j - 1));
    }
  return equal > 0.01 * pairs && std::isfinite(least) ? least : 0;
}

Bins bins_on_steps(const HeightSteps& of, const Bins& wanted) {
  const double width = wanted.range.width() / wanted.number,
               together = std::max(1.0, std::floor(width / of.step * (1 + 1e-9))),
               number = std::ceil(static_cast<double>(of.steps + 1) / together),
               first = of.lowest - 0.5 * of.step;
  return {static_cast<int>(number), {first, first + number * together * of.step}};
}

}  // namespace asperity
