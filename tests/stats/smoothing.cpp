// Mean surfaces: the median, the robust Gaussian filter, the spline.
#include <algorithm>
#include <numbers>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Dense>

#include "core/error.hpp"
#include "fields.hpp"
#include "holes.hpp"
#include "stats/filter/gaussian_filter.hpp"
#include "stats/filter/morphology.hpp"
#include "stats/filter/robust_gaussian.hpp"
#include "stats/filter/spline_filter.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

double brute_median(const Field& z, const Grid& grid, Shape window, Index i, Index j) {
  std::vector<double> values;
  const auto [nx, ny] = grid.shape;
  for (Index k = i - window.nx / 2; k <= i + window.nx / 2; ++k)
    for (Index l = j - window.ny / 2; l <= j + window.ny / 2; ++l) {
      if ((!grid.periodic.x && (k < 0 || k >= nx)) || (!grid.periodic.y && (l < 0 || l >= ny))) continue;
      if (const double value = z((k + nx) % nx, (l + ny) % ny); !std::isnan(value)) values.push_back(value);
    }
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

const std::array periods{Periodic{}, Periodic{true}, Periodic{true, false}, Periodic{false, true}};

}  // namespace

TEST_CASE("the median filter gives the median of each window", "[filter][exact]") {
  for (const Periodic periodic : periods)
    for (const Shape window :
         {Shape{1, 1}, Shape{3, 3}, Shape{5, 1}, Shape{1, 9}, Shape{41, 7}, Shape{41, 35}}) {
      const Grid grid{{42, 35}, 1, 1, periodic};
      Field z = with_holes(random_field(grid.shape, 51), 0.2, 52);
      z = (z.abs() < 0.2).select(0, z);  // ties
      const Field medians = median_surface(z, grid, window);
      bool equal = true;
      for (Index i = 0; i < 42; ++i)
        for (Index j = 0; j < 35; ++j)
          equal &= std::isnan(z(i, j)) ? std::isnan(medians(i, j))
                                       : medians(i, j) == brute_median(z, grid, window, i, j);
      CAPTURE(window.nx, window.ny, periodic.x, periodic.y);
      CHECK(equal);
      CHECK(largest_difference(median_surface(z, grid, window, 3), medians) == 0);
    }
}

TEST_CASE("a window has an odd number of points, as many as its width holds", "[filter][exact]") {
  const Grid grid{{100, 10}, 0.1, 0.2};
  CHECK(median_window(grid, 0.5) == Shape{5, 3});
  CHECK(median_window(grid, 0.6) == Shape{7, 3});
  CHECK(median_window(grid, 0.2) == Shape{3, 1});
  CHECK(median_window(grid, 1e9) == Shape{99, 9});
  for (double width : {0.1, 0.0, -1.0, std::nan(""), HUGE_VAL})
    CHECK_THROWS_AS(median_window(grid, width), ParameterError);
  for (const Shape window : {Shape{2, 3}, Shape{3, 0}, Shape{101, 1}, Shape{-1, 1}})
    CHECK_THROWS_AS(median_surface(Field::Ones(100, 10), grid, window), ParameterError);
}

// ---- robust gaussian ----

namespace {

constexpr double gamma_of_width = 0.73091;  // of the weight of order 2

double rms(const Field& z) {
  return std::sqrt(z.isNaN().select(0, z).square().sum() / static_cast<double>((!z.isNaN()).count()));
}

}  // namespace

