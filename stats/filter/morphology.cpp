#include "stats/filter/morphology.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/words.hpp"
#include "stats/filter/missing.hpp"

namespace asperity {
namespace {

constexpr double nothing = -std::numeric_limits<double>::infinity();  // where no point is

struct Axis {
  Index points;
  double step;
  bool periodic;

  bool holds(Index i) const { return periodic || (i >= 0 && i < points); }
  Index at(Index i) const { return ((i % points) + points) % points; }
  // How many points a length reaches; of a period no point twice in one direction.
  Index within(double length) const {
    const double count = std::floor(length / step * (1 + 1e-12));
    return static_cast<Index>(std::min(count, static_cast<double>(periodic ? points / 2 : points - 1)));
  }
};

// b, and how far it can matter to a field: beyond the reach it is lower than the range of heights.
class Element {
 public:
  Element(const Field& z, StructuringElement element)
      : ball_(element.kind == StructuringElement::Kind::ball),
        radius_(element.radius),
        reach_(element.radius) {
    const Field there = (z == nothing).select(z.maxCoeff(), z);
    if (const double range = there.maxCoeff() - there.minCoeff(); ball_ && range < radius_)
      reach_ = std::sqrt(range * (2 * radius_ - range)) * (1 + 1e-12);
  }

  double reach() const { return reach_; }
  bool covers(double square) const { return square <= radius_ * radius_ * (1 + 1e-15); }
  // At the square of a distance; no cancellation.
  double raised(double square) const {
    if (!ball_) return 0;
    return -square / (radius_ + std::sqrt(std::max(radius_ * radius_ - square, 0.0)));
  }
  // No less than 2b(y) - b(y + d) - b(y - d) of any y within the reach; infinite if y + d may leave the ball.
  double bend(double d) const {
    const double left = radius_ * radius_ - (reach_ + d) * (reach_ + d);
    if (!ball_ || !(reach_ + d < radius_)) return HUGE_VAL;
    return d * d * radius_ * radius_ / (left * std::sqrt(left));
  }

 private:
  bool ball_;
  double radius_, reach_;
};

// The points of a row that can be touched, in ascending order.
struct Row {
  std::vector<Index> place;
  std::vector<double> height;
  double top = nothing;
};

class Dilation {
 public:
  Dilation(const Field& z, const Grid& grid, StructuringElement element)
      : element_(z, element),
        x_{grid.shape.nx, grid.dx, grid.periodic.x},
        y_{grid.shape.ny, grid.dy, grid.periodic.y} {
    const Field thin = thinned(z);
    for (Index i = 0; i < x_.points; ++i) rows_.push_back(row_of(thin, i));
  }

  // (2) of row i: the nearest rows first, so that most others are too low.
  void row(Index i, Eigen::Ref<Eigen::ArrayXd> out) const {
    out.setConstant(nothing);
    const Index most = x_.within(element_.reach());
    for (Index k = 0; k <= most; ++k) {
      const double u = static_cast<double>(k) * x_.step, square = u * u;
      if (!element_.covers(square)) return;
      for (const Index from : {i + k, i - k}) {
        if (!x_.holds(from)) continue;
        const Row& row = rows_[size(x_.at(from))];
        if (row.place.empty() || row.top + element_.raised(square) <= out.minCoeff()) continue;
        raise(row, square, out);
        if (k == 0) break;
      }
    }
  }

