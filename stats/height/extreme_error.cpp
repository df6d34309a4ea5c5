#include "stats/height/extreme_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace asperity {
namespace {

constexpr std::size_t summits_apart = 6;

struct HighPoint {
  double height;
  Index i, j;
};

// Whether no neighbour is higher; missing ones are not.
bool is_highest(const Field& z, const Grid& grid, Index i, Index j) {
  const auto [nx, ny] = grid.shape;
  for (Index p = i - 1; p <= i + 1; ++p)
    for (Index q = j - 1; q <= j + 1; ++q) {
      const Index row = grid.periodic.x ? (p + nx) % nx : p, column = grid.periodic.y ? (q + ny) % ny : q;
      if (row >= 0 && row < nx && column >= 0 && column < ny && z(row, column) > z(i, j)) return false;
    }
  return true;
}

// The highest first.
std::vector<HighPoint> highest_maxima(const Field& z, const Grid& grid) {
  constexpr std::size_t most = 600;
  std::vector<HighPoint> out;
  auto higher = [](const HighPoint& a, const HighPoint& b) { return a.height > b.height; };
  for (Index i = 0; i < z.rows(); ++i)
    for (Index j = 0; j < z.cols(); ++j) {
      const bool candidate = z(i, j) > 0 && (out.size() < most || z(i, j) > out.front().height);
      if (!candidate || !is_highest(z, grid, i, j)) continue;
      out.push_back({z(i, j), i, j});
      std::ranges::push_heap(out, higher);  // the lowest is the front
      if (out.size() > most) std::ranges::pop_heap(out, higher), out.pop_back();
    }
  std::ranges::sort(out, higher);
  return out;
}

double apart(Index a, Index b, Index n, bool periodic) {
  const Index distance = std::abs(a - b);
  return static_cast<double>(periodic ? std::min(distance, n - distance) : distance);
}

std::vector<HighPoint> summits_of(const Field& z, const Grid& grid, double length_x, double length_y) {
  std::vector<HighPoint> out;
  for (const HighPoint& one : highest_maxima(z, grid)) {
    auto beside = [&](const HighPoint& other) {
      return std::hypot(apart(one.i, other.i, grid.shape.nx, grid.periodic.x) / (2 * length_x),
                        apart(one.j, other.j, grid.shape.ny, grid.periodic.y) / (2 * length_y)) < 1;
    };
    if (std::ranges::none_of(out, beside)) out.push_back(one);
    if (out.size() == summits_apart) break;
  }
  return out;
}

// (1), of some function of the heights.
template <class Of>
double scale_of_tail(const std::vector<HighPoint>& summits, Of of) {
  double mean = 0;
  for (std::size_t k = 0; k + 1 < summits_apart; ++k) mean += of(summits[k].height) / (summits_apart - 1);
  return mean - of(summits.back().height);
}

}  // namespace

std::optional<ExtremeError> extreme_error(const Field& heights, const Grid& grid, double length_x,
                                          double length_y, double error_of_mean) {
  constexpr double spread = 0.9, low = 1.89, high = 5.14, heaviest = 0.6, t_of_mean = 2.2;
  const std::vector<HighPoint> summits = summits_of(heights, grid, length_x, length_y);
  if (summits.size() < summits_apart) return std::nullopt;
  const double x = summits.front().height, a = scale_of_tail(summits, [](double height) { return height; }),
               relative = scale_of_tail(summits, [](double height) { return std::log(height); }),
               power = std::min(relative, heaviest);
  if (!(a > 0)) return std::nullopt;  // equal heights
  const double of_mean = t_of_mean * error_of_mean;
  return ExtremeError{std::hypot(spread * x * relative, error_of_mean),
                      Interval::of(x, std::min(x - std::hypot(low * a, of_mean), x * std::exp(-low * power)),
                                   std::max(x + std::hypot(high * a, of_mean), x * std::exp(high * power)))};
}

}  // namespace asperity
