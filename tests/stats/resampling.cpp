// Maps on grids of another spacing, against the functions that they were sampled from.
#include "stats/filter/resampling.hpp"

#include <numbers>

#include "core/error.hpp"
#include "fields.hpp"
#include "holes.hpp"
#include "transform/refinement.hpp"

using namespace asperity;
using namespace asperity::test;
using std::numbers::pi;

TEST_CASE("a chirp transform is the sum of its waves", "[resampling][exact]") {
  for (const auto& [terms, values] : {std::pair<Index, Index>{1, 1}, {1, 9}, {40, 1}, {33, 57}, {64, 20}})
    for (double theta : {0.3, -0.01, 7.0}) {
      ChirpTransform transform(terms, values, theta);
      const Field c = random_field({2, terms}, 5);
      for (Index k = 0; k < terms; ++k) transform.terms()[k] = {c(0, k), c(1, k)};
      const Complex* sums = transform.apply();
      double worst = 0;
      for (Index m = 0; m < values; ++m) {
        Complex exact = 0;
        for (Index k = 0; k < terms; ++k)
          exact += Complex(c(0, k), c(1, k)) * std::polar(1.0, theta * static_cast<double>(k * m));
        worst = std::max(worst, std::abs(sums[m] - exact));
      }
      const double most = static_cast<double>(std::max(terms, values));
      CAPTURE(terms, values, theta);
      CHECK(worst <= epsilon * (10 + std::abs(theta) * most * most) * static_cast<double>(terms));
    }
}

TEST_CASE("a periodic axis keeps its length, a free one has the spacing exactly", "[resampling][exact]") {
  const Grid grid{{100, 40}, 0.1, 0.5, {true, false}}, out = resampled_grid(grid, 0.3, 0.3);
  CHECK(out.shape == Shape{33, 66});
  CHECK(relative_error(out.size_x(), 10) <= 4 * epsilon);
  CHECK(out.dy == 0.3);
  CHECK(resampled_grid(grid, 0.05, 0.25).shape == Shape{200, 80});
  CHECK(resampled_grid({{1, 40}, 1, 0.5}, 7, 0.25).shape == Shape{1, 80});
  for (double spacing : {0.0, -1.0, 5.1, 1e-12, std::nan(""), HUGE_VAL})
    CHECK_THROWS_AS(resampled_grid(grid, spacing, 0.3), ParameterError);
}

// Waves of 25 and 10 points on a period; 70 values of 1.43 points, or 330 of 0.30, hold both. Arguments up to 2π 10
// are rounded before their sines are taken, as in the transform.
TEST_CASE("waves of a periodic axis are met at any spacing, up and down", "[resampling][exact]") {
  const Grid grid{{100, 30}, 1, 1, true};
  auto waves = [](double x, double y) {
    return std::sin(2 * pi * (4 * x / 100 + y / 30)) + std::cos(2 * pi * (10 * x / 100 - 2 * y / 30) + 1) + 3;
  };
  const Field z = sample(grid, waves);
  for (double spacing : {1.43, 0.303, 1.0, 0.5, 2.0, 3.0}) {
    const Grid target = resampled_grid(grid, spacing, spacing);
    CAPTURE(spacing);
    CHECK((resampled(z, grid, spacing, spacing) - sample(target, waves)).abs().maxCoeff() <= 400 * epsilon);
  }
}

// The wave of 3 points is shorter than two new cells of 2: none of it is left, as of a mean over many cells.
TEST_CASE("waves of less than two new cells are left out, none becomes another", "[resampling][exact]") {
  const Grid grid{{120, 1}, 1, 1, true};
  auto slow = [](double x, double) { return std::sin(2 * pi * x / 40); };
  const Field z =
      sample(grid, slow) + sample(grid, [](double x, double) { return std::cos(2 * pi * x / 3); });
  for (double spacing : {2.0, 2.5, 4.0})
    CHECK(
        (resampled(z, grid, spacing, 1) - sample(resampled_grid(grid, spacing, 1), slow)).abs().maxCoeff() <=
        200 * epsilon);
}

// What does not fill the axis (chirp) and what does (transform): both are the same polynomial.
TEST_CASE("a form of degree 2 keeps to round-off on a free axis at any spacing", "[resampling][exact]") {
  const Grid grid{{50, 36}, 1, 1.5};
  auto form = [](double x, double y) { return 2 + x / 9 - y / 7 + x * x / 400 - x * y / 300 + y * y / 200; };
  const Field z = sample(grid, form);
  for (double spacing : {0.4, 0.5, 0.77, 1.0, 2.2, 7.1}) {
    const Grid target = resampled_grid(grid, spacing, spacing);
    CAPTURE(spacing);
    CHECK((resampled(z, grid, spacing, spacing) - sample(target, form)).abs().maxCoeff() <=
          400 * epsilon * 10);
  }
}

// transform/refinement.hpp: an error of aqΔ/10 within a point or two of an end, less inside.
TEST_CASE("a wave on a free axis is met but for its ends", "[resampling][law]") {
  const Grid grid{{200, 1}, 1, 1};
  auto wave = [](double x, double) { return std::sin(2 * pi * x / 23.7 + 0.4); };
  const Field z = sample(grid, wave);
  for (double spacing : {0.37, 1.7}) {
    const Grid target = resampled_grid(grid, spacing, 1);
    const Field error = resampled(z, grid, spacing, 1) - sample(target, wave);
    const Index n = target.shape.nx;
    CHECK(error.abs().maxCoeff() <= 0.3 * 2 * pi / 23.7);
    CHECK(error.middleRows(n / 4, n / 2).abs().maxCoeff() <= 2e-3 * spacing);
  }
}

TEST_CASE("resampling by whole numbers is refinement, threads do not matter, and holes are refused",
          "[resampling][contract]") {
  const Grid grid{{24, 30}, 1, 1};
  const Field z = random_field(grid.shape, 71);
  CHECK((resampled(z, grid, 0.5, 0.25) - refined(z, grid, {2, 4})).abs().maxCoeff() <= 100 * epsilon);
  CHECK((resampled(z, grid, 0.7, 1.9, 3) == resampled(z, grid, 0.7, 1.9)).all());
  CHECK((resampled(z, grid, 1, 1) - z).abs().maxCoeff() <= 20 * epsilon);
  CHECK_THROWS_AS(resampled(with_holes(z, 0.1, 72), grid, 0.5, 0.5), DataError);
}
