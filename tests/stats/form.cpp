// Forms, and the cut-offs that prepare a surface.
#include "stats/filter/form.hpp"

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "fields.hpp"
#include "holes.hpp"
#include "stats/filter/gaussian_filter.hpp"
#include "stats/filter/outliers.hpp"
#include "stats/filter/preparation.hpp"
#include "stats/sample/moments.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

double power(double x, int k) { return std::pow(x, k); }

// Σ over the samples of the field of weight × height over Σ weight, at one point.
double brute_force(const Field& z, const Grid& grid, double cutoff, Index i, Index j) {
  const double alpha = std::sqrt(std::numbers::ln2 / std::numbers::pi);
  double sum = 0, weights = 0;
  for (Index k = 0; k < z.rows(); ++k)
    for (Index l = 0; l < z.cols(); ++l) {
      const double x = static_cast<double>(k - i) * grid.dx, y = static_cast<double>(l - j) * grid.dy;
      const double w = std::exp(-std::numbers::pi * (x * x + y * y) / (alpha * alpha * cutoff * cutoff));
      sum += w * z(k, l);
      weights += w;
    }
  return sum / weights;
}

}  // namespace

// The polynomial's values reach d + 1; each of its (d+1)(d+2)/2 coefficients errs by ε √N of its norm, at
// most √N times its largest value, and a basis function reaches √((2d+1)²/N) times √N of that: ε (d+1)²
// (2d+1)² bounds it amply.
TEST_CASE("a polynomial of the form's degree leaves nothing but round-off", "[form][exact]") {
  for (int degree : {0, 1, 2, 5, 12}) {
    const Field z = Field::NullaryExpr(33, 48, [=](Index i, Index j) {
      const double x = static_cast<double>(i) / 16 - 1, y = static_cast<double>(j) / 24 - 1;
      double sum = 0.5;
      for (int a = 0; a <= degree; ++a) sum += power(x, a) * power(y, degree - a);
      return sum;
    });
    CAPTURE(degree);
    const double d = degree + 1;
    CHECK(remove_form(z, degree).abs().maxCoeff() <= epsilon * d * d * (2 * d + 1) * (2 * d + 1));
  }
}

TEST_CASE("what is left is orthogonal to every polynomial of the degree, and none is removed twice",
          "[form][law]") {
  const Field z = random_field({24, 37}, 9), rest = remove_form(z, 3);
  for (int a = 0; a <= 3; ++a)
    for (int b = 0; a + b <= 3; ++b) {
      double sum = 0;
      for (Index i = 0; i < 24; ++i)
        for (Index j = 0; j < 37; ++j)
          sum += power(static_cast<double>(i) / 24, a) * power(static_cast<double>(j) / 37, b) * rest(i, j);
      CHECK(std::abs(sum) <= 24 * 37 * epsilon * z.abs().maxCoeff());  // N terms of at most max|z|
    }
  CHECK((remove_form(rest, 3) - rest).abs().maxCoeff() <= 100 * epsilon * z.abs().maxCoeff());
  CHECK(moments(remove_form(z, 4)).sq < moments(rest).sq);
}

TEST_CASE("a profile of three points has no form beyond degree 2", "[form][contract]") {
  const Field z = random_field({3, 1}, 4);
  CHECK(remove_form(z, 6).abs().maxCoeff() <= 10 * epsilon * z.abs().maxCoeff());
  CHECK_THROWS_AS(remove_form(z, -1), ParameterError);
  CHECK_THROWS_AS(remove_form(z, 21), ParameterError);
}

TEST_CASE("the Gaussian filter is the weighted mean over the samples within the edges", "[filter][exact]") {
  const Grid uneven{{23, 40}, 0.7, 1.1};
  const Field z = random_field(uneven.shape, 3) + 5;
  const Field mean_surface = gaussian_mean_surface(z, uneven, 6);
  for (const auto& [i, j] : {std::pair<Index, Index>{0, 0}, {22, 39}, {11, 17}, {0, 20}, {22, 1}})
    CHECK(std::abs(mean_surface(i, j) - brute_force(z, uneven, 6, i, j)) <= 100 * epsilon * 6);
}

