// What balls touch, and what stands out.
#include "stats/filter/morphology.hpp"

#include "core/error.hpp"
#include "fields.hpp"
#include "holes.hpp"
#include "stats/filter/outliers.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

using Kind = StructuringElement::Kind;

// max_d z(x + d) + b(d) over all points and, of a periodic axis, their images.
Field brute_ball(const Field& z, const Grid& grid, StructuringElement element) {
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

const std::array ball_periods{Periodic{}, Periodic{true}, Periodic{true, false}, Periodic{false, true}};

}  // namespace

// Both form z + b, the brute force with the rounding of r: ε (max|z| + r) each.
TEST_CASE("a dilation is the largest of all heights plus the element, whatever axes are periodic",
          "[morphology][exact]") {
  for (const Periodic periodic : ball_periods)
    for (const double r : {0.3, 2.0, 5.0, 50.0})
      for (const Kind kind : {Kind::ball, Kind::disc}) {
        const Grid grid{{21, 26}, 0.7, 1.1, periodic};
        const Field z = with_holes(random_field(grid.shape, 7), 0.2, 8);
        const Field fast = dilation(z, grid, {kind, r}), slow = brute_ball(z, grid, {kind, r});
        CAPTURE(periodic.x, periodic.y, r, kind == Kind::ball);
        CHECK((fast.isNaN() == z.isNaN()).all());
        CHECK(largest_difference(fast, slow) <= 4 * epsilon * (1 + r));
      }
}

