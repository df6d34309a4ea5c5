#include "stats/spatial/tapered_acf.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/error.hpp"
#include "stats/filter/missing.hpp"
#include "stats/filter/outliers.hpp"
#include "stats/spatial/acf.hpp"
#include "transform/lag_sums.hpp"

namespace asperity {
namespace {

constexpr Index hole_reach = 2;      // half the width of a wide hole
constexpr double sides_a_ramp = 16;  // of w towards a wide hole, in the shorter side
constexpr double far_away = 1e18;

constexpr double ramp = 0.2;  // of a side, at each end

double raised_cosine(double t) {
  return std::pow(std::sin(std::numbers::pi / 2 * std::clamp(t, 0.0, 1.0)), 2);
}

double tukey(Index i, Index n) {
  return raised_cosine((static_cast<double>(std::min(i, n - 1 - i)) + 0.5) / (ramp * static_cast<double>(n)));
}

// ---- the distance to wide holes ----

// The squares of distances along a line, given those across it: the lower envelope of parabolas
// (P. F. Felzenszwalb, D. P. Huttenlocher, Theory Comput. 8 (2012) 415-428).
void add_distances_along(std::vector<double>& squares) {
  const auto n = static_cast<Index>(squares.size());
  std::vector<Index> lowest(squares.size());
  std::vector<double> from(squares.size() + 1);
  auto f = [&](Index i) { return squares[size(i)] + static_cast<double>(i * i); };
  Index k = 0;
  from[0] = -far_away;
  for (Index i = 1; i < n; ++i) {
    double crossing = 0;
    for (;; --k) {
      const Index j = lowest[size(k)];
      crossing = (f(i) - f(j)) / static_cast<double>(2 * (i - j));
      if (k == 0 || crossing > from[size(k)]) break;
    }
    if (crossing > from[size(k)]) ++k;
    lowest[size(k)] = i, from[size(k)] = k > 0 ? crossing : -far_away;
  }
  from[size(k + 1)] = std::numeric_limits<double>::infinity();
  const std::vector<double> across = squares;
  Index at = 0;
  for (Index i = 0; i < n; ++i) {
    while (from[size(at + 1)] < static_cast<double>(i)) ++at;
    const Index j = lowest[size(at)];
    squares[size(i)] = across[size(j)] + static_cast<double>((i - j) * (i - j));
  }
}

// From the points that `wide` marks with 0, others being far away, in samples.
Field distances(Field squares) {
  std::vector<double> line(size(squares.rows()));
  for (Index j = 0; j < squares.cols(); ++j) {
    Eigen::Map<Eigen::ArrayXd>(line.data(), squares.rows()) = squares.col(j);
    add_distances_along(line);
    squares.col(j) = Eigen::Map<const Eigen::ArrayXd>(line.data(), squares.rows());
  }
  line.resize(size(squares.cols()));
  for (Index i = 0; i < squares.rows(); ++i) {
    line.assign(squares.row(i).begin(), squares.row(i).end());
    add_distances_along(line);
    std::ranges::copy(line, squares.row(i).begin());
  }
  return squares.sqrt();
}

// 0 at the middle of a square of missing points, and at missing points near enough to the edge of the field.
Field middles_of_holes(const Field& z) {
  const RectangleSums there(validity(z));
  return Field::NullaryExpr(z.rows(), z.cols(), [&](Index i, Index j) {
    const Index top = std::max<Index>(i - hole_reach, 0), left = std::max<Index>(j - hole_reach, 0);
    const Index rows = std::min(i + hole_reach + 1, z.rows()) - top,
                columns = std::min(j + hole_reach + 1, z.cols()) - left;
    return there(top, left, rows, columns) == 0 ? 0 : far_away;
  });
}

// The factor of w towards wide holes; no rows where there are none.
Field ramps(const Field& z) {
  Field middles = middles_of_holes(z);
  if ((middles > 0).all()) return {};
  const double shorter = static_cast<double>(std::min(z.rows(), z.cols())),
               length = std::max(4.0, shorter / sides_a_ramp);
  return distances(std::move(middles)).unaryExpr([length](double d) {
    return raised_cosine((d - static_cast<double>(hole_reach)) / length);
  });
}

// ---- the window ----

// Along x and y, and the factor towards wide holes, if there are any.
struct Window {
  Eigen::ArrayXd along_x, along_y;
  Field towards_holes = {};

