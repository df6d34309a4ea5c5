#include "stats/spectrum/leakage.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace asperity {
namespace {

// (1)
double leaked(Index n, DataWindow window) {
  const double square = static_cast<double>(n * n), pi2 = std::numbers::pi * std::numbers::pi;
  if (window == DataWindow::none) return n == 0 ? 0 : 1 / (2 * pi2 * square);
  return square < 4 ? 0 : 1 / (3 * pi2 * square * (square - 1) * (square - 1));
}

}  // namespace

void withhold_leakage(std::vector<SpectrumPoint>& points, Index first, DataWindow window) {
  constexpr double most = 0.25;
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
