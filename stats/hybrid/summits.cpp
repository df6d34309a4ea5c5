#include "stats/hybrid/summits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/error.hpp"
#include "stats/filter/form.hpp"
#include "stats/hybrid/neighbours.hpp"

namespace asperity {
namespace {

// A field followed by its first two rows, and its first two columns, where it repeats.
Field extended(const Field& z, Periodic periodic) {
  const Index nx = z.rows(), ny = z.cols();
  if (!periodic.any()) return z;
  return Field::NullaryExpr(nx + 2 * periodic.x, ny + 2 * periodic.y,
                            [&](Index i, Index j) { return z(i % nx, j % ny); });
}

class SummitFinder {
 public:
  SummitFinder(const Field& z, const Grid& grid, bool profile, double rounding)
      : grid_(grid),
        profile_(profile),
        periodic_(profile ? grid.periodic.x : grid.periodic.both()),
        first_column_(profile ? 0 : 1),
        z_(extended(z, {periodic_, periodic_ && !profile})),
        level_(rounding > 0 ? Field((z_ / rounding).round()) : z_) {
    const Index row = z_.cols();
    sides_ = profile ? std::vector<Index>{-row, row} : std::vector<Index>{-1, 1, -row, row};
    neighbours_ = sides_;
    if (!profile) neighbours_.insert(neighbours_.end(), {-row - 1, -row + 1, row - 1, row + 1});
  }

  SummitRows find() {
    SummitRows out(size(std::max<Index>(0, z_.rows() - 2)));
    for (Index i = 1; i + 1 < z_.rows(); ++i)
      for (Index j = first_column_; j + first_column_ < z_.cols(); ++j) {
        const Index at = i * z_.cols() + j;
        if (!highest(at)) continue;
        if (has_equal(at))
          add_candidate(at);
        else
          out[size(i - 1)].push_back({j - first_column_, z_.data()[at], curvature(at)});
      }
    for (std::size_t k = 0; k < candidates_.size(); ++k)
      if (const Index at = candidates_[k].at; !candidates_[k].seen)
        if (const auto plateau = flood(k)) out[size(at / z_.cols() - 1)].push_back(*plateau);
    return out;
  }

 private:
  // A point without a higher or a missing neighbour, but with equal ones; x and y count the periods from the
  // point at which its plateau was entered.
  struct Candidate {
    Index at, x = 0, y = 0;
    bool seen = false;
  };
  static constexpr Index none = -1;

  double level(Index at) const { return level_.data()[at]; }
  bool highest(Index at) const {
    return std::ranges::all_of(neighbours_, [&](Index to) { return level(at) >= level(at + to); });
  }
  bool has_equal(Index at) const {
    return std::ranges::any_of(neighbours_, [&](Index to) { return level(at) == level(at + to); });
  }
  // (1), or that of a profile.
  double curvature(Index at) const {
    const double *z = z_.data() + at, twice = 2 * *z;
    const Index row = z_.cols();
    const double along_x = (twice - z[-row] - z[row]) / (grid_.dx * grid_.dx);
    return profile_ ? along_x : 0.5 * (along_x + (twice - z[-1] - z[1]) / (grid_.dy * grid_.dy));
  }
  void add_candidate(Index at) {
    if (number_.empty()) number_.assign(size(z_.size()), none);
    number_[size(at)] = std::ssize(candidates_);
    candidates_.push_back({at});
  }
  // A neighbour of a candidate at its place among the points that are visited, in the period that it is in.
  Candidate neighbour(Index at, const Candidate& from) const {
    if (!periodic_) return {at, 0, 0};
    const auto [nx, ny] = grid_.shape;
    const Index i = at / z_.cols(), j = at % z_.cols(), x = i < 1 ? -1 : i > nx,
                y = profile_ || (1 <= j && j <= ny) ? 0
                    : j < 1                         ? -1
                                                    : 1;
    return {at - (x * nx * z_.cols() + y * ny), from.x + x, from.y + y};
  }
  // The plateau of a candidate, if all around it is lower and it does not meet itself a period away.
  std::optional<FoundSummit> flood(std::size_t first) {
    bool closed = true;
    double points = 0, curvatures = 0, sides = 0;
    std::vector<Index> open{static_cast<Index>(first)};
    candidates_[first].seen = true;
    while (!open.empty()) {
      const Candidate here = candidates_[size(open.back())];
      open.pop_back();
      points += 1, curvatures += curvature(here.at);
      for (const Index to : sides_) sides += level(here.at + to) < level(here.at);
      for (const Index to : neighbours_) {
        if (level(here.at + to) != level(here.at)) continue;
        Candidate next = neighbour(here.at + to, here);
        const Index number = number_[size(next.at)];
        if (number == none) {  // it has a higher or a missing neighbour
          closed = false;
          continue;
        }
        Candidate& known = candidates_[size(number)];
        closed &= !known.seen || (known.x == next.x && known.y == next.y);
        if (known.seen) continue;
        next.seen = true;
        known = next;
        open.push_back(number);
      }
    }
    if (!closed || sides == 0) return std::nullopt;
    const Index at = candidates_[first].at;
    return FoundSummit{at % z_.cols() - first_column_, z_.data()[at],
                       static_cast<double>(sides_.size()) * curvatures / (sides * extent(points)), points};
  }
  // a of (2).
  double extent(double n) const {
    return profile_ ? 1 + (n * n - 1) / 2 : 1 + 2 * std::numbers::inv_pi * (n - 1);
  }