// Tukey's biweight of 3 robust standard deviations uses Gaussian heights with an efficiency of 0.85 or so: the
// robust mean differs from the first one, without weights, by √(1/0.85 - 1) = 0.4 of its standard error. That is
// σ times √(∫ H²) = √1.25/(γ λc), H of order 2: 0.109, over N_eff = 64²/(2 γ²λc²/1.25) = 24 places or so.
TEST_CASE("without outliers the robust mean surface is near the plain one", "[filter][statistics]") {
  const Grid grid{{64, 64}, 1, 1, true};
  const Field z = white_noise(grid.shape, 41),
              plain = robust_gaussian_mean_surface(z, grid, 14, 1, 1).surface;
  const RobustMeanSurface robust = robust_gaussian_mean_surface(z, grid, 14);
  CHECK(robust.converged);
  CHECK(robust.steps <= 20);
  CHECK(relative_error(rms(plain), std::sqrt(1.25) / (gamma_of_width * 14)) <= 4 / std::sqrt(2 * 24.0));
  CHECK(rms(robust.surface - plain) <= 0.4 * rms(plain) * 1.5);
  CHECK(relative_error(robust.width, 3) <= 0.1);
  // δ = 0 beyond 3 standard deviations: 0.0027 of Gaussian heights, counted with its root
  CHECK(std::abs(robust.ignored - 0.0027) <= 4 * std::sqrt(0.0027 / 4096) + 0.001);
}

// A weight that is cut at 1.6 λc misses 3e-7 there.
TEST_CASE("a wave at the cut-off passes by half, others by (1 + v) exp(-v)", "[filter][exact]") {
  const Grid grid{{120, 4}, 1, 1, true};
  for (const int waves : {1, 3, 6}) {
    const double v = std::numbers::pi * std::pow(gamma_of_width * waves / 3, 2),
                 passed = (1 + v) * std::exp(-v);
    const Field z = sine(grid.shape, 1, waves);
    const Field w = robust_gaussian_mean_surface(z, grid, 40, 1, 1).surface;
    CAPTURE(waves);
    if (waves == 3) CHECK(std::abs(passed - 0.5) <= 1e-5);
    CHECK((w - passed * z).abs().maxCoeff() <= 5e-5);
  }
}

// On a slope of 30 and a bowl of 100 deviations the filter of order 0 left 30 of them.
TEST_CASE("a slope or a bowl below a roughness with scratches passes the robust filter, edges included",
          "[filter][law]") {
  const Grid grid{{60, 50}, 1, 1};
  Field rough = with_holes(white_noise(grid.shape, 47), 0.05, 48);
  rough.middleRows(20, 2) -= 40;
  const RobustMeanSurface level = robust_gaussian_mean_surface(rough, grid, 20);
  CHECK(level.converged);
  // √1.25/(γ λc) inside; edges and lost points add to it
  CHECK(rms(level.surface) <= 2 * std::sqrt(1.25) / (gamma_of_width * 20));
  for (const Field& form :
       {sample(grid, [](double x, double y) { return 30 * x - 7 * y + 1e3; }),
        sample(grid, [](double x, double y) { return 0.1 * x * x - 0.05 * x * y + y * y; })}) {
    const RobustMeanSurface on_form = robust_gaussian_mean_surface(rough + form, grid, 20);
    // δ is the same to round-off, and so are the steps.
    CHECK(on_form.steps == level.steps);
    CHECK((on_form.surface - form - level.surface)
              .isNaN()
              .select(0, on_form.surface - form - level.surface)
              .abs()
              .maxCoeff() <= 1e-9);
  }
}

TEST_CASE("quadratic surfaces and profiles pass the robust filter as they are", "[filter][exact]") {
  for (const Grid& grid : {Grid{{40, 30}, 1, 1},
                           {{50, 1}, 1, 1},
                           {{1, 50}, 1, 1},
                           {{40, 2}, 1, 1},
                           {{40, 7}, 1, 1, {false, true}},
                           {{40, 1}, 1, 1, {false, true}}}) {
    const bool along_x = grid.periodic.y || grid.shape.ny <= 2;
    const Field bowl = sample(grid, [along_x](double x, double y) {
      return 3 + x - 0.3 * x * x + (along_x ? 0 : 0.5 * x * y - 2 * y + 0.2 * y * y);
    });
    const Field z = with_holes(bowl, 0.1, 49);
    const RobustMeanSurface found = robust_gaussian_mean_surface(z, grid, 9);
    CAPTURE(grid.shape.nx, grid.shape.ny);
    CHECK(found.converged);
    CHECK((found.surface.isNaN() == z.isNaN()).all());
    CHECK(rms(found.surface - z) <= 1e-10 * bowl.abs().maxCoeff());
  }
}

