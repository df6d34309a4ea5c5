#include "stats/filter/median_filter.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/words.hpp"
#include "stats/filter/missing.hpp"

namespace asperity {
namespace {

constexpr Index absent = -1;
using Ranks = Eigen::Array<Index, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// The heights in ascending order, and the place of each among them.
struct Order {
  std::vector<double> sorted;
  Ranks rank;

  explicit Order(const Field& z) : rank(Ranks::Constant(z.rows(), z.cols(), absent)) {
    std::vector<Index> points;
    for (Index k = 0; k < z.size(); ++k)
      if (!std::isnan(z(k))) points.push_back(k);
    std::ranges::sort(points, {}, [&](Index k) { return z(k); });
    for (const Index k : points) {
      rank(k) = std::ssize(sorted);
      sorted.push_back(z(k));
    }
  }
};

// A set of ranks: a bit each, and how many there are in every run of 2¹⁰.
class RankSet {
 public:
  explicit RankSet(Index most) : bits_(size(most / 64 + 1)), runs_(size(most / run + 1)) {}

  void add(Index rank) { change(rank, 1); }
  void remove(Index rank) { change(rank, -1); }
  Index count() const { return count_; }
  /// The k-th, from 0. Searches on from the run of the last answer.
  Index at(Index k) {
    for (; below_ > k; below_ -= runs_[size(present_)]) present_ -= 1;
    while (below_ + runs_[size(present_)] <= k) below_ += runs_[size(present_++)];
    Index left = k - below_, word = present_ * (run / 64);
    for (; std::popcount(bits_[size(word)]) <= left; ++word) left -= std::popcount(bits_[size(word)]);
    std::uint64_t rest = bits_[size(word)];
    while (left-- > 0) rest &= rest - 1;
    return word * 64 + std::countr_zero(rest);
  }

 private:
  static constexpr Index run = 1024;
  void change(Index rank, int by) {
    if (rank == absent) return;
    bits_[size(rank / 64)] ^= std::uint64_t{1} << (rank % 64);
    runs_[size(rank / run)] += by;
    if (rank / run < present_) below_ += by;
    count_ += by;
  }

  std::vector<std::uint64_t> bits_;
  std::vector<Index> runs_;
  Index count_ = 0, present_ = 0, below_ = 0;  // a run, and how many are in those before it
};

// The indices of a window about i along an axis of n points.
struct WindowAxis {
  Index n, half;
  bool periodic;

  bool holds(Index i) const { return periodic || (i >= 0 && i < n); }
  Index at(Index i) const { return (i + n) % n; }
};

class Medians {
 public:
  Medians(const Order& order, const Grid& grid, Shape window)
      : order_(order),
        x_{grid.shape.nx, window.nx / 2, grid.periodic.x},
        y_{grid.shape.ny, window.ny / 2, grid.periodic.y},
        set_(std::ssize(order.sorted)) {}

  // The medians about the points of row i.
  template <class Row>
  void row(Index i, Row out) {
    for (Index j = -y_.half; j < y_.half; ++j) column(i, j, &RankSet::add);
    for (Index j = 0; j < y_.n; ++j) {
      column(i, j + y_.half, &RankSet::add);
      out(j) = order_.rank(i, j) == absent ? NAN : median();
      column(i, j - y_.half, &RankSet::remove);
    }
    for (Index j = y_.n - y_.half; j < y_.n + y_.half; ++j) column(i, j, &RankSet::remove);
  }

 private:
  void column(Index i, Index j, void (RankSet::*change)(Index)) {
    if (!y_.holds(j)) return;
    for (Index k = i - x_.half; k <= i + x_.half; ++k)
      if (x_.holds(k)) (set_.*change)(order_.rank(x_.at(k), y_.at(j)));
  }
  double median() {
    const Index count = set_.count();
    const double low = order_.sorted[size(set_.at((count - 1) / 2))];
    return count % 2 == 1 ? low : (low + order_.sorted[size(set_.at(count / 2))]) / 2;
  }

  const Order& order_;
  WindowAxis x_, y_;
  RankSet set_;
};

Index largest_odd(Index n) { return n - 1 + n % 2; }

void check_side(Index points, Index n) {
  check_parameter(points >= 1 && points % 2 == 1 && points <= n, "median",
                  "a window of " + std::to_string(points) + " points: an odd number from 1 to " +
                      std::to_string(largest_odd(n)));
}

}  // namespace

Shape median_window(const Grid& grid, double width) {
  auto points = [width](double step, Index n) {
    const double half = std::floor(width / 2 / step * (1 + 1e-12));
    return std::min(2 * static_cast<Index>(std::min(half, static_cast<double>(n))) + 1, largest_odd(n));
  };
  const double least =
      2 * std::min(grid.shape.nx > 2 ? grid.dx : HUGE_VAL, grid.shape.ny > 2 ? grid.dy : HUGE_VAL);
  check_parameter(
      width * (1 + 1e-12) >= least && std::isfinite(width), "median",
      "'" + in_digits(width, 12) + " m' is not finite or below two samples, " + in_digits(least, 12) + " m");
  return {points(grid.dx, grid.shape.nx), points(grid.dy, grid.shape.ny)};
}

Field median_surface(const Field& z, const Grid& grid, Shape window, int threads) {
  check_side(window.nx, grid.shape.nx);
  check_side(window.ny, grid.shape.ny);
  const Order order(z);
  Field out(z.rows(), z.cols());
  parallel_ranges(z.rows(), threads, [&](Index begin, Index end, int) {
    Medians medians(order, grid, window);
    for (Index i = begin; i < end; ++i) medians.row(i, out.row(i));
  });
  return out;
}

}  // namespace asperity
