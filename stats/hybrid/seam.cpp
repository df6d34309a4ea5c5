#include "stats/hybrid/seam.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

constexpr Index least_lines = 16;
constexpr double rounding = 1e-12;  // of the largest height, no step

template <class Line>
Seam seam(Index lines, double largest_height, Line line) {
  if (lines < least_lines) return {};
  auto step = [&](Index from, Index to) { return std::sqrt((line(to) - line(from)).square().mean()); };
  Seam out{step(lines - 1, 0)};
  if (out.step <= rounding * largest_height) return {};
  for (Index i = 0; i + 1 < lines; ++i) out.largest = std::max(out.largest, step(i, i + 1));
  return out;
}

}  // namespace

std::array<Seam, 2> seams(const Field& heights, Periodic periodic) {
  const double largest = periodic.any() ? heights.abs().maxCoeff() : 0;
  std::array<Seam, 2> out;
  if (periodic.x) out[0] = seam(heights.rows(), largest, [&](Index i) { return heights.row(i); });
  if (periodic.y) out[1] = seam(heights.cols(), largest, [&](Index j) { return heights.col(j); });
  return out;
}

}  // namespace asperity