// Scratches over a tenth of the field, 100 deep in a roughness of 1.
TEST_CASE("deep scratches pull the plain mean surface but not the robust one", "[filter][law]") {
  const Grid grid{{100, 60}, 1, 1};
  const Field rough = white_noise(grid.shape, 42);
  Field scratched = rough;
  for (Index i = 5; i < 100; i += 20) scratched.middleRows(i, 2) -= 100;
  const Field plain = gaussian_mean_surface(scratched, grid, 20);
  const RobustMeanSurface robust = robust_gaussian_mean_surface(scratched, grid, 20),
                          clean = robust_gaussian_mean_surface(rough, grid, 20);
  CHECK(robust.converged);
  CHECK(rms(plain - clean.surface) >= 5);
  CHECK(rms(robust.surface - clean.surface) <= 0.2);  // 0.1 of its points are lost: √(0.1)/(0.66·20) and some
  CHECK(robust.ignored >= 0.1);
}

// The weights are a fixed point: the local quadratic with the weights (2) of the result is the result, but for
// the last step's move.
TEST_CASE("the robust mean surface holds its equations to the tolerance", "[filter][law]") {
  const Grid grid{{40, 36}, 1, 1};
  const Field z = with_holes(white_noise(grid.shape, 43), 0.1, 44);
  const RobustMeanSurface robust = robust_gaussian_mean_surface(z, grid, 8);
  CHECK((robust.surface.isNaN() == z.isNaN()).all());
  CHECK(robust.change <= 1e-3 / 3 * robust.width);
  const Field r = z - robust.surface;
  for (const auto& [i, j] : {std::pair<Index, Index>{17, 26}, {0, 1}, {39, 20}}) {
    REQUIRE(!std::isnan(r(i, j)));
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(6, 6);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(6);
    for (Index k = 0; k < 40; ++k)
      for (Index l = 0; l < 36; ++l) {
        const double x = double(k - i) / 8, y = double(l - j) / 8, ratio = r(k, l) / robust.width;
        if (!(std::abs(ratio) < 1) || std::abs(x) > 1.63 || std::abs(y) > 1.63) continue;
        const double weight =
            std::exp(-std::numbers::pi * (x * x + y * y) / (gamma_of_width * gamma_of_width)) *
            std::pow(1 - ratio * ratio, 2);
        const Eigen::VectorXd terms = Eigen::Vector<double, 6>{1, x, y, x * x, x * y, y * y};
        gram += weight * terms * terms.transpose();
        right += weight * z(k, l) * terms;
      }
    CHECK(std::abs(robust.surface(i, j) - gram.ldlt().solve(right)[0]) <= robust.largest + 1e-9);
  }
}

TEST_CASE("a constant stays, however high, and a shift moves the robust mean surface along",
          "[filter][law]") {
  const Grid grid{{30, 20}, 1, 1};
  CHECK((robust_gaussian_mean_surface(Field::Constant(30, 20, 1e9), grid, 6).surface == 1e9).all());
  const Field z = white_noise(grid.shape, 45);
  const Field here = robust_gaussian_mean_surface(z, grid, 6).surface,
              there = robust_gaussian_mean_surface(z + 1e3, grid, 6).surface;
  CHECK((there - 1e3 - here).abs().maxCoeff() <= 1e-10);
}

TEST_CASE("a robust filter that is stopped early says that it has not converged", "[filter][contract]") {
  const Grid grid{{30, 20}, 1, 1};
  const RobustMeanSurface stopped = robust_gaussian_mean_surface(white_noise(grid.shape, 46), grid, 6, 1, 2);
  CHECK_FALSE(stopped.converged);
  CHECK(stopped.steps == 2);
  CHECK_THROWS_AS(robust_gaussian_mean_surface(Field::Ones(8, 8), {{8, 8}, 1, 1}, 1), ParameterError);
}

// ---- spline filter ----

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
  const Index nx = grid.shape.nx, ny = grid.shape.ny;
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

const std::array spline_periods{Periodic{}, Periodic{true}, Periodic{true, false}, Periodic{false, true}};

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
  for (const Periodic periodic : spline_periods)
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