// exp2(-(λc/λ)²), half at the cut-off.
TEST_CASE("a wave on a periodic surface passes with the amplitude of ISO 16610-61", "[filter][exact]") {
  const Grid grid{{60, 45}, 0.5, 2, true};
  for (double cutoff : {4.0, 10.0, 30.0}) {
    const Field wave = sine(grid.shape, 1, 3);  // wavelength 10
    const double transmitted = std::exp2(-cutoff * cutoff / 100);
    CHECK((gaussian_mean_surface(wave, grid, cutoff) - transmitted * wave).abs().maxCoeff() <= 50 * epsilon);
  }
}

// Two waves of λ = 10 along x and 18 along y. Along the free axis, 3 λc from its ends, the weight's aliases of
// (λc/Δ)² = 25 pass.
TEST_CASE("along its periodic axis a surface passes as a periodic one, up to the seam", "[filter][exact]") {
  const Grid grid{{60, 90}, 0.5, 1, Periodic{true, false}};
  const Field along = sine(grid.shape, 1, 3), across = sine({90, 60}, 1, 5).transpose();
  const Field surface = gaussian_mean_surface(along + across, grid, 5);
  const Field exact = std::exp2(-25.0 / 100) * along + std::exp2(-25.0 / 324) * across;
  CHECK((surface - exact).middleCols(15, 60).abs().maxCoeff() <= 3 * std::exp2(-25 * 0.85) + 100 * epsilon);
  const Field turned =
      gaussian_mean_surface((along + across).transpose(), {{90, 60}, 1, 0.5, {false, true}}, 5);
  CHECK((turned.transpose() - surface).abs().maxCoeff() <= 100 * epsilon);
}

// In the middle of a long field, 3 λc from its ends; the weight summed over samples lets the aliases of
// (λc/Δ)² pass.
TEST_CASE("a wave far from the edges passes with the same amplitude but for the aliases of the weight",
          "[filter][order]") {
  const Index n = 480;
  const Grid grid{{n, 8}, 1, 1};
  const Field wave = sine(grid.shape, 1, 24);  // wavelength 20
  for (double cutoff : {3.0, 4.0, 6.0, 20.0}) {
    const double transmitted = std::exp2(-cutoff * cutoff / 400);
    const double aliases = 2 * std::exp2(-cutoff * cutoff * (1 - 0.05) * (1 - 0.05));
    const Field error = gaussian_mean_surface(wave, grid, cutoff) - transmitted * wave;
    CAPTURE(cutoff);
    CHECK(error.middleRows(n / 2 - 60, 120).abs().maxCoeff() <= 1.5 * aliases + 100 * epsilon);
  }
}

TEST_CASE("a constant passes the filter as it is, at the edges too, however high it lies", "[filter][law]") {
  const Grid field{{31, 20}, 1, 1};
  CHECK((gaussian_mean_surface(Field::Constant(31, 20, 1e9), field, 12) - 1e9).abs().maxCoeff() == 0);
  const Field z = random_field(field.shape, 8);
  const Field shifted = gaussian_mean_surface(z + 1e3, field, 12) - 1e3;
  CHECK((shifted - gaussian_mean_surface(z, field, 12)).abs().maxCoeff() <= 10 * epsilon * 1e3);
}

// Weights of a cut-off c times the field's diagonal d differ by π²/(c² ln 2) at the most.
TEST_CASE("a cut-off far beyond the field leaves its mean, however far", "[filter][law]") {
  const Grid field{{20, 31}, 1, 1};
  const Field z = random_field(field.shape, 5);
  for (double beyond : {1e3, 1e9, 1e200}) {
    const double bound = 15 / (beyond * beyond) + 100 * epsilon;
    const Field surface = gaussian_mean_surface(z, field, beyond * 37);
    CHECK((surface - z.mean()).abs().maxCoeff() <= bound * z.abs().maxCoeff());
  }
}

TEST_CASE("a cut-off below two samples or not finite is refused", "[filter][contract]") {
  const Grid field{{8, 8}, 1, 2};
  for (double cutoff : {0.0, -5.0, 3.9, std::nan(""), HUGE_VAL})
    CHECK_THROWS_AS(gaussian_mean_surface(Field::Ones(8, 8), field, cutoff), ParameterError);
}

