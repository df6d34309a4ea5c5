// Spheres and cylinders fitted to heights.
#include "stats/filter/curved_form.hpp"

#include "core/error.hpp"
#include "fields.hpp"
#include "holes.hpp"
#include "stats/filter/form.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const Grid map{{60, 45}, 0.02, 0.03};  // 1.2 × 1.35, half a diagonal of 0.9

// The upper (R > 0) or lower half of a sphere about (x0, y0, z0).
Field sphere(double R, double x0, double y0, double z0) {
  return sample(map, [=](double x, double y) {
    const double s = std::hypot(x - x0, y - y0);
    return z0 + std::copysign(std::sqrt(R * R - s * s), R);
  });
}

// Of a cylinder whose axis passes (x0, y0, z0) at an angle φ from x, level.
Field cylinder(double R, double phi, double x0, double y0, double z0) {
  return sample(map, [=](double x, double y) {
    const double s = -(x - x0) * std::sin(phi) + (y - y0) * std::cos(phi);
    return z0 + std::copysign(std::sqrt(R * R - s * s), R);
  });
}

}  // namespace

// Heights have an error of ε|z0 + R|; the fit weighs them to R by (R/L)², L = 0.9, times 10 for the middle of
// the field against its edge.
TEST_CASE("a sphere is recovered to round-off, dome or bowl, steep or flat", "[form][exact]") {
  for (double R : {1.0, -1.3, 7.0, -400.0}) {
    CAPTURE(R);
    const Field z = sphere(R, 0.1, -0.05, 3);
    const CurvedForm form = fit_curved_form(z, map, CurvedShape::sphere);
    const double height = epsilon * (3 + std::abs(R)), ratio = std::pow(R / 0.9, 2);
    CHECK(std::abs(form.radius - R) <= 10 * height * ratio);
    CHECK(std::abs(form.centre[0] - 0.1) <= 10 * height * (1 + std::abs(R)));
    CHECK(std::abs(form.centre[1] + 0.05) <= 10 * height * (1 + std::abs(R)));
    CHECK(std::abs(form.centre[2] - 3) <= 10 * height * ratio);
    CHECK(above_form(z, map, form).abs().maxCoeff() <= 10 * height);
    CHECK(form.steps <= 10);
  }
}

TEST_CASE("a cylinder is recovered to round-off with its axis", "[form][exact]") {
  for (double R : {1.1, -2.0, 300.0})
    for (double phi : {0.0, 0.4, 1.5, 2.9}) {
      CAPTURE(R, phi);
      const Field z = cylinder(R, phi, 0.05, 0.02, -2);
      const CurvedForm form = fit_curved_form(z, map, CurvedShape::cylinder);
      const double height = epsilon * (2 + std::abs(R)), ratio = std::pow(R / 0.6, 2);
      CHECK(std::abs(form.radius - R) <= 10 * height * ratio);
      const double along = form.axis[0] * std::cos(phi) + form.axis[1] * std::sin(phi);
      CHECK(std::abs(std::abs(along) - 1) <= 10 * height);
      CHECK(std::abs(form.axis[2]) <= 10 * height * (1 + std::abs(R)));
      CHECK(above_form(z, map, form).abs().maxCoeff() <= 20 * height);
    }
}

// A tilted cylinder: the level one turned about y, whose heights follow from its implicit equation.
TEST_CASE("a tilted cylinder is one too", "[form][exact]") {
  const double R = 2, tilt = 0.3, c = std::cos(tilt), s = std::sin(tilt);
  // axis (c, 0, s) through (0,0,-R): |d|² - (a·d)² = R²
  const Field z = sample(map, [=](double x, double y) {
    const double A = c * c, B = -2 * x * c * s, C = x * x * s * s + y * y - R * R;
    return -R + (-B + std::sqrt(B * B - 4 * A * C)) / (2 * A);
  });
  const CurvedForm form = fit_curved_form(z, map, CurvedShape::cylinder);
  CHECK(std::abs(form.radius - R) <= 100 * epsilon * 4 * R);
  CHECK(std::abs(form.axis[2] / form.axis[0] - s / c) <= 100 * epsilon);
  CHECK(above_form(z, map, form).abs().maxCoeff() <= 20 * epsilon * R);
}

