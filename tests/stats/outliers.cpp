// Points that stand out from all sides, and those that do not.
#include "stats/filter/outliers.hpp"

#include "core/error.hpp"
#include "fields.hpp"
#include "holes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::array periods{Periodic{}, Periodic{true}, Periodic{true, false}, Periodic{false, true}};

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
    for (const Periodic periodic : periods) {
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