// The points of a disc have Gram's matrices of condition 10² to 10⁴ here: round-off 225 ε times that.
TEST_CASE("combinations of products are orthonormal over the measured points", "[form][exact]") {
  const Field points = Field::NullaryExpr(15, 15, [](Index i, Index j) {
    return std::hypot(static_cast<double>(i - 7), static_cast<double>(j - 7)) < 7.5 ? 1.0 : 0.0;
  });
  for (const int degree : {0, 1, 4}) {
    const AxisProducts products = polynomials({15, 15}, degree);
    Eigen::MatrixXd gram = products.none();
    products.add(gram, points);
    const Eigen::MatrixXd T = orthonormal(gram, 1e-10);
    REQUIRE(T.rows() == products.count());
    for (Index k = 0; k < T.rows(); ++k)
      for (Index l = 0; l <= k; ++l) {
        const Field a = products.combined(T.row(k).transpose()), b = products.combined(T.row(l).transpose());
        CHECK(std::abs((points * a * b).sum() - (k == l)) <= 1e-9);
      }
  }
}

// ---- curved form ----

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

// ---- preparation ----

// A form of degree d has taken d(d+3)/2 waves: 27, 14, 9, 5, 2 for 6, 4, 3, 2, 1; of a row d.
TEST_CASE("a part of a field has lost its share of the waves of a form", "[form][exact]") {
  const Grid grid{{64, 64}, 1e-6, 1e-6}, row{{64, 1}, 1e-6, 1e-6};
  for (const int degree : {0, 1, 2, 6, 20}) {
    CHECK(degree_on_part(degree, grid, 1) == degree);
    CHECK(degree_on_part(degree, row, 1) == degree);
  }
  CHECK(degree_on_part(6, grid, 0.25) == 2);  // 6.75 waves, below 7
  CHECK(degree_on_part(6, grid, 0.5) == 4);   // 13.5
  CHECK(degree_on_part(2, grid, 0.25) == 1);  // 1.25, above 1
  CHECK(degree_on_part(1, grid, 0.25) == 0);  // 0.5
  CHECK(degree_on_part(6, row, 0.5) == 3);
}

// A cut-off of a tenth of the side passes a share below (1 - 2^-0.16)² = 0.011 of each of the 14 waves of degree
// 4; one of ten sides, above (1 - 2^-25)² of all.
TEST_CASE("an L-filter takes the waves of a form below its cut-off itself", "[form][exact]") {
  const Grid grid{{64, 64}, 1e-6, 1e-6};
  for (const int degree : {0, 1, 4}) {
    CHECK(degree_behind(degree, grid, {6.4e-6}) == 0);
    CHECK(degree_behind(degree, grid, {640e-6}) == degree);
  }
  for (int degree = 1; degree < 20; ++degree)
    CHECK(degree_behind(degree, grid, {40e-6}) <= degree_behind(degree + 1, grid, {40e-6}));
}

// It was spanned over a hole at the edge as if the other side were not there.
TEST_CASE("a membrane spans a seam as any other place", "[fill][law]") {
  const Grid grid{{18, 12}, 1e-6, 2e-6, {true, true}};
  Field z = random_field(grid.shape, 3);
  z.block(7, 4, 5, 3).setConstant(none);
  const Field inside = filled(z, grid, Filling::laplace);
  const auto turned = [](const Field& f, Index a, Index b) {
    return Field::NullaryExpr(
               f.rows(), f.cols(),
               [&f, a, b](Index i, Index j) { return f((i + a) % f.rows(), (j + b) % f.cols()); })
        .eval();
  };
  const Field across = filled(turned(z, 9, 5), grid, Filling::laplace);
  CHECK((across - turned(inside, 9, 5)).abs().maxCoeff() <= 1e3 * epsilon);
  // Along a free axis there is no height beyond the edge.
  const Grid free{grid.shape, grid.dx, grid.dy};
  CHECK((filled(turned(z, 9, 5), free, Filling::laplace) - across).abs().maxCoeff() > 0.1);
}
