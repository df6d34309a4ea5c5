// Fields on finer grids, against the functions that they were sampled from.
#include "transform/refinement.hpp"

#include <numbers>

#include "core/error.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr double turn = 2 * std::numbers::pi;

// f at the centres of A cells a point, in points from the first.
template <class Function>
Field sampled(Shape shape, Shape factor, Function f) {
  return Field::NullaryExpr(shape.nx, shape.ny, [&](Index i, Index j) {
    return f((static_cast<double>(i) + 0.5) / static_cast<double>(factor.nx) - 0.5,
             (static_cast<double>(j) + 0.5) / static_cast<double>(factor.ny) - 0.5);
  });
}

double through(const Field& fine, const Field& coarse, Shape factor) {
  double worst = 0;
  for (Index i = 0; i < coarse.rows(); ++i)
    for (Index j = 0; j < coarse.cols(); ++j)
      worst = std::max(
          worst, std::abs(fine(i * factor.nx + factor.nx / 2, j * factor.ny + factor.ny / 2) - coarse(i, j)));
  return worst;
}

Grid grid_with(Shape shape, bool periodic) { return {shape, 2e-6, 3e-6, periodic}; }

}  // namespace

// Values below 1: ε log2 of the points, a few times over, of both axes.
TEST_CASE("a refined field goes through the same points, whatever it is, on any shape",
          "[refinement][exact]") {
  for (const bool periodic : {true, false})
    for (const Shape shape :
         {Shape{1, 1}, Shape{1, 16}, Shape{17, 1}, Shape{2, 3}, Shape{24, 18}, Shape{15, 7}})
      for (const Shape factor : {Shape{1, 1}, Shape{3, 3}, Shape{5, 1}, Shape{3, 5}}) {
        CAPTURE(periodic, shape.nx, shape.ny, factor.nx, factor.ny);
        const Field z = random_field(shape, 3);
        const Grid coarse = grid_with(shape, periodic), grid = refined_grid(coarse, factor);
        const Field fine = refined(z, coarse, factor);
        CHECK(shape_of(fine) == grid.shape);
        CHECK(grid.shape == Shape{shape.nx * factor.nx, shape.ny * factor.ny});
        CHECK(through(fine, z, factor) <= 40 * epsilon);
      }
}

// Waves up to one below the highest, which itself is a cosine. Arguments up to 2π 31 and 2π 23 are rounded by 350 ε
// before their sines are taken, of the samples and of what they are compared to.
TEST_CASE("a sum of waves that fit the period is met between the points to round-off",
          "[refinement][exact]") {
  for (const Shape shape : {Shape{16, 12}, Shape{15, 12}, Shape{9, 7}, Shape{64, 48}})
    for (const Shape factor : {Shape{2, 2}, Shape{4, 3}}) {
      const double nx = static_cast<double>(shape.nx), ny = static_cast<double>(shape.ny);
      const Index kx = (shape.nx - 1) / 2, ky = (shape.ny - 1) / 2;
      auto f = [&](double x, double y) {
        const double high = shape.ny % 2 == 0 ? std::cos(turn * y / 2) * std::sin(turn * x / nx + 1) : 0;
        return 0.3 + std::sin(turn * static_cast<double>(kx) * x / nx - turn * 2 * y / ny + 0.4) +
               std::cos(turn * x / nx + turn * static_cast<double>(ky) * y / ny + 2) + high;
      };
      CAPTURE(shape.nx, shape.ny, factor.nx, factor.ny);
      const Field fine = refined(sampled(shape, {1, 1}, f), grid_with(shape, true), factor);
      CHECK((fine - sampled(shape_of(fine), factor, f)).abs().maxCoeff() <= 1000 * epsilon);
    }
}

// The highest wave of an even period, between the points: its cosine, the same from both sides; 8π is rounded.
TEST_CASE("the highest wave of an even period stays real and symmetric", "[refinement][exact]") {
  Field z(1, 8);
  z << 1, -1, 1, -1, 1, -1, 1, -1;
  const Field fine = refined(z, grid_with({1, 8}, true), {1, 4});
  for (Index m = 0; m < 32; ++m)
    CHECK(std::abs(fine(0, m) - std::cos(turn * ((static_cast<double>(m) + 0.5) / 4 - 0.5) / 2)) <=
          64 * epsilon);
}

