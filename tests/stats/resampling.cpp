// Maps on another grid.
#include "stats/filter/resampling.hpp"

#include <numbers>

#include "core/error.hpp"
#include "fields.hpp"
#include "holes.hpp"
#include "stats/filter/seam.hpp"
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

// ---- rotation ----

using std::numbers::pi;

TEST_CASE("four quarter turns, and two mirrors, give back every bit", "[rotation][exact]") {
  const Field z = with_holes(random_field({17, 12}, 61), 0.2, 62);
  Field turned = z;
  for (int k = 0; k < 4; ++k) turned = turned_quarters(turned, 1);
  CHECK(largest_difference(turned, z) == 0);
  CHECK(largest_difference(turned_quarters(turned_quarters(z, 3), -3), z) == 0);
  CHECK(largest_difference(turned_quarters(z, 2), mirrored(mirrored(z, Axis1D::x), Axis1D::y)) == 0);
  for (const Axis1D axis : {Axis1D::x, Axis1D::y})
    CHECK(largest_difference(mirrored(mirrored(z, axis), axis), z) == 0);
  CHECK(mirrored(z, Axis1D::x)(16, 3) == z(0, 3));
}

// The height at p is the map's at R(-φ)p, by the coordinates of the two grids.
TEST_CASE("a quarter turn takes the x axis to the y axis", "[rotation][exact]") {
  const Grid grid{{7, 4}, 0.5, 2, {true, false}};
  auto slope = [](double x, double y) { return 3 * x + 0.25 * y; };
  const Field z = sample(grid, slope);
  for (int quarters : {1, 2, 3, -1, 5}) {
    const double c = std::round(std::cos(quarters * pi / 2)), s = std::round(std::sin(quarters * pi / 2));
    const Grid turned = turned_quarters(grid, quarters);
    CHECK(turned.periodic.x == (quarters % 2 == 0));
    const Field expected =
        sample(turned, [&](double x, double y) { return slope(c * x + s * y, c * y - s * x); });
    CHECK((turned_quarters(z, quarters) == expected).all());
    CHECK((rotated(z, grid, quarters * pi / 2) == expected).all());
    CHECK(rotated_grid(grid, quarters * pi / 2).shape == turned.shape);
  }
}

// Lagrange's weights of 6 points have a sum of sizes below 8 next to an edge, on both axes.
TEST_CASE("a polynomial of degree 5 is turned exactly, and outside is missing", "[rotation][exact]") {
  const Grid grid{{30, 24}, 0.1, 0.15};
  auto form = [](double x, double y) {
    return 1 + x - 0.3 * y + x * x * y - std::pow(y, 5) / 4 + std::pow(x, 3) * y * y / 9;
  };
  const Field z = sample(grid, form);
  for (double angle : {0.3, -1.1, 2.5, 20.0}) {
    const Grid turned = rotated_grid(grid, angle);
    const double c = std::cos(angle), s = std::sin(angle);
    const Field expected = sample(turned, [&](double x, double y) {
      const double u = c * x + s * y, v = c * y - s * x;
      const bool inside = std::abs(u) <= 29 * 0.05 + 1e-12 && std::abs(v) <= 23 * 0.075 + 1e-12;
      return inside ? form(u, v) : none;
    });
    CHECK(largest_difference(rotated(z, grid, angle), expected) <= 64 * 4 * epsilon * z.abs().maxCoeff());
    CHECK((!rotated(z, grid, angle).isNaN()).count() >
          646);  // of 29 × 23 cells, less half a cell round about
  }
}

// Degree 5 at the middle of 6 points: f⁽⁶⁾ Δ⁶ (1/2 · 3/2 · 5/2)²/6! = (qΔ)⁶ 5/1024.
TEST_CASE("a turned wave has the error of Lagrange's interpolation, of order 6", "[rotation][order]") {
  double coarse = 0;
  for (Index n : {40, 80, 160}) {
    const Grid grid{{n, 24}, 80.0 / static_cast<double>(n), 3.1, true};
    const double q = 2 * pi / 20;
    auto wave = [=](double x, double) { return std::sin(q * x); };
    const Field z = sample(grid, wave);
    const double angle = 0.3;
    const Field error = rotated(z, grid, angle) - sample(rotated_grid(grid, angle), [=](double x, double y) {
                          return wave(std::cos(angle) * x + std::sin(angle) * y, 0);
                        });
    const double fine = error.isNaN().select(0, error).abs().maxCoeff();
    CHECK(fine <= 1.02 * std::pow(q * grid.dx, 6) * 5 / 1024);
    CHECK(fine >= 0.9 * std::pow(q * grid.dx, 6) * 5 / 1024 * (n == 40 ? 0.8 : 1));
    if (coarse > 0) CHECK(std::abs(observed_order(coarse, fine) - 6) <= 0.3);
    coarse = fine;
  }
}

