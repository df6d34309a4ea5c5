#include "acf/radial.hpp"

#include <cmath>

#include "math/bracketed_root.hpp"

namespace asperity {

QuinticTable::QuinticTable(double first, double step, const std::vector<Node>& nodes)
    : first_(first), step_(step) {
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const double f0 = nodes[i][0], d0 = step * nodes[i][1], s0 = step * step * nodes[i][2];
    const double f1 = nodes[i + 1][0], d1 = step * nodes[i + 1][1], s1 = step * step * nodes[i + 1][2];
    const double rise = f1 - f0;
    pieces_.push_back({f0, d0, s0 / 2, 10 * rise - 6 * d0 - 4 * d1 - 1.5 * s0 + 0.5 * s1,
                       -15 * rise + 8 * d0 + 7 * d1 + 1.5 * s0 - s1,
                       6 * rise - 3 * d0 - 3 * d1 - 0.5 * s0 + 0.5 * s1});
  }
}

double falls_to(const std::function<double(double)>& correlation, double t) {
  auto excess = [&](double log_r) { return correlation(std::exp(log_r)) - t; };
  double low = std::log(0.01), high = low;
  while (excess(high) > 0) low = high, high += 0.1;
  while (!(excess(low) > 0)) {
    if (low < std::log(1e-300)) return 0;
    high = low, low -= 2;
  }
  return std::exp(bracketed_root(excess, {low, excess(low)}, {high, excess(high)}, 0));
}

}  // namespace asperity