// ε of 64² a²/2 = 2048 and its sums.
TEST_CASE("a form of degree 2 that is not periodic is met to round-off, to the edges",
          "[refinement][exact]") {
  for (const Shape shape : {Shape{64, 48}, Shape{3, 3}, Shape{2, 9}, Shape{1, 5}}) {
    auto f = [&](double x, double y) {
      const double xx = shape.nx > 2 ? x * x : 0, xy = shape.nx > 1 ? x * y : 0;
      return 5 + (shape.nx > 1 ? 0.25 * x : 0) - 0.5 * y + 0.5 * xx - 0.3 * y * y + 0.125 * xy;
    };
    CAPTURE(shape.nx, shape.ny);
    const Field fine = refined(sampled(shape, {1, 1}, f), grid_with(shape, false), {4, 3});
    CHECK((fine - sampled(shape_of(fine), {4, 3}, f)).abs().maxCoeff() <= 2048 * 20 * epsilon);
  }
}

// Below a parabola of a sphere, waves of 8 points with their own phase: two points away from the edge the mirror
// has an error of less than 2 % of their amplitude, in the middle of 64 points of 1e-3. cos(πk(x+½)/n) is met
// exactly.
TEST_CASE("waves that do not fit are met away from the edges, and mirrored cosines everywhere",
          "[refinement][law]") {
  const Shape shape{64, 48}, factor{4, 4};
  auto waves = [](double x, double y) { return std::sin(turn * x / 8.3 + 1) * std::cos(turn * y / 9.1 + 2); };
  auto f = [&](double x, double y) {
    return waves(x, y) - 0.01 * (x - 30) * (x - 30) - 0.01 * (y - 20) * (y - 20);
  };
  const Field error =
      refined(sampled(shape, {1, 1}, f), grid_with(shape, false), factor) - sampled({256, 192}, factor, f);
  CHECK(error.abs().maxCoeff() <= 0.2);
  CHECK(error.block(10, 10, 256 - 20, 192 - 20).abs().maxCoeff() <= 0.02);
  CHECK(error.block(80, 60, 90, 70).abs().maxCoeff() <= 1e-3);
  auto cosine = [](double x, double y) {
    return std::cos(turn / 2 * 7 * (x + 0.5) / 64) * std::cos(turn / 2 * 46 * (y + 0.5) / 48);
  };
  const Field exact = refined(sampled(shape, {1, 1}, cosine), grid_with(shape, false), factor);
  CHECK((exact - sampled({256, 192}, factor, cosine)).abs().maxCoeff() <= 200 * epsilon);
}

// Neighbours on both sides of the crest's flank: a difference over h of sin is that of its slope in the middle,
// less h²/24 of it and h⁴/1920; the middle, 8 - ½ points from the first, is the same for every even factor.
TEST_CASE("slopes by differences approach those of the waves at order 2", "[refinement][order]") {
  const Shape shape{1, 64};
  auto f = [](double, double y) { return std::sin(turn * (y + 0.5) / 16); };
  const Field z = sampled(shape, {1, 1}, f);
  double before = 0;
  for (const Index factor : {2, 4, 8}) {
    const Field fine = refined(z, grid_with(shape, true), {1, factor});
    const double h = turn / 16 / static_cast<double>(factor),
                 slope = (fine(0, 16 * factor) - fine(0, 16 * factor - 1)) / h;
    const double error = 1 - slope;
    CHECK(error == Approx(h * h / 24).epsilon(h * h / 60));
    if (before > 0) CHECK(observed_order(before, error) == Approx(2).margin(0.03));
    before = error;
  }
}

TEST_CASE("a refined grid keeps the domain and the places of its points", "[refinement][exact]") {
  for (const bool periodic : {true, false}) {
    const Grid coarse = grid_with({5, 4}, periodic), fine = refined_grid(coarse, {3, 2});
    CHECK(relative_error(fine.size_x(), coarse.size_x()) <= 2 * epsilon);
    CHECK(relative_error(fine.size_y(), coarse.size_y()) <= 2 * epsilon);
    for (Index i = 0; i < 5; ++i) CHECK(std::abs(fine.x(3 * i + 1) - coarse.x(i)) <= 1e-20);
    for (Index j = 0; j < 4; ++j)
      CHECK(std::abs((fine.y(2 * j) + fine.y(2 * j + 1)) / 2 - coarse.y(j)) <= 1e-20);
  }
}

TEST_CASE("what cannot be refined is refused", "[refinement][contract]") {
  Field z = random_field({4, 4}, 1);
  CHECK_THROWS_AS(refined(z, grid_with({4, 4}, true), {0, 2}), ParameterError);
  CHECK_THROWS_AS(refined_grid(grid_with({4, 4}, true), {2, -1}), ParameterError);
  z(2, 1) = NAN;
  CHECK_THROWS_AS(refined(z, grid_with({4, 4}, true), {2, 2}), DataError);
  z(2, 1) = INFINITY;
  CHECK_THROWS_AS(refined(z, grid_with({4, 4}, false), {2, 2}), DataError);
}