  Grid grid_;
  bool profile_, periodic_;
  Index first_column_;                     // that is visited
  Field z_, level_;                        // extended
  std::vector<Index> sides_, neighbours_;  // from one point to others
  std::vector<Candidate> candidates_ = {};
  std::vector<Index> number_ = {};  // of the candidate at a point, or none
};

enum SummitSum { neighbourhoods, heights, squares, curvatures, plateaus };

// Points of the second of three rows of which all nine are there.
double complete(const Row& three) {
  const Index columns = std::max<Index>(0, three.size() - 2);
  return sum_of_valid(three.head(columns) + three.segment(1, columns) + three.tail(columns)).count;
}

void add_to(ValidSum& sum, double value) {
  sum.sum += value;
  sum.count += 1;
}

}  // namespace

SummitRows find_summits(const Field& z, const Grid& grid, double rounding) {
  return SummitFinder(z, grid, false, rounding).find();
}

SummitRows find_peaks(const Field& column, double step, bool periodic) {
  return SummitFinder(column, {shape_of(column), step, step, periodic}, true, 0).find();
}

CountedSummits counted_summits(const Field& z, const Grid& grid, double rounding, int threads) {
  const NeighbourRows rows(z, grid, 2);
  const SummitRows found = find_summits(z, grid, rounding);
  const double level = mean(z);
  const RowSums<5> sums = sum_rows<5>(rows.rows(), threads, [&](Index i) {
    RowSums<5> out{};
    out[neighbourhoods].count = complete(rows(i) + rows(i + 1) + rows(i + 2));
    for (const FoundSummit& summit : found[size(i)]) {
      const double height = summit.height - level;
      add_to(out[heights], height);
      add_to(out[squares], height * height);
      add_to(out[curvatures], summit.curvature);
      if (summit.points > 1) add_to(out[plateaus], summit.points);
    }
    return out;
  });
  if (!(sums[neighbourhoods].count > 0))
    throw DataError("heights", "summits need 3 x 3 points, none of them missing");
  CountedSummits out;
  out.count = sums[heights].count;
  out.plateaus = sums[plateaus].count;
  if (out.plateaus > 0) out.width = std::sqrt(mean_of(sums[plateaus]));
  out.points = sums[neighbourhoods].count;
  out.density = out.count / (out.points * grid.cell_area());
  if (out.count == 0) return out;
  out.mean_height = mean_of(sums[heights]);
  out.height_deviation = std::sqrt(std::max(0.0, mean_of(sums[squares]) - out.mean_height * out.mean_height));
  out.mean_curvature = mean_of(sums[curvatures]);
  return out;
}

Summits expected_summits(const ProfileSpectralMoments& m) {
  using std::numbers::pi, std::numbers::sqrt3;
  const double alpha = m.bandwidth(), density = m.m4 / (6 * pi * sqrt3 * m.m2);
  if (!(density > 0)) return {.density = density};
  return {.density = density,
          .mean_height = 4 * std::sqrt(m.m0 / (pi * alpha)),
          .height_deviation = std::sqrt(m.m0 * (1 - (1 + 16 / pi - 3 * sqrt3) / alpha)),
          .mean_curvature = 8 * std::sqrt(m.m4 / pi) / 3};
}

}  // namespace asperity