TEST_CASE("a missing point makes those missing that it would have a weight in", "[rotation][contract]") {
  const Grid grid{{40, 40}, 1, 1};
  Field z = random_field(grid.shape, 63);
  const Field whole = rotated(z, grid, 0.4);
  z(20, 20) = none;
  const Field holed = rotated(z, grid, 0.4);
  const Index lost = holed.isNaN().count() - whole.isNaN().count();
  CHECK(lost >= 20);
  CHECK(lost <= 49);  // within 3 cells of it along both axes: 36 cells in the mean
  CHECK(holed.isNaN().select(0, holed - whole).abs().maxCoeff() == 0);
  CHECK_THROWS_AS(rotated(z, grid, std::nan("")), ParameterError);
  CHECK(largest_difference(rotated(z, grid, 0.4, 3), holed) == 0);
}

// ---- the seam ----

TEST_CASE("the jump at a seam is the difference of the ends, and a tilt closes its mean", "[seam][exact]") {
  const Grid grid{{50, 30}, 1, 1};
  const Field rough = random_field(grid.shape, 64);
  const Field tilted = rough + sample(grid, [](double x, double y) { return 0.7 * x + 0.1 * y; });
  for (const Axis1D axis : {Axis1D::x, Axis1D::y}) {
    const Field z = axis == Axis1D::x ? tilted : Field(tilted.transpose());
    const SeamJump jump = seam_jump(z, axis);
    const Eigen::ArrayXd exact = tilted.row(0) - tilted.row(49);
    CHECK(jump.pairs == 30);
    CHECK(std::abs(jump.mean - exact.mean()) <= 100 * epsilon * 40);
    CHECK(std::abs(jump.rms - std::sqrt(exact.square().mean())) <= 100 * epsilon * 40);
    CHECK(jump.largest == exact.abs().maxCoeff());
    const Field closed = closed_by_tilt(z, axis);
    CHECK(std::abs(seam_jump(closed, axis).mean) <= 100 * epsilon * 40);
    const Field change = axis == Axis1D::x ? Field(closed - z) : Field((closed - z).transpose());
    CHECK((change.colwise() - change.col(0)).abs().maxCoeff() <=
          100 * epsilon * 40);  // a slope along the axis
    CHECK((change.row(2) - 2 * change.row(1)).abs().maxCoeff() <= 100 * epsilon * 40);
  }
}

// f at the first point is sin²(πΔ/4ℓ), in the middle of the taper a half.
TEST_CASE("a taper brings the ends to the mean and leaves the middle", "[seam][exact]") {
  const Grid grid{{40, 12}, 0.5, 1};
  const Field z = random_field(grid.shape, 65);
  const double level = z.mean();
  const Field tapered = closed_by_taper(z, grid, Axis1D::x, 4);
  const double first = std::pow(std::sin(pi * 0.5 / (4 * 4)), 2);
  CHECK((tapered.row(0) - level - first * (z.row(0) - level)).abs().maxCoeff() <= 10 * epsilon);
  CHECK((tapered.row(39) - level - first * (z.row(39) - level)).abs().maxCoeff() <= 10 * epsilon);
  CHECK((tapered.middleRows(8, 24) == z.middleRows(8, 24)).all());
  CHECK(seam_jump(tapered, Axis1D::x).largest <= 2 * first * 2);
  for (double length : {0.0, 0.4, 10.5, std::nan(""), HUGE_VAL})
    CHECK_THROWS_AS(closed_by_taper(z, grid, Axis1D::x, length), ParameterError);
}

TEST_CASE("pairs with a missing end do not count at a seam", "[seam][contract]") {
  Field z = random_field({20, 10}, 66);
  z(0, 3) = none, z(19, 7) = none;
  CHECK(seam_jump(z, Axis1D::x).pairs == 8);
  CHECK((closed_by_tilt(z, Axis1D::x).isNaN() == z.isNaN()).all());
  z.row(0).setConstant(none);
  CHECK_THROWS_AS(seam_jump(z, Axis1D::x), DataError);
  CHECK_THROWS_AS(seam_jump(Field::Ones(2, 5), Axis1D::x), DataError);
}
