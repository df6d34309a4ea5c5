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

// Mean products of slopes of a row of cells, 0 where a corner is missing.
struct CellRow {
  Row s20, s11, s02, developed, there;

  // Of the corners in two rows.
  CellRow(const Row& near, const Row& far, const Grid& grid) {
    const Index n = near.size() - 1;
    const Row along_x = (far - near) / grid.dx, x = along_x.head(n), x_next = along_x.tail(n),
              y = (near.tail(n) - near.head(n)) / grid.dy, y_next = (far.tail(n) - far.head(n)) / grid.dy,
              x_mean = 0.5 * (x + x_next), y_mean = 0.5 * (y + y_next);
    auto stretched = [](const Row& g2) -> Row { return g2 / (1 + (1 + g2).sqrt()); };
    s20 = 0.5 * (x.square() + x_next.square()), s02 = 0.5 * (y.square() + y_next.square());
    s11 = x_mean * y_mean;
    developed =
        0.25 * (stretched(x.square() + y_mean.square()) + stretched(x_next.square() + y_mean.square()) +
                stretched(y.square() + x_mean.square()) + stretched(y_next.square() + x_mean.square()));
    there = developed.isNaN().select(Row::Zero(n), Row::Ones(n));
    for (Row* f : {&s20, &s11, &s02, &developed}) *f = (there > 0).select(*f, 0);
  }
};

// The local functions of the points that have all neighbours in the grid. A cell belongs to its corners
// alike, so that mirror images have the same functions.
class LocalDerivatives {
 public:
  LocalDerivatives(const Field& z, const Grid& grid)
      : rows_(z, grid, 2),
        grid_(grid),
        first_(grid.periodic.both() ? 0 : 1),
        found_(find_summits(z, grid)),
        level_(mean(z)) {}

  void operator()(Index row, LocalSums::Values& values) const {
    const Index i = row - first_, n = rows_.columns();
    if (i < 0 || i >= rows_.rows()) return;
    const Row before = rows_(i), here = rows_(i + 1), after = rows_(i + 2);
    auto set = [&](Local a, const Row& f) { values.col(a + 1).segment(first_, n) = f.matrix().transpose(); };
    const Row z = here.segment(1, n) - level_;
    set(first, z), set(s00, z.square());
    const CellRow nearer(before, here, grid_), farther(here, after, grid_);
    auto shared = [&](Row CellRow::*f) -> Row {
      const Row both = nearer.*f + farther.*f;
      return 0.25 * (both.head(n) + both.tail(n));
    };
    set(sloped, shared(&CellRow::there)), set(developed, shared(&CellRow::developed));
    set(s20, shared(&CellRow::s20)), set(s11, shared(&CellRow::s11)), set(s02, shared(&CellRow::s02));
    set_curvatures(before, here, after, set);
    for (const Local a : {summit, height, square, curvature}) set(a, Row::Zero(n));
    for (const FoundSummit& s : found_[size(i)]) {
      const double h = s.height - level_;
      values.row(first_ + s.column).segment(summit + 1, 4) += Eigen::RowVector4d(1, h, h * h, s.curvature);
    }
  }

 private:
  // A point counts for none of them if a neighbour is missing.
  void set_curvatures(const Row& before, const Row& here, const Row& after, const auto& set) const {
    const Index n = rows_.columns();
    auto left = [n](const Row& row) { return row.head(n); };
    auto middle = [n](const Row& row) { return row.segment(1, n); };
    auto right = [n](const Row& row) { return row.tail(n); };
    const double dx = grid_.dx, dy = grid_.dy;
    const Row zxx = (middle(before) - 2 * middle(here) + middle(after)) / (dx * dx),
              zyy = (left(here) - 2 * middle(here) + right(here)) / (dy * dy),
              zxy = (right(after) - left(after) - right(before) + left(before)) / (4 * dx * dy),
              all = (zxx + zyy + zxy).isNaN().select(Row::Zero(n), Row::Ones(n));
    set(surrounded, all);
    auto set_where = [&](Local a, const Row& f) { set(a, Row((all > 0).select(f, 0))); };
    set_where(s40, zxx.square()), set_where(s31, zxx * zxy), set_where(s22, zxx * zyy);
    set_where(s13, zxy * zyy), set_where(s04, zyy.square());
  }

  NeighbourRows rows_;
  Grid grid_;
  Index first_;  // row and column of the grid
  SummitRows found_;
  double level_;
};

LocalSums sums_of(const Field& z, const Grid& grid, int threads) {
  LocalSums out(grid, local);
  const LocalDerivatives functions(z, grid);
  out.add_rows(grid.shape.nx, threads, functions);
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

WaveError DerivativeErrors::operator()(const Function& parameter) const {
  return means_.error([&](const Eigen::VectorXd& means) { return parameter(derivatives(means, grid_)); });
}

}  // namespace asperity