// Of N independent heights of variance σ² the fitted sphere takes 4 degrees of freedom: Σ r² is σ² χ²(N-4), whose
// relative deviation is √(2/N) = 0.03. R is within 4 of its standard errors, of which the header says
// 10 R²σ/(L²√N).
TEST_CASE("roughness on a sphere, with holes, is what is left of it", "[form][statistics]") {
  const double R = 5, sigma = 1e-3;
  const Field rough = sigma * white_noise(map.shape, 11), z = with_holes(sphere(R, 0, 0, 0) + rough, 0.2, 12);
  const CurvedForm form = fit_curved_form(z, map, CurvedShape::sphere);
  const Field left = above_form(z, map, form);
  const double n = static_cast<double>((!z.isNaN()).count());
  CHECK((left.isNaN() == z.isNaN()).all());
  CHECK(std::abs(std::pow(form.rms / sigma, 2) - 1) <= 4 * std::sqrt(2 / n));
  CHECK(std::abs(form.radius - R) <= 4 * 10 * R * R * sigma / (0.81 * std::sqrt(n)));
  CHECK(std::abs(form.rms * form.rms * n - left.isNaN().select(0, left).square().sum()) <=
        1e-9 * n * sigma * sigma);
}

// The least squares are stationary: a move of R or of the centre by δ changes Σr² by O(δ²) only.
TEST_CASE("no sphere near the fitted one is nearer to the heights", "[form][law]") {
  const Field z = sphere(3, 0.1, 0.2, 0) + 0.01 * random_field(map.shape, 5);
  const CurvedForm form = fit_curved_form(z, map, CurvedShape::sphere);
  const double least = above_form(z, map, form).square().sum();
  for (double move : {1e-4, -1e-4}) {
    const auto& [x, y, c] = form.centre;
    CHECK(least < (z - sphere(form.radius + move, x, y, c)).square().sum());
    CHECK(least < (z - sphere(form.radius, x + move, y, c)).square().sum());
    CHECK(least < (z - sphere(form.radius, x, y + move, c)).square().sum());
    CHECK(least < (z - sphere(form.radius, x, y, c + move)).square().sum());
  }
}

TEST_CASE("points that do not determine a sphere or a cylinder are refused", "[form][contract]") {
  const Field plane = sample(map, [](double x, double y) { return 0.3 * x - 0.1 * y + 2; });
  for (const auto shape : {CurvedShape::sphere, CurvedShape::cylinder}) {
    CHECK_THROWS_AS(fit_curved_form(plane, map, shape), ParameterError);
    CHECK_THROWS_AS(fit_curved_form(Field::Constant(60, 45, 3.0), map, shape), ParameterError);
    CHECK_THROWS_AS(fit_curved_form(random_field({60, 1}, 1), {{60, 1}, 1, 1}, shape), ParameterError);
    Field few = Field::Constant(60, 45, none);
    few.topLeftCorner(2, 2).setZero();
    CHECK_THROWS_AS(fit_curved_form(few, map, shape), ParameterError);
    CHECK_THROWS_AS(fit_curved_form(Field::Constant(60, 45, none), map, shape), DataError);
  }
  // Noise: a curvature beyond three standard errors comes in 3 of a thousand; this seed has none.
  CHECK_THROWS_AS(fit_curved_form(white_noise(map.shape, 3) * 1e-3, map, CurvedShape::sphere),
                  ParameterError);
}

// An offset of 1 m on a ball of micrometres: heights keep the digits that the offset has left them.
TEST_CASE("a sphere far above zero loses only what the offset took", "[form][law]") {
  const Grid small{{40, 40}, 1e-6, 1e-6};
  const double R = 1e-3;
  const Field z = sample(small, [=](double x, double y) {
    const double s = x * x + y * y;
    return 1 - s / (R + std::sqrt(R * R - s));
  });
  const CurvedForm form = fit_curved_form(z, small, CurvedShape::sphere);
  CHECK(relative_error(form.radius, R) <= 1e-8);  // ε of the offset on a rise of 4e-7
  CHECK(above_form(z, small, form).abs().maxCoeff() <= 3 * epsilon);
}
