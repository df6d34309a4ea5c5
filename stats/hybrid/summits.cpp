#include "stats/hybrid/summits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace asperity {
namespace {

enum Sum { neighbourhoods, heights, squares, curvatures, plateaus };
using Sums = RowSums<5>;

// Points of the second of three rows of which all nine are there.
double complete(const Row& three) {
  const Index columns = three.size() - 2;
  if (!std::isnan(three.sum())) return static_cast<double>(columns);
  return sum_of_valid(three.head(columns) + three.segment(1, columns) + three.tail(columns)).count;
}

void add_to(ValidSum& sum, double value) {
  sum.sum += value;
  sum.count += 1;
}

}  // namespace

void SummitSums::add(const Strip& strip, double level, int threads) {
  const NeighbourRows rows(strip, 2);
  const std::vector<FoundSummits> found = finder_.add(strip);
  add_rows(sums_, rows.rows(), threads, [&](Index i) {
    Sums out{};
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
}

CountedSummits SummitSums::summits(const Grid& grid) const {
  if (!(sums_[neighbourhoods].count > 0))
    throw DataError("heights", "summits need 3 x 3 points, none of them missing");
  CountedSummits out;
  out.count = sums_[heights].count;
  out.plateaus = sums_[plateaus].count;
  if (out.plateaus > 0) out.width = std::sqrt(mean_of(sums_[plateaus]));
  out.density = out.count / (sums_[neighbourhoods].count * grid.cell_area());
  if (out.count == 0) return out;
  out.mean_height = mean_of(sums_[heights]);
  out.height_deviation =
      std::sqrt(std::max(0.0, mean_of(sums_[squares]) - out.mean_height * out.mean_height));
  out.mean_curvature = mean_of(sums_[curvatures]);
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