  explicit Window(const Grid& grid)
      : along_x(Eigen::ArrayXd::Ones(grid.shape.nx)), along_y(Eigen::ArrayXd::Ones(grid.shape.ny)) {
    if (grid.periodic.both()) return;
    for (Eigen::ArrayXd* w : {&along_x, &along_y})
      for (Index i = 0; i < w->size(); ++i) (*w)(i) = tukey(i, w->size());
  }
  Eigen::Array<double, 1, Eigen::Dynamic> row(Index i) const {
    const auto whole = along_x(i) * along_y.transpose();
    if (towards_holes.size() == 0) return whole;
    return whole * towards_holes.row(i);
  }
};

Window window_of(const Field& z, const Grid& grid) {
  Window out(grid);
  if (has_missing(z)) out.towards_holes = ramps(z);
  return out;
}

// W(1,0) and W(0,1) over W(0,0).
std::array<double, 2> window_at_one_lag(const Window& window, const Grid& grid) {
  const auto [nx, ny] = grid.shape;
  const bool around = grid.periodic.both();
  double whole = 0, x = 0, y = 0;
  for (Index i = 0; i < nx; ++i) {
    const auto row = window.row(i).eval();
    whole += row.square().sum();
    if (i + 1 < nx || around) x += (row * window.row((i + 1) % nx)).sum();
    y += (row.head(ny - 1) * row.tail(ny - 1)).sum() + (around ? row(0) * row(ny - 1) : 0);
  }
  return {x / whole, y / whole};
}

// Narrow holes are filled; within wide ones the heights do not count.
Field without_holes(const Field& z, const Grid& grid, const Field& towards_wide_holes) {
  Field out = z;
  const ValidSum heights = sum_of_valid(z);
  if (towards_wide_holes.size() > 0)
    out = (towards_wide_holes == 0 && z.isNaN()).select(heights.sum / heights.count, out);
  return filled(std::move(out), grid, Filling::laplace);
}

double wendland(double r) { return r < 1 ? std::pow(1 - r, 4) * (4 * r + 1) : 0; }

void cut(Field& sums, Shape max_lag) {
  for (Index p = 0; p <= max_lag.nx; ++p)
    for (Index q = -max_lag.ny; q <= max_lag.ny; ++q)
      sums(p, max_lag.ny + q) *=
          wendland(std::hypot(static_cast<double>(p) / static_cast<double>(max_lag.nx + 1),
                              static_cast<double>(q) / static_cast<double>(max_lag.ny + 1)));
}

}  // namespace

LagField tapered_autocorrelation(const Field& z, const Grid& grid, Shape max_lag, int threads) {
  AcfParameters{.max_lag = max_lag}.check(grid);
  const Window window = window_of(z, grid);
  Field holes_filled;
  if (has_missing(z)) holes_filled = without_holes(z, grid, window.towards_holes);
  const Field& heights = holes_filled.size() > 0 ? holes_filled : z;
  double weight = 0, sum = 0;
  const double base = heights(0, 0);
  for (Index i = 0; i < heights.rows(); ++i) {
    const auto squares = window.row(i).square().eval();
    weight += squares.sum(), sum += (squares * (heights.row(i) - base)).sum();
  }
  if (!(weight > 0)) throw DataError("heights", "no point is far enough from missing ones to count");
  const double above_base = sum / weight;
  const RowSource rows = [&](Index i, double* row) {
    Eigen::Map<Eigen::Array<double, 1, Eigen::Dynamic>>(row, heights.cols()) =
        window.row(i) * (heights.row(i) - base - above_base);
  };
  Field sums = lag_sums_of_rows(rows, grid, max_lag, threads);
  sums /= weight;
  if (max_lag != longest_lags(grid)) cut(sums, max_lag);
  return LagField(std::move(sums));
}

double slopes_by_taper(const Field& z, const Grid& grid, const LagField& acf) {
  auto [wx, wy] = window_at_one_lag(window_of(z, grid), grid);
  const Shape lags = acf.max_lag();
  if (lags != longest_lags(grid)) {
    wx *= wendland(1 / static_cast<double>(lags.nx + 1));
    wy *= wendland(1 / static_cast<double>(lags.ny + 1));
  }
  auto slopes = [&grid](double x, double y) {
    return (grid.shape.nx > 1 ? (1 - x) / (grid.dx * grid.dx) : 0) +
           (grid.shape.ny > 1 ? (1 - y) / (grid.dy * grid.dy) : 0);
  };
  const double share = slopes(wx, wy) / slopes(acf(1, 0) / acf(0, 0), acf(0, 1) / acf(0, 0));
  return share < 1 ? 1 / std::sqrt(1 - share) : std::numeric_limits<double>::infinity();
}

}  // namespace asperity
