#include "stats/summits.hpp"

#include <cmath>
#include <numbers>

#include "grid/error.hpp"
#include "stats/form.hpp"
#include "stats/neighbours.hpp"

namespace asperity {
namespace {

enum Sum { number, heights, squares, curvatures, sums };
using Sums = RowSums<sums>;

struct Neighbourhood {
  const Row &before, &here, &after;

  bool summit(Index j) const {
    const double z = here(j);
    return z > here(j - 1) && z > here(j + 1) && z > before(j) && z > after(j) && z > before(j - 1) &&
           z > before(j + 1) && z > after(j - 1) && z > after(j + 1);
  }
  double curvature(Index j, const Grid& grid) const {
    const double twice = 2 * here(j);
    return 0.5 * ((twice - before(j) - after(j)) / (grid.dx * grid.dx) +
                  (twice - here(j - 1) - here(j + 1)) / (grid.dy * grid.dy));
  }
};

}  // namespace

CountedSummits counted_summits(const Field& z, const Grid& grid, int threads) {
  const NeighbourRows rows(z, grid, 2);
  if (rows.rows() < 1 || rows.columns() < 1) throw DataError("heights", "summits need 3 x 3 points");
  const double level = mean(z);
  const Sums sum = sum_over_rows<sums>(rows.rows(), threads, [&](Index i) {
    const Row before = rows(i), here = rows(i + 1), after = rows(i + 2);
    const Neighbourhood around{before, here, after};
    Sums out{};
    for (Index j = 1; j <= rows.columns(); ++j)
      if (around.summit(j)) {
        const double height = here(j) - level;
        out[number] += 1;
        out[heights] += height;
        out[squares] += height * height;
        out[curvatures] += around.curvature(j, grid);
      }
    return out;
  });
  CountedSummits out;
  if (sum[number] == 0) return out;
  const double n = out.count = sum[number];
  out.density = n / (static_cast<double>(rows.rows() * rows.columns()) * grid.cell_area());
  out.mean_height = sum[heights] / n;
  out.height_deviation = std::sqrt(std::max(0.0, sum[squares] / n - out.mean_height * out.mean_height));
  out.mean_curvature = sum[curvatures] / n;
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
