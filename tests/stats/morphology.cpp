// What a ball or a disc touches.
#include "stats/filter/morphology.hpp"

#include "core/error.hpp"
#include "fields.hpp"
#include "holes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

using Kind = StructuringElement::Kind;

// max_d z(x + d) + b(d) over all points and, of a periodic axis, their images.
Field brute_force(const Field& z, const Grid& grid, StructuringElement element) {
  Field out = Field::Constant(z.rows(), z.cols(), none);
  const Index images_x = grid.periodic.x ? 1 : 0, images_y = grid.periodic.y ? 1 : 0;
  const double r = element.radius;
  auto consider = [&](Index i, Index j, Index k, Index l, Index a, Index b) {
    const double u = grid.dx * static_cast<double>(k + a * z.rows() - i),
                 v = grid.dy * static_cast<double>(l + b * z.cols() - j), d = u * u + v * v;
    if (d > r * r || std::isnan(z(k, l))) return;
    out(i, j) = std::max(out(i, j), z(k, l) + (element.kind == Kind::ball ? std::sqrt(r * r - d) - r : 0));
  };
  for (Index i = 0; i < z.rows(); ++i)
    for (Index j = 0; j < z.cols(); ++j) {
      if (std::isnan(z(i, j))) continue;
      out(i, j) = -HUGE_VAL;
      for (Index k = 0; k < z.rows(); ++k)
        for (Index l = 0; l < z.cols(); ++l)
          for (Index a = -images_x; a <= images_x; ++a)
            for (Index b = -images_y; b <= images_y; ++b) consider(i, j, k, l, a, b);
    }
  return out;
}

const std::array periods{Periodic{}, Periodic{true}, Periodic{true, false}, Periodic{false, true}};

}  // namespace

// Both form z + b, the brute force with the rounding of r: ε (max|z| + r) each.
TEST_CASE("a dilation is the largest of all heights plus the element, whatever axes are periodic",
          "[morphology][exact]") {
  for (const Periodic periodic : periods)
    for (const double r : {0.3, 2.0, 5.0, 50.0})
      for (const Kind kind : {Kind::ball, Kind::disc}) {
        const Grid grid{{21, 26}, 0.7, 1.1, periodic};
        const Field z = with_holes(random_field(grid.shape, 7), 0.2, 8);
        const Field fast = dilation(z, grid, {kind, r}), slow = brute_force(z, grid, {kind, r});
        CAPTURE(periodic.x, periodic.y, r, kind == Kind::ball);
        CHECK((fast.isNaN() == z.isNaN()).all());
        CHECK(largest_difference(fast, slow) <= 4 * epsilon * (1 + r));
      }
}

TEST_CASE("a closing lies on or above, an opening on or below the heights, and neither changes it again",
          "[morphology][law]") {
  for (const Periodic periodic : periods)
    for (const Kind kind : {Kind::ball, Kind::disc}) {
      const Grid grid{{30, 23}, 1, 0.6, periodic};
      const StructuringElement element{kind, 4};
      const Field z = with_holes(random_field(grid.shape, 17), 0.1, 18);
      const Field closed = closing(z, grid, element), opened = opening(z, grid, element);
      const double round_off = 4 * epsilon * 5;
      CHECK((z.isNaN() || closed >= z - round_off).all());
      CHECK((z.isNaN() || opened <= z + round_off).all());
      CHECK((closed - z).isNaN().select(0, closed - z).maxCoeff() > 0.1);
      CHECK(largest_difference(closing(closed, grid, element), closed) <= round_off);
      CHECK(largest_difference(opening(opened, grid, element), opened) <= round_off);
      CHECK((closing(Field::Constant(30, 23, 2.5), grid, element) == 2.5).all());
    }
}

// Where nothing is missing between them, D and E are each other's adjoint: D(z) ≤ w exactly if z ≤ E(w).
TEST_CASE("erosion is the adjoint of dilation", "[morphology][law]") {
  const Grid grid{{24, 24}, 1, 1, true};
  const StructuringElement ball{Kind::ball, 6};
  const Field z = random_field(grid.shape, 1), w = dilation(z, grid, ball) + 1e-9;
  CHECK((erosion(w, grid, ball) >= z).all());
  Field lower = w;
  lower(5, 7) -= 2;  // now D(z) > w there, and E(w) < z where the ball touched
  CHECK((erosion(lower, grid, ball) < z).any());
}

