#include "stats/hybrid/summits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace asperity {
namespace {

enum Sum { neighbourhoods, heights, squares, curvatures };
using Sums = RowSums<4>;

struct Neighbourhood {
  const Row &before, &here, &after;

  bool summit(Index j) const {
    const double z = here(j);
    return z > here(j - 1) && z > here(j + 1) && z > before(j) && z > after(j) && z > before(j - 1) &&
           z > before(j + 1) && z > after(j - 1) && z > after(j + 1);
  }
  // Points of the row of which all nine are there.
  double complete() const {
    const Index columns = here.size() - 2;
    if (!std::isnan((before + here + after).sum())) return static_cast<double>(columns);
    const Row three = before + here + after;
    return sum_of_valid(three.head(columns) + three.segment(1, columns) + three.tail(columns)).count;
  }
  double curvature(Index j, const Grid& grid) const {
    const double twice = 2 * here(j);
    return 0.5 * ((twice - before(j) - after(j)) / (grid.dx * grid.dx) +
                  (twice - here(j - 1) - here(j + 1)) / (grid.dy * grid.dy));
  }
};

void add_to(ValidSum& sum, double value) {
  sum.sum += value;
  sum.count += 1;
}

}  // namespace

void SummitSums::add(const Strip& strip, double level, int threads) {
  const NeighbourRows rows(strip, 2);
  const Index columns = rows.columns();
  add_rows(sums_, rows.rows(), threads, [&](Index i) {
    const Row before = rows(i), here = rows(i + 1), after = rows(i + 2);
    const Neighbourhood around{before, here, after};
    Sums out{};
    out[neighbourhoods].count = around.complete();
    for (Index j = 1; j <= columns; ++j)
      if (around.summit(j)) {
        const double height = here(j) - level;
        add_to(out[heights], height);
        add_to(out[squares], height * height);
        add_to(out[curvatures], around.curvature(j, strip.grid));
      }
    return out;
  });
}

CountedSummits SummitSums::summits(const Grid& grid) const {
  if (!(sums_[neighbourhoods].count > 0))
    throw DataError("heights", "summits need 3 x 3 points, none of them missing");
  CountedSummits out;
  out.count = sums_[heights].count;
  if (out.count == 0) return out;
  out.density = out.count / (sums_[neighbourhoods].count * grid.cell_area());
  out.mean_height = mean_of(sums_[heights]);
  out.height_deviation =
      std::sqrt(std::max(0.0, mean_of(sums_[squares]) - out.mean_height * out.mean_height));
  out.mean_curvature = mean_of(sums_[curvatures]);
  return out;
}

Summits expected_summits(const ProfileSpectralMoments& m) {
  using std::numbers::pi, std::numbers::sqrt3;
  const double alpha = m.bandwidth();
  return {.density = m.m4 / (6 * pi * sqrt3 * m.m2),
          .mean_height = 4 * std::sqrt(m.m0 / (pi * alpha)),
          .height_deviation = std::sqrt(m.m0 * (1 - (1 + 16 / pi - 3 * sqrt3) / alpha)),
          .mean_curvature = 8 * std::sqrt(m.m4 / pi) / 3};
}

}  // namespace asperity
