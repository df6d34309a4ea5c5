#include "stats/height/height_steps.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

constexpr double same = 1e-6, most_steps = 1e5;  // of the range
constexpr double near = 50;                      // steps that a first estimate counts well
constexpr double off = 0.1;                      // of a step

std::vector<double> different(const Field& z) {
  std::vector<double> out;
  for (const double v : z.reshaped<Eigen::RowMajor>())
    if (std::isfinite(v)) out.push_back(v);
  std::ranges::sort(out);
  if (out.empty()) return out;
  const double least = same * (out.back() - out.front());
  std::size_t last = 0;
  for (const double v : out)
    if (v - out[last] > least) out[++last] = v;
  out.resize(last + 1);
  return out;
}

}  // namespace

HeightSteps height_steps(const Field& z) {
  const std::vector<double> values = different(z);
  HeightSteps out{.values = std::ssize(values), .lowest = values.empty() ? NAN : values.front()};
  const double points = static_cast<double>(z.isFinite().count());
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

void NeighbourSteps::add(const Field& z) {
  auto add_pair = [this](double a, double b) {
    const double difference = std::abs(a - b);
    if (std::isnan(difference)) return;
    ++pairs_;
    if (difference > 0)
      least_ = std::min(least_, difference);
    else
      ++equal_;
  };
  for (Index i = 0; i < z.rows(); ++i)
    for (Index j = 0; j < z.cols(); ++j) {
      if (i > 0) add_pair(z(i, j), z(i - 1, j));
      if (j > 0) add_pair(z(i, j), z(i, j - 1));
    }
}

Bins bins_on_steps(const HeightSteps& of, const Bins& wanted) {
  const double width = wanted.range.width() / wanted.number,
               together = std::max(1.0, std::floor(width / of.step * (1 + 1e-9))),
               number = std::ceil(static_cast<double>(of.steps + 1) / together),
               first = of.lowest - 0.5 * of.step;
  return {static_cast<int>(number), {first, first + number * together * of.step}};
}

}  // namespace asperity
