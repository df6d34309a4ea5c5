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

Field maxima_of_pairs(const Field& fine) {
  Field out((fine.rows() + 1) / 2, (fine.cols() + 1) / 2);
  for (Index i = 0; i < out.rows(); ++i)
    for (Index j = 0; j < out.cols(); ++j)
      out(i, j) = fine.block(2 * i, 2 * j, std::min<Index>(2, fine.rows() - 2 * i),
                             std::min<Index>(2, fine.cols() - 2 * j))
                      .maxCoeff();
  return out;
}

// One axis: distances from a point to runs of points.
struct Axis {
  Index points;
  double step;
  bool periodic;

  // From i to the nearest point of first … last, by the shorter way round a period.
  double to_run(Index i, Index first, Index last) const {
    Index d = std::max<Index>({first - i, i - last, 0});
    if (periodic && d > 0) d = std::min(d, i < first ? i + points - last : first + points - i);
    return static_cast<double>(d) * step;
  }
};

// max_d z(x + d) + b(d) at one point after the other.
class Search {
 public:
  Search(const std::vector<Field>& levels, const Grid& grid, StructuringElement element)
      : levels_(levels),
        x_{grid.shape.nx, grid.dx, grid.periodic.x},
        y_{grid.shape.ny, grid.dy, grid.periodic.y},
        ball_(element.kind == StructuringElement::Kind::ball),
        radius_(element.radius) {}

  // The point that decided the neighbour's maximum is a good guess. The maximum does not depend on it.
  double at(Index i, Index j) {
    i_ = i, j_ = j, best_ = nothing;
    consider(guess_[0], guess_[1]);
    consider(i, j);
    descend(std::ssize(levels_) - 1, 0, 0);
    return best_;
  }

 private:
  // b at the square of a distance; no cancellation.
  double raised(double square) const {
    if (!ball_) return 0;
    return -square / (radius_ + std::sqrt(std::max(radius_ * radius_ - square, 0.0)));
  }
  bool beyond(double square) const { return square > radius_ * radius_; }
  // Whether nothing of this height, or lower, at this distance or further can exceed the best: b(d) ≤ -t is
  // d² ≥ t (2r - t).
  bool hopeless(double height, double square) const {
    const double t = best_ - height;
    if (beyond(square)) return true;
    if (!ball_) return t >= 0;
    return t >= 0 && (t >= radius_ || square >= t * (2 * radius_ - t));
  }
  double square_to(Index level, Index p, Index q) const {
    const Index i = p << level, j = q << level, size = (Index{1} << level) - 1;
    const double u = x_.to_run(i_, i, std::min(i + size, x_.points - 1)),
                 v = y_.to_run(j_, j, std::min(j + size, y_.points - 1));
    return u * u + v * v;
  }
  void consider(Index i, Index j) {
    const double square = square_to(0, i, j), height = levels_[0](i, j);
    if (beyond(square) || height == nothing) return;
    if (const double value = height + raised(square); value > best_) best_ = value, guess_ = {i, j};
  }
  void descend(Index level, Index p, Index q) {
    if (level == 0) return consider(p, q);
    struct Child {
      Index p, q;
      double square;
    };
    const Field& below = levels_[size(level - 1)];
    std::array<Child, 4> children;
    std::size_t count = 0;
    for (Index a = 2 * p; a < std::min(2 * p + 2, below.rows()); ++a)
      for (Index b = 2 * q; b < std::min(2 * q + 2, below.cols()); ++b) {
        const double square = square_to(level - 1, a, b);
        if (!hopeless(below(a, b), square)) children[count++] = {a, b, square};
      }
    std::sort(children.begin(), children.begin() + static_cast<std::ptrdiff_t>(count),
              [](const Child& one, const Child& other) { return one.square < other.square; });
    for (std::size_t k = 0; k < count; ++k)
      if (!hopeless(below(children[k].p, children[k].q), children[k].square))
        descend(level - 1, children[k].p, children[k].q);
  }

  const std::vector<Field>& levels_;
  Axis x_, y_;
  bool ball_;
  double radius_;
  Index i_ = 0, j_ = 0;
  double best_ = nothing;
  std::array<Index, 2> guess_{};
};

// The dilation of a field that is `nothing` where no point is.
Field dilated(Field z, const Grid& grid, StructuringElement element, int threads) {
  std::vector<Field> levels{std::move(z)};
  while (levels.back().size() > 1) levels.push_back(maxima_of_pairs(levels.back()));
  Field out(grid.shape.nx, grid.shape.ny);
  parallel_ranges(grid.shape.nx, threads, [&](Index begin, Index end, int) {
    Search search(levels, grid, element);
    for (Index i = begin; i < end; ++i)
      for (Index j = 0; j < grid.shape.ny; ++j) out(i, j) = search.at(i, j);
  });
  return out;
}

Field eroded(const Field& z, const Grid& grid, StructuringElement element, int threads) {
  return -dilated(-z, grid, element, threads);
}

// Points that are missing touch nothing: -∞ for a dilation; the ball's centre may stand above them, unless it
// touches nothing there.
Field touching(const Field& z) { return z.isNaN().select(nothing, z); }
Field standing(const Field& z) { return (z == nothing).select(-nothing, z); }
Field missing_again(const Field& result, const Field& z) { return z.isNaN().select(NAN, result); }

void check(StructuringElement element) {
  check_parameter(element.radius > 0 && std::isfinite(element.radius), "radius",
                  "'" + shortest(element.radius) + " m' is not above zero and finite");
}

}  // namespace

Field dilation(const Field& z, const Grid& grid, StructuringElement element, int threads) {
  check(element);
  return missing_again(dilated(touching(z), grid, element, threads), z);
}

Field erosion(const Field& z, const Grid& grid, StructuringElement element, int threads) {
  return -dilation(-z, grid, element, threads);
}

Field closing(const Field& z, const Grid& grid, StructuringElement element, int threads) {
  check(element);
  const Field envelope = dilated(touching(z), grid, element, threads);
  return missing_again(eroded(standing(envelope), grid, element, threads), z);
}

Field opening(const Field& z, const Grid& grid, StructuringElement element, int threads) {
  return -closing(-z, grid, element, threads);
}

}  // namespace asperity