 private:
  // Without the points that are never the maximum, for two others, d to both sides of one, are: where
  // z(p+d) + z(p-d) - 2z(p) exceeds what b bends.
  Field thinned(const Field& z) const {
    const double round_off =
        16 * std::numeric_limits<double>::epsilon() * (z == nothing).select(0, z).abs().maxCoeff();
    Field out = z;
    for (const auto& [p, q] : {std::array<Index, 2>{1, 0}, {0, 1}, {1, 1}, {1, -1}})
      for (Index k = 1; k <= std::max(x_.points, y_.points); k *= 2) {
        const double d = std::hypot(static_cast<double>(p * k) * x_.step,
                                    static_cast<double>(q * k) * y_.step),
                     bend = element_.bend(d) + round_off;
        if (!(d <= element_.reach()) || std::isinf(bend)) break;
        for (Index i = 0; i < x_.points; ++i) {
          if (!x_.holds(i - p * k) || !x_.holds(i + p * k)) continue;
          for (Index j = 0; j < y_.points; ++j) {
            if (!y_.holds(j - q * k) || !y_.holds(j + q * k)) continue;
            const double one = z(x_.at(i - p * k), y_.at(j - q * k)),
                         other = z(x_.at(i + p * k), y_.at(j + q * k));
            if (one + other - 2 * z(i, j) > bend) out(i, j) = nothing;
          }
        }
      }
    return out;
  }
  // With images of a period as far as the element reaches.
  Row row_of(const Field& z, Index i) const {
    Row out;
    const Index more = y_.periodic ? y_.within(element_.reach()) : 0;
    for (Index j = -more; j < y_.points + more; ++j)
      if (const double height = z(i, y_.at(j)); height != nothing) {
        out.place.push_back(j);
        out.height.push_back(height);
        out.top = std::max(out.top, height);
      }
    return out;
  }
  // What a row at the distance √square adds. b is concave, so that the point that decides moves on with j:
  // the maximum in the middle of a run bounds the points that can decide on either side.
  void raise(const Row& row, double square, Eigen::Ref<Eigen::ArrayXd> out) const {
    std::vector<double> b;
    for (Index d = 0; d <= y_.within(element_.reach()); ++d) {
      const double v = static_cast<double>(d) * y_.step, s = square + v * v;
      if (!element_.covers(s)) break;
      b.push_back(element_.raised(s));
    }
    raise(row, b, out, 0, y_.points, 0, std::ssize(row.place));
  }
  static void raise(const Row& row, const std::vector<double>& b, Eigen::Ref<Eigen::ArrayXd> out, Index begin,
                    Index end, Index first, Index last) {
    if (begin >= end || first >= last) return;
    const Index j = (begin + end) / 2, width = std::ssize(b);
    const auto places = row.place.begin();
    Index k = std::lower_bound(places + first, places + last, j - width + 1) - places, best = k;
    double highest = nothing;
    for (; k < last && row.place[size(k)] < j + width; ++k)
      if (const double value = row.height[size(k)] + b[size(std::abs(row.place[size(k)] - j))];
          value > highest)
        highest = value, best = k;
    out[j] = std::max(out[j], highest);
    raise(row, b, out, begin, j, first, std::min(best + 1, last));
    raise(row, b, out, j + 1, end, best, last);
  }

  Element element_;
  Axis x_, y_;
  std::vector<Row> rows_;
};

// The dilation of a field that is `nothing` where no point is.
Field dilated(const Field& z, const Grid& grid, StructuringElement element, int threads) {
  const Dilation dilation(z, grid, element);
  Field out(grid.shape.nx, grid.shape.ny);
  parallel_ranges(grid.shape.nx, threads, [&](Index begin, Index end, int) {
    Eigen::ArrayXd row(grid.shape.ny);
    for (Index i = begin; i < end; ++i) {
      dilation.row(i, row);
      out.row(i) = row.transpose();
    }
  });
  return out;
}

void check(StructuringElement element) {
  check_parameter(element.radius > 0 && std::isfinite(element.radius), "radius",
                  "'" + shortest(element.radius) + " m' is not above zero and finite");
}

}  // namespace

Field dilation(const Field& z, const Grid& grid, StructuringElement element, int threads) {
  check(element);
  return z.isNaN().select(NAN, dilated(z.isNaN().select(nothing, z), grid, element, threads));
}

Field erosion(const Field& z, const Grid& grid, StructuringElement element, int threads) {
  return -dilation(-z, grid, element, threads);
}

Field closing(const Field& z, const Grid& grid, StructuringElement element, int threads) {
  return erosion(dilation(z, grid, element, threads), grid, element, threads);
}

Field opening(const Field& z, const Grid& grid, StructuringElement element, int threads) {
  return dilation(erosion(z, grid, element, threads), grid, element, threads);
}

// ---- the median of a window ----

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
