#include "stats/spectrum/leakage.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace asperity {
namespace {

// (1), by the midpoint rule: W is smooth within a wave number.
double leaked(Index n, DataWindow window) {
  constexpr int nodes = 16;
  if (n < (window == DataWindow::none ? 1 : 2)) return 0;
  double sum = 0;
  for (int i = 0; i < nodes; ++i) {
    const double f = static_cast<double>(n) - 0.5 + (i + 0.5) / nodes,
                 sinc = std::sin(std::numbers::pi * f) / (std::numbers::pi * f);
    sum += std::pow(window == DataWindow::none ? sinc : sinc / (1 - f * f), 2);
  }
  return sum / nodes / (window == DataWindow::none ? 1 : 1.5);
}

}  // namespace

void withhold_leakage(std::vector<SpectrumPoint>& points, Index first, DataWindow window) {
  const double most = window == DataWindow::none ? 0.3 : 0.1;
  const auto count = static_cast<Index>(points.size());
  std::vector<double> share;
  for (Index n = 0; n <= 2 * (first + count); ++n) share.push_back(leaked(n, window));
  auto kappa = [&](Index n) { return share[static_cast<std::size_t>(std::abs(n))]; };
  std::vector<double> leakage;
  for (Index k = first; k < first + count; ++k) {
    double sum = 0;
    for (Index j = first; j < first + count; ++j)
      sum +=
          points[static_cast<std::size_t>(j - first)].density * (kappa(k - j) + (j > 0 ? kappa(k + j) : 0));
    leakage.push_back(sum);
  }
  for (std::size_t k = 0; k < points.size(); ++k)
    if (leakage[k] > most * points[k].density)
      points[k].standard_error = points[k].degrees = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace asperity
