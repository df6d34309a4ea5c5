#include "stats/hybrid/derivative_error.hpp"

#include <algorithm>
#include <cmath>

#include "core/words.hpp"
#include "stats/filter/form.hpp"
#include "stats/hybrid/neighbours.hpp"

namespace asperity {
namespace {

// Columns of LocalSums, less the first: means of z, of products of derivatives, and at summits.
enum Local {
  first,
  s00,
  s20,
  s11,
  s02,
  s40,
  s31,
  s22,
  s13,
  s04,  // as in spectral_moments.cpp
  developed,
  summit,
  height,
  square,
  curvature,
  sloped,      // 1 where there are the slopes
  surrounded,  // 1 where there are all neighbours
  local
};

Derivatives derivatives(const Eigen::VectorXd& m, const Grid& grid) {
  Derivatives out;
  const double slopes = m(sloped), curvatures = m(surrounded);
  out.slopes = {.sdq = std::sqrt((m(s20) + m(s02)) / slopes), .sdr = m(developed) / slopes};
  out.moments = {m(s00) - m(first) * m(first), m(s20) / slopes,     m(s11) / slopes,     m(s02) / slopes,
                 m(s40) / curvatures,          m(s31) / curvatures, m(s22) / curvatures, m(s13) / curvatures,
                 m(s04) / curvatures};
  out.summits.density = m(summit) / curvatures / grid.cell_area();
  const double height_of = m(height) / m(summit);
  out.summits.mean_height = height_of - m(first);
  out.summits.height_deviation = std::sqrt(m(square) / m(summit) - height_of * height_of);
  out.summits.mean_curvature = m(curvature) / m(summit);
  return out;
}

// The local functions of the points that are a row and a column after those of `rows`.
class LocalDerivatives {
 public:
  LocalDerivatives(const Field& z, const Grid& grid)
      : rows_(z, grid, 2), grid_(grid), found_(find_summits(z, grid)), level_(mean(z)) {}

  Index rows() const { return rows_.rows(); }
  void operator()(Index i, LocalSums::Values& values) const {
    const Index n = rows_.columns();
    const Row before = rows_(i), here = rows_(i + 1), after = rows_(i + 2);
    auto left = [n](const Row& row) { return row.head(n); };
    auto middle = [n](const Row& row) { return row.segment(1, n); };
    auto right = [n](const Row& row) { return row.tail(n); };
    const double dx = grid_.dx, dy = grid_.dy;
    const Row zx = (middle(after) - middle(here)) / dx, zy = (right(here) - middle(here)) / dy,
              zxx = (middle(before) - 2 * middle(here) + middle(after)) / (dx * dx),
              zyy = (left(here) - 2 * middle(here) + right(here)) / (dy * dy),
              zxy = (right(after) - left(after) - right(before) + left(before)) / (4 * dx * dy),
              z = middle(here) - level_, g2 = zx.square() + zy.square();
    auto set = [&](Local a, const auto& row) { values.col(a + 1).head(n) = row.matrix().transpose(); };
    set(first, z), set(s00, z.square());
    // A point counts for none of what needs a neighbour that is missing.
    auto set_where = [&](const Row& there, Local a, const Row& row) {
      set(a, Row((there > 0).select(row, 0)));
    };
    const Row slopes = g2.isNaN().select(Row::Zero(n), Row::Ones(n));
    set(sloped, slopes);
    set_where(slopes, s20, zx.square()), set_where(slopes, s11, zx * zy), set_where(slopes, s02, zy.square());
    set_where(slopes, developed, g2 / (1 + (1 + g2).sqrt()));
    // Not a number where a neighbour is missing.
    const Row around = left(before) + middle(before) + right(before) + left(here) + right(here) +
                       left(after) + middle(after) + right(after);
    const Row all = around.isNaN().select(Row::Zero(n), Row::Ones(n));
    set(surrounded, all);
    set_where(all, s40, zxx.square()), set_where(all, s31, zxx * zxy), set_where(all, s22, zxx * zyy);
    set_where(all, s13, zxy * zyy), set_where(all, s04, zyy.square());
    for (const Local a : {summit, height, square, curvature}) set(a, Row(Row::Zero(n)));
    for (const FoundSummit& s : found_[size(i)]) {
      const double h = s.height - level_;
      values.row(s.column).segment(summit + 1, 4) += Eigen::RowVector4d(1, h, h * h, s.curvature);
    }
  }

 private:
  NeighbourRows rows_;
  Grid grid_;
  SummitRows found_;
  double level_;
};

LocalSums sums_of(const Field& z, const Grid& grid, int threads) {
  LocalSums out(grid, local);
  const LocalDerivatives functions(z, grid);
  out.add_rows(functions.rows(), threads, functions);
  return out;
}

}  // namespace

DerivativeErrors::DerivativeErrors(const Field& z, const Grid& grid, const FieldExtent& extent, int threads)
    : grid_(grid) {
  const LocalSums sums = sums_of(z, grid, threads);
  means_ = sums.means(extent), points_ = sums.count();
}

double DerivativeErrors::left(const Function& parameter, double taken) const {
  return means_([&](const Eigen::VectorXd& means) {
    const double square_taken = taken / (1 - taken) * means(s00);
    Eigen::VectorXd freed = means;
    freed(s00) += square_taken, freed(square) += means(summit) * square_taken;
    return parameter(derivatives(means, grid_)) / parameter(derivatives(freed, grid_));
  });
}

std::string too_few_points(const LocalMeans& means, double points, Index there, const char* neighbours) {
  constexpr double points_a_wave = 10;
  const double have = std::round(means([there](const Eigen::VectorXd&m) { return m(there); }) * points),
               least = points_a_wave * static_cast<double>(std::max<Index>(means.waves(), 1));
  if (have > least) return "";
  return "no standard error: " + shortest(have) + (have == 1 ? " point has " : " points have ") + neighbours +
         ", and an error needs more than " + shortest(least);
}

std::string DerivativeErrors::too_few_slopes() const {
  return too_few_points(means_, points_, sloped, "the neighbours of a slope");
}

std::string DerivativeErrors::too_few_curvatures() const {
  return too_few_points(means_, points_, surrounded, "all eight neighbours");
}

double DerivativeErrors::operator()(const Function& parameter) const {
  return means_.error([&](const Eigen::VectorXd& means) { return parameter(derivatives(means, grid_)); });
}

}  // namespace asperity
