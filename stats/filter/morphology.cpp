#include "stats/filter/morphology.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/words.hpp"

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

  // (2) of row i: the nearest rows first, so that most others lie too low.
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

}  // namespace asperity
