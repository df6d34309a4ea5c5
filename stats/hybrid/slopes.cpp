#include "stats/hybrid/slopes.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

#include "core/error.hpp"
#include "core/halved.hpp"
#include "stats/filter/form.hpp"
#include "stats/hybrid/neighbours.hpp"
#include "transform/plan.hpp"

namespace asperity {
namespace {

// ---- Sdq and Sdr ----

// Σ [√(1 + g²) - 1].
template <class SquaredSlopes>
ValidSum excess(const SquaredSlopes& g2) {
  return sum_of_valid(g2 / (1 + (1 + g2).sqrt()));
}

// (2) of the cells between two rows, without the mean. Each triangle sees all corners of its cell.
ValidSum excess_of_triangles(const Row& upper, const Row& lower, const Grid& grid) {
  const Index cells = upper.size() - 1;
  const Row a = (lower - upper) / grid.dx;
  const Row b = (upper.tail(cells) - upper.head(cells)) / grid.dy;
  const Row b_lower = (lower.tail(cells) - lower.head(cells)) / grid.dy;
  const Row a_middle = (0.5 * (a.head(cells) + a.tail(cells))).square(),
            b_middle = (0.5 * (b + b_lower)).square();
  const ValidSum first = excess(a.head(cells).square() + b_middle),
                 second = excess(a.tail(cells).square() + b_middle), third = excess(a_middle + b.square()),
                 fourth = excess(a_middle + b_lower.square());
  return {0.25 * (first.sum + second.sum + third.sum + fourth.sum), first.count};
}

}  // namespace

SlopeParameters slope_parameters(const Field& z, const Grid& grid, int threads) {
  const NeighbourRows rows(z, grid, 1);
  const Index sides_y = rows.columns(), ny = z.cols();
  const RowSums<3> sums = sum_rows<3>(z.rows(), threads, [&](Index i) {
    const Row row = rows(i);
    RowSums<3> of_row{};
    of_row[1] = sum_of_valid((row.segment(1, sides_y) - row.head(sides_y)).square());
    if (i < rows.rows()) {
      const Row next = rows(i + 1);
      of_row[0] = sum_of_valid((next - row).head(ny).square());
      of_row[2] = excess_of_triangles(row, next, grid);
    }
    return of_row;
  });
  if (!(sums[2].count > 0)) throw DataError("heights", "slopes need 2 x 2 points, none of them missing");
  return {.sdq = std::sqrt(mean_of(sums[0]) / (grid.dx * grid.dx) + mean_of(sums[1]) / (grid.dy * grid.dy)),
          .sdr = mean_of(sums[2]),
          .cells = sums[2].count};
}

// ---- the slope of the surface between the points ----

namespace {

// Along the rows.
struct MeanSquare {
  double value, error;
};

// A wave of w points has sinc² of π/w of its slope in sides of one step, of 2π/w in those of two.
constexpr double of_two_steps = 0.62;  // of their difference: 0.33 is missing of long waves, 0.616 of w = 3

// The sides leave half a step at each end, whose slope may be another than the mean.
MeanSquare by_differences(const Field& z, double step) {
  const Index n = z.cols();
  auto over = [&](Index steps, Index first, Index sides) {
    const double length = static_cast<double>(steps) * step;
    return (z.middleCols(first + steps, sides) - z.middleCols(first, sides)).square().mean() /
           (length * length);
  };
  const double value = over(1, 0, n - 1), wide = n > 2 ? over(2, 0, n - 2) : 0,
               ends = std::abs(over(1, 0, 1) - value) + std::abs(over(1, n - 2, 1) - value);
  return {value, of_two_steps * std::abs(value - wide) + ends / (2 * static_cast<double>(n))};
}

MeanSquare by_waves(const Field& z, double step) {
  const Index n = z.cols();
  const RealTransform2D line({1, n});
  AlignedVector<Complex> waves(size(line.spectrum_size()));
  double sum = 0;
  for (Index i = 0; i < z.rows(); ++i) {
    line.forward(&z(i, 0), waves.data());
    for (Index k = 1; k <= n / 2; ++k)
      sum += (2 * k == n ? 0.5 : 2) * static_cast<double>(k * k) * std::norm(waves[size(k)]);
  }
  const double q = 2 * std::numbers::pi / (static_cast<double>(n) * step), points = static_cast<double>(n);
  return {sum * q * q / (points * points * static_cast<double>(z.rows())), 0};
}

}  // namespace

RmsSlope rms_slope(const Field& z, const Grid& grid) {
  const std::array<Seam, 2> at = seams(z, grid.periodic);
  const bool waves_x = grid.periodic.x && !at[0].jumps(), waves_y = grid.periodic.y && !at[1].jumps();
  if ((!waves_x && z.rows() < 2) || (!waves_y && z.cols() < 2)) return {};
  const Field turned = z.transpose();
  const MeanSquare x = waves_x ? by_waves(turned, grid.dx) : by_differences(turned, grid.dx),
                   y = waves_y ? by_waves(z, grid.dy) : by_differences(z, grid.dy);
  const double value = std::sqrt(x.value + y.value);
  return {value, value > 0 ? (x.error + y.error) / (2 * value) : 0};
}

// ---- the seam ----

namespace {

constexpr Index least_lines = 16;
constexpr double no_step = 1e-12;  // of the largest height: round-off

template <class Line>
Seam seam(Index lines, double largest_height, Line line) {
  if (lines < least_lines) return {};
  auto step = [&](Index from, Index to) { return std::sqrt((line(to) - line(from)).square().mean()); };
  Seam out{step(lines - 1, 0)};
  if (out.step <= no_step * largest_height) return {};
  for (Index i = 0; i + 1 < lines; ++i) out.largest = std::max(out.largest, step(i, i + 1));
  return out;
}

}  // namespace

std::array<Seam, 2> seams(const Field& heights, Periodic periodic) {
  const double largest = periodic.any() ? heights.abs().maxCoeff() : 0;
  std::array<Seam, 2> out;
  if (periodic.x) out[0] = seam(heights.rows(), largest, [&](Index i) { return heights.row(i); });
  if (periodic.y) out[1] = seam(heights.cols(), largest, [&](Index j) { return heights.col(j); });
  return out;
}

// ---- its growth ----

namespace {

constexpr Index least_side = 16;
constexpr double least_growth = 1e-12;  // of a mean square slope, by which it may fall
constexpr double left_of_form = 1e-20;  // of a mean square slope, by its round-off

// Of gamma, from which on a grid does not resolve the slopes, or may not: validation/contact_grid_error.
constexpr double unresolved = 1.0, doubtful = 0.8;

double mean_square_slope(const Field& z, const Grid& grid) {
  const Index nx = z.rows(), ny = z.cols();
  double x = (z.bottomRows(nx - 1) - z.topRows(nx - 1)).square().sum();
  double y = (z.rightCols(ny - 1) - z.leftCols(ny - 1)).square().sum();
  const bool around = grid.periodic.both();
  if (around) {
    x += (z.row(0) - z.row(nx - 1)).square().sum();
    y += (z.col(0) - z.col(ny - 1)).square().sum();
  }
  const Index sides = around ? 0 : 1;
  return x / (grid.dx * grid.dx * static_cast<double>((nx - sides) * ny)) +
         y / (grid.dy * grid.dy * static_cast<double>(nx * (ny - sides)));
}

}  // namespace

Resolved SlopeGrowth::resolved() const {
  return gamma >= unresolved ? Resolved::no : gamma >= doubtful ? Resolved::doubtful : Resolved::yes;
}

SlopeGrowth slope_growth(Field z, const Grid& grid, int threads) {
  if (std::min(grid.shape.nx, grid.shape.ny) < least_side) return {std::numeric_limits<double>::quiet_NaN()};
  const double with_form = mean_square_slope(z, grid);
  if (!grid.periodic.both()) z = remove_form(std::move(z), 2);
  std::array<double, 3> slopes{};
  Grid cells = grid;
  for (double& slope : slopes) {
    slope = mean_square_slope(z, cells);
    cells.periodic = cells.periodic.both() && cells.shape.nx % 2 == 0 && cells.shape.ny % 2 == 0;
    z = halved(z, threads);
    cells = halved(cells);
  }
  const double first = slopes[0] - slopes[1], second = slopes[1] - slopes[2];
  if (!(first > least_growth * slopes[0] && slopes[0] > left_of_form * with_form)) return {0};
  return {second > 0 ? first / second : std::numeric_limits<double>::infinity()};
}

}  // namespace asperity