TEST_CASE("a closing lies on or above, an opening on or below the heights, and neither changes it again",
          "[morphology][law]") {
  for (const Periodic periodic : ball_periods)
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

// ---- outliers ----

namespace {

Index removed(const Field& z, const OutlierRule& rule = {}) {
  return without_outliers(z, grid(z.rows(), z.cols()), rule).removed;
}

// 3 × 3 points of 40 and -60 and single ones of 9 deviations of white noise and more.
Field with_spikes(Field z) {
  z.block(20, 30, 3, 3) += 40;
  z.block(50, 11, 2, 2) -= 60;
  z(9, 9) += 30, z(40, 40) -= 25, z(0, 30) += 35, z(33, 63) -= 45;
  return z;
}
constexpr int of_spikes = 9 + 4 + 4;

}  // namespace

// A Gaussian surface loses 2 (1 - Φ(5)) = 6e-7 of its points whatever its correlation: 0.02 in 9 × 64².
// Distances from a median, which are large on the slopes of long waves, took a third of them.
TEST_CASE("a smooth or a rough surface without outliers keeps its points", "[outliers][statistics]") {
  for (const unsigned seed : {1, 2, 3}) {
    CHECK(removed(white_noise({64, 64}, seed)) == 0);
    CHECK(removed(gaussian_acf_field({64, 64}, 4, seed)) == 0);
    CHECK(removed(gaussian_acf_field({64, 64}, 20, seed)) == 0);
  }
}

// Sides that are alike in some direction, and heights in steps.
TEST_CASE("gratings, checkers, steps, ridges and tilts have no outliers", "[outliers][exact]") {
  const Shape shape{64, 60};
  auto of = [&](auto f) {
    return Field(Field::NullaryExpr(shape.nx, shape.ny, [&](Index i, Index j) { return double(f(i, j)); }));
  };
  const Field noise = 0.02 * white_noise(shape, 4);
  CHECK(removed(Field::Constant(64, 60, 3)) == 0);
  for (const Field& z :
       {of([](Index i, Index) { return i / 8 % 2; }),
        of([](Index i, Index j) { return (i / 8 + j / 8) % 2; }),
        of([](Index i, Index j) { return 5 * i + j < 150; }), of([](Index i, Index) { return i == 30; }),
        of([](Index i, Index j) { return i == j + 2; }),
        of([](Index i, Index j) { return 0.3 * double(i) - 7 * double(j); })}) {
    CHECK(removed(z) == 0);
    CHECK(removed(z + noise) == 0);
  }
  const Field smooth = gaussian_acf_field(shape, 12, 5);
  for (const double step : {0.01, 0.05, 0.3})
    CHECK(removed((smooth / step).round() * step, {.step = step}) == 0);
  CHECK(removed((0.25 * white_noise(shape, 15)).round(), {.step = 1}) == 0);  // 5 % one step off
}

TEST_CASE("spikes are found, on noise and on waves, at edges and seams", "[outliers][statistics]") {
  const Shape shape{64, 64};
  for (const Field& z : {white_noise(shape, 6), gaussian_acf_field(shape, 3, 7),
                         Field(white_noise(shape, 8) + 10 * sine(shape, 1, 1))}) {
    for (const Periodic periodic : ball_periods) {
      const Grid on{shape, 1, 1, periodic};
      const Field spiky = with_spikes(z);
      const Outliers found = without_outliers(spiky, on);
      CAPTURE(periodic.x, periodic.y);
      CHECK(found.removed == of_spikes);
      CHECK((found.heights.isNaN() == (spiky != z)).all());
      CHECK(largest_difference(found.heights, found.heights.isNaN().select(none, z)) == 0);
    }
  }
}

TEST_CASE("what stands out along a profile is found, and missing points are nothing", "[outliers][law]") {
  Field z = white_noise({1, 300}, 9);
  z(0, 50) += 30, z(0, 200) -= 40, z(0, 201) -= 40, z(0, 10) = none;
  const Field line = z.transpose();
  for (const Field& of : {z, line}) {
    const Outliers found = without_outliers(of, grid(of.rows(), of.cols()));
    CHECK(found.removed == 3);
    CHECK(found.heights.isNaN().count() == 4);
  }
  const Field holes = with_holes(with_spikes(white_noise({64, 64}, 10)), 0.1, 11);
  const Outliers found = without_outliers(holes, grid(64, 64));
  CHECK((found.heights.isNaN() == (holes.isNaN() || holes.abs() > 20)).all());
}

TEST_CASE("the width bounds what may stand out", "[outliers][exact]") {
  Field z = white_noise({64, 64}, 12);
  z.block(30, 30, 7, 7) += 60;
  CHECK(removed(z, {.width = {7, 7}}) == 49);
  CHECK(removed(z) == 1);  // two of three sides of the middle lie outside
  z.block(29, 29, 9, 9) = 60;
  CHECK(removed(z) == 0);
  const Outliers one = without_outliers(z, grid(64, 64), {.width = {7, 3}}, 1),
                 three = without_outliers(z, grid(64, 64), {.width = {7, 3}}, 3);
  CHECK(one.scales.size() == 3);  // 1, 3, 7x3
  CHECK(largest_difference(one.heights, three.heights) == 0);
}

// White noise: r has the variance 1 + 2/4 0.449, of the median of three 0.449.
TEST_CASE("deviations are those of a point above its sides, and heights scale", "[outliers][statistics]") {
  const Field z = with_spikes(white_noise({128, 128}, 13));
  const Outliers found = without_outliers(z, grid(128, 128)),
                 large = without_outliers(1e-6 * z + 3, grid(128, 128));
  CHECK(relative_error(found.scales.front().deviation, std::sqrt(1 + 0.449 / 2)) <= 4 * 1.17 / 128);
  CHECK((found.heights.isNaN() == large.heights.isNaN()).all());
  CHECK(std::abs(found.spiky - of_spikes / 128.0 / 128) <= 4e-5);
}

TEST_CASE("a map in which no point has two sides is refused, and so are wrong bounds",
          "[outliers][contract]") {
  for (const Shape shape : {Shape{1, 1}, Shape{3, 3}, Shape{1, 4}, Shape{4, 2}})
    CHECK_THROWS_AS(removed(Field::Ones(shape.nx, shape.ny)), ParameterError);
  CHECK(removed(Field::Ones(5, 1)) == 0);
  CHECK(removed(Field::Constant(9, 9, none)) == 0);
  const Field z = white_noise({20, 20}, 14);
  for (double k : {0.0, -1.0, std::nan(""), HUGE_VAL})
    CHECK_THROWS_AS(removed(z, {.bound = k}), ParameterError);
  CHECK_THROWS_AS(removed(z, {.width = {0, 3}}), ParameterError);
}