// A valley of the ball's own shape is touched everywhere. Of a deep one of the same width the ball touches the
// rims only, at z = 0 and a distance a from the middle, and sags between them by r - √(r² - a²).
TEST_CASE("a closing leaves what the ball fits into and bridges what is narrower", "[morphology][exact]") {
  const Grid grid{{81, 1}, 0.05, 1};
  const double r = 1, a = 0.5;
  auto valley = [&](double radius, double half_width) {
    return sample(grid, [=](double x, double) {
      return std::abs(x) < half_width + 1e-9
                 ? std::sqrt(radius * radius - half_width * half_width) - std::sqrt(radius * radius - x * x)
                 : 0.0;
    });
  };
  const Field fits = valley(r, a);
  CHECK((closing(fits, grid, {Kind::ball, r}) - fits).abs().maxCoeff() <= 8 * epsilon);
  const Field narrow = (fits < -1e-9).select(-1, Field::Zero(81, 1));
  CHECK((closing(narrow, grid, {Kind::ball, r}) - fits).abs().maxCoeff() <= 8 * epsilon);
}

// The ball touches every point of a wider bowl. Its middle is within Δ/2 of the best place along both axes, which
// moves the touched point by R/(R - r) = 3 times that: the closing lies above by 2 (3Δ/2)²/2 (1/r - 1/R) at most,
// and nowhere below. The latter failed where points were
// hidden that the ball touches, by half of what it bends.
TEST_CASE("a ball touches all of a bowl that is wider than it", "[morphology][law]") {
  const Grid grid{{41, 41}, 0.05, 0.05};
  const double r = 20, R = 30;
  const Field bowl = sample(grid, [=](double x, double y) { return (x * x + y * y) / (2 * R); });
  const Field gap = closing(bowl, grid, {Kind::ball, r}) - bowl;
  CHECK(gap.minCoeff() >= -8 * epsilon * r);
  CHECK(gap.maxCoeff() <= 1.1 * 9 * 0.025 * 0.025 * (1 / r - 1 / R));
}

// A spike of height H on a plane, dilated, is the ball's cap: H - (r - √(r² - d²)) down to the plane.
TEST_CASE("a dilated spike is the ball", "[morphology][exact]") {
  const Grid grid{{41, 41}, 0.1, 0.1};
  Field z = Field::Zero(41, 41);
  z(20, 20) = 0.4;
  const Field cap = sample(grid, [](double x, double y) {
    const double d = x * x + y * y;
    return d < 1 ? std::max(0.0, 0.4 - 1 + std::sqrt(1 - d)) : 0.0;
  });
  CHECK((dilation(z, grid, {Kind::ball, 1}) - cap).abs().maxCoeff() <= 8 * epsilon);
  Field cut = opening(z, grid, {Kind::ball, 1});  // the ball below rests on the plane's next points
  CHECK(std::abs(cut(20, 20) - (1 - std::sqrt(1 - 0.01))) <= 8 * epsilon);
  cut(20, 20) = 0;
  CHECK(cut.abs().maxCoeff() <= 8 * epsilon);
}

TEST_CASE("results of a ball do not depend on the threads", "[morphology][law]") {
  const Grid grid{{50, 40}, 1, 1};
  const Field z = gaussian_acf_field(grid.shape, 8, 3);
  CHECK((closing(z, grid, {Kind::ball, 30}, 1) == closing(z, grid, {Kind::ball, 30}, 3)).all());
}

TEST_CASE("a radius that is not above zero and finite is refused", "[morphology][contract]") {
  for (double r : {0.0, -1.0, std::nan(""), HUGE_VAL})
    CHECK_THROWS_AS(closing(Field::Ones(8, 8), grid(8, 8), {Kind::ball, r}), ParameterError);
}
