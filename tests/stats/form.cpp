// What is left of heights without their form, and of waves after the Gaussian filter.
#include "stats/filter/form.hpp"

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "fields.hpp"
#include "stats/filter/gaussian_filter.hpp"
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
