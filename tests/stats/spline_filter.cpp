// Waves, lines and holes through the spline filter.
#include "stats/filter/spline_filter.hpp"

#include <numbers>

#include <Eigen/Dense>

#include "core/error.hpp"
#include "fields.hpp"
#include "holes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// α⁴ 16 sin⁴(πΔ/λ).
double damping(double step, double cutoff, double wavelength) {
  using std::numbers::pi;
  return std::pow(std::sin(pi * step / wavelength) / std::sin(pi * step / cutoff), 4);
}

// α⁴ DᵀD of an axis, dense.
Eigen::MatrixXd penalty(Index n, double step, bool periodic, double cutoff) {
  Eigen::MatrixXd D = Eigen::MatrixXd::Zero(n, n);
  for (Index i = periodic ? 0 : 1; i < (periodic ? n : n - 1); ++i) {
    D(i, (i + n - 1) % n) += 1;
    D(i, i) -= 2;
    D(i, (i + 1) % n) += 1;
  }
  return std::pow(2 * std::sin(std::numbers::pi * step / cutoff), -4) * D.transpose() * D;
}

// (3) of the header, solved as it stands.
Field dense(const Field& z, const Grid& grid, double cutoff) {
  const auto [nx, ny] = grid.shape;
  const Eigen::MatrixXd x = Eigen::MatrixXd::Identity(nx, nx) + penalty(nx, grid.dx, grid.periodic.x, cutoff),
                        y = Eigen::MatrixXd::Identity(ny, ny) + penalty(ny, grid.dy, grid.periodic.y, cutoff);
  Eigen::MatrixXd A(nx * ny, nx * ny);
  for (Index i = 0; i < nx; ++i)
    for (Index k = 0; k < nx; ++k) A.block(i * ny, k * ny, ny, ny) = x(i, k) * y;
  Eigen::VectorXd right(nx * ny);
  for (Index k = 0; k < nx * ny; ++k) {
    right[k] = std::isnan(z(k)) ? 0 : z(k);
    if (std::isnan(z(k))) A(k, k) -= 1;
  }
  const Eigen::VectorXd w = A.ldlt().solve(right);
  return Field::NullaryExpr(nx, ny,
                            [&](Index i, Index j) { return std::isnan(z(i, j)) ? none : w[i * ny + j]; });
}

const std::array periods{Periodic{}, Periodic{true}, Periodic{true, false}, Periodic{false, true}};

}  // namespace

TEST_CASE(
    "a wave on a periodic axis passes the spline filter with 1/(1 + α⁴ 16 sin⁴(πΔ/λ)), half at the cut-off",
    "[filter][exact]") {
  const Grid grid{{60, 45}, 0.5, 2, true};
  for (double cutoff : {4.0, 10.0, 30.0}) {
    const Field wave = sine(grid.shape, 1, 3);  // wavelength 10
    const double transmitted = 1 / (1 + damping(0.5, cutoff, 10));
    CHECK((spline_mean_surface(wave, grid, cutoff) - transmitted * wave).abs().maxCoeff() <= 50 * epsilon);
    if (cutoff == 10) CHECK(std::abs(transmitted - 0.5) <= 4 * epsilon);
  }
}

// The condition of the equation is (1 + 16 α_x⁴)(1 + 16 α_y⁴), 3e4 here, and twice that with holes of this size.
TEST_CASE("the spline filter solves its equation, at free ends, seams and holes", "[filter][exact]") {
  for (const Periodic periodic : periods)
    for (const bool holes : {false, true}) {
      const Grid grid{{19, 14}, 1, 1.3, periodic};
      Field z = random_field(grid.shape, 31) + 2;
      if (holes) z = with_holes(z, 0.1, 32);
      CAPTURE(periodic.x, periodic.y, holes);
      CHECK(largest_difference(spline_mean_surface(z, grid, 9), dense(z, grid, 9)) <= 3e5 * epsilon * 3);
    }
}

// A wave in the middle of a long line feels its free ends by exp(-distance/(α√2)) only: 60 points, α = 3.2.
TEST_CASE("a wave far from free ends passes as a periodic one", "[filter][exact]") {
  const Grid grid{{480, 1}, 1, 1};
  const Field wave = sine(grid.shape, 1, 24);  // wavelength 20
  const double transmitted = 1 / (1 + damping(1, 20, 20));
  const Field error = spline_mean_surface(wave, grid, 20) - transmitted * wave;
  CHECK(error.middleRows(180, 120).abs().maxCoeff() <= std::exp(-180 / (3.2 * std::numbers::sqrt2)) + 1e-13);
}

// ε α⁴ of the heights, α⁴ = 104.
TEST_CASE("a bilinear surface passes the spline filter as it is, ends included", "[filter][law]") {
  const Grid grid{{50, 40}, 1, 1};
  const Field z = sample(grid, [](double x, double y) { return 1e3 + 0.3 * x - 0.2 * y + 0.01 * x * y; });
  CHECK((spline_mean_surface(z, grid, 20) - z).abs().maxCoeff() <= 10 * 104 * epsilon * 20 + 2e3 * epsilon);
  const Field holes = with_holes(z, 0.2, 33);
  CHECK(largest_difference(spline_mean_surface(holes, grid, 20), holes) <= 1e-9);
  CHECK((spline_mean_surface(Field::Constant(50, 40, 1e9), grid, 20) == 1e9).all());
}

// Heights at missing points do not matter, those at the others do.
TEST_CASE("short axes and a single point pass the spline filter", "[filter][contract]") {
  for (const Shape shape : {Shape{1, 1}, Shape{2, 1}, Shape{1, 3}, Shape{2, 2}}) {
    const Grid small{shape, 1, 1};
    const Field z = random_field(shape, 3);
    CHECK((spline_mean_surface(z, small, 5) - dense(z, small, 5)).abs().maxCoeff() <= 100 * epsilon);
  }
  for (double cutoff : {0.0, -5.0, 3.9, std::nan(""), HUGE_VAL})
    CHECK_THROWS_AS(spline_mean_surface(Field::Ones(8, 8), {{8, 8}, 1, 2}, cutoff), ParameterError);
}

TEST_CASE("the spline filter does not depend on the threads", "[filter][law]") {
  const Grid grid{{40, 50}, 1, 1, Periodic{true, false}};
  const Field z = with_holes(random_field(grid.shape, 4), 0.1, 5);
  CHECK(largest_difference(spline_mean_surface(z, grid, 8, 1), spline_mean_surface(z, grid, 8, 3)) == 0);
}
