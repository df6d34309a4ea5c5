#include "stats/height/height_runs.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace asperity {

HeightCells::HeightCells(const Moments& moments, Index cells)
    : mean_(moments.mean), sa_(moments.sa), cells_(static_cast<std::size_t>(cells)) {}

// Each operation is monotone when rounded, so that no height lands in a cell beyond a higher one's.
std::size_t HeightCells::cell(double height) const {
  const double x = (height - mean_) / sa_, t = std::copysign(1 - 1 / (1 + std::abs(x)), x);
  const auto index = static_cast<std::size_t>(0.5 * (1 + t) * static_cast<double>(cells_.size()));
  return std::min(index, cells_.size() - 1);
}

void HeightCells::add(const Field& strip) {
  for (const double height : strip.reshaped<Eigen::RowMajor>()) {
    if (std::isnan(height)) continue;
    HeightRun& run = cells_[cell(height)];
    run.lowest = run.count > 0 ? std::min(run.lowest, height) : height;
    run.highest = run.count > 0 ? std::max(run.highest, height) : height;
    ++run.count;
  }
}

std::vector<HeightRun> HeightCells::runs() const {
  std::vector<HeightRun> out;
  std::ranges::copy_if(cells_, std::back_inserter(out), [](const HeightRun& run) { return run.count > 0; });
  return out;
}

}  // namespace asperity
