#include "stats/sample/moments.hpp"

#include <gsl/gsl_statistics_double.h>

#include "core/error.hpp"
#include "fields.hpp"
#include "stats/filter/form.hpp"
#include "stats/sample/proportions.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// Of sums of n numbers, added row by row, each rounded.
double round_off(const Field& z) { return 4 * epsilon * static_cast<double>(z.rows() + z.cols()); }

void check_shape_equal(const Moments& m, const Moments& other, double scale, double tolerance) {
  CHECK(relative_error(m.sa, scale * other.sa) <= tolerance);
  CHECK(relative_error(m.sq, scale * other.sq) <= tolerance);
  CHECK(relative_error(m.sp, scale * other.sp) <= tolerance);
  CHECK(relative_error(m.sv, scale * other.sv) <= tolerance);
  CHECK(std::abs(m.ssk - other.ssk) <= tolerance);
  CHECK(std::abs(m.sku - other.sku) <= 3 * tolerance);
}

}  // namespace

// The means of sin², sin³ and sin⁴ over whole periods are exact from five points a period on; with 2·odd
// points a period the crests fall on cell centres.
TEST_CASE("a sine of amplitude A has Sq = A/sqrt(2), Ssk = 0, Sku = 3/2, Sp = Sv = A", "[moments][exact]") {
  const double A = 3e-6;
  for (int points : {6, 10, 30}) {
    const Field z = sine({4 * points, 7}, A, 4);
    const Moments m = moments(z);
    CAPTURE(points);
    CHECK(std::abs(m.mean) <= A * round_off(z));
    CHECK(relative_error(m.sq, A / std::numbers::sqrt2) <= round_off(z));
    CHECK(std::abs(m.ssk) <= round_off(z));
    CHECK(relative_error(m.sku, 1.5) <= round_off(z));
    CHECK(relative_error(m.sp, A) <= round_off(z));
    CHECK(relative_error(m.sz(), 2 * A) <= round_off(z));
  }
}

// The midpoint sum of sin over half a period of M points is 1/(M sin(π/2M)) = (2/π)(1 + (π/2M)²/6 + …).
TEST_CASE("Sa of a sine converges to 2A/pi at order 2 with constant pi^2/6 in 1/points", "[moments][order]") {
  const double exact = 2 / std::numbers::pi;
  auto error = [&](int points) { return moments(sine({points, 3}, 1, 1)).sa / exact - 1; };
  for (int points : {32, 64, 128}) {
    CHECK(observed_order(error(points), error(2 * points)) == Approx(2).margin(0.01));
    CHECK(error(points) * points * points == Approx(std::pow(std::numbers::pi, 2) / 6).epsilon(0.01));
  }
}

// A plane, and what is orthogonal to it by its own remainder.
TEST_CASE("the share of the mean plane in the variance is what its removal takes, holes or not",
          "[moments][exact]") {
  for (Shape shape : {Shape{24, 17}, Shape{30, 1}, Shape{1, 40}})
    for (const bool holes : {false, true}) {
      const Grid g{shape, 0.2, 0.5};
      Field z =
          7 + 0.1 * random_field(shape, 9) + sample(g, [](double x, double y) { return 0.3 * x - 0.1 * y; });
      if (holes) z(0, 0) = z(z.rows() / 2, z.cols() / 2) = std::nan("");
      const Proportions found(z, g);
      const double sq = moments(z).sq, left = moments(remove_form(z, 1)).sq;
      CAPTURE(shape.nx, shape.ny, holes);
      CHECK(relative_error(found.sq(), sq) <= 1e-12);
      CHECK(std::abs(found.plane_share() - (1 - left * left / (sq * sq))) <= 1e-12);
      Proportions in_strips(g);
      in_strips.add(z.topRows(z.rows() / 2)), in_strips.add(z.bottomRows(z.rows() - z.rows() / 2));
      CHECK(in_strips.plane_share() == found.plane_share());
      CHECK(in_strips.rms_slope() == found.rms_slope());
    }
}

TEST_CASE(
    "heights of more than a tenth of their length or an rms slope of 1 are implausible, level ones are not",
    "[moments][exact]") {
  auto of = [](const Grid& g, double height) { return Proportions(sine(g.shape, height, 1), g); };
  const Grid g{{40, 20}, 1, 1};
  const double steepest = std::numbers::sqrt2 / (2 * std::numbers::pi / 40);  // of slope 1
  CHECK_FALSE(of(g, 0.98 * 4 * std::numbers::sqrt2).implausible());
  CHECK(of(g, 1.02 * 4 * std::numbers::sqrt2).implausible());
  CHECK_FALSE(of({{40, 200}, 1, 1}, 0.95 * steepest).implausible());
  CHECK(of({{40, 200}, 1, 1}, 1.05 * steepest).implausible());
  const Proportions level(Field::Constant(20, 1, 3e-6), {{20, 1}, 1e-6, 1e-6});
  CHECK_FALSE((level.implausible() || level.tilted() || level.plane_share() != 0));
  CHECK_FALSE(Proportions(Field::Constant(1, 1, 5.0), {{1, 1}, 1, 1}).implausible());
}

TEST_CASE("moments of a z + b: lengths scale with |a|, Ssk with its sign, Sku not at all", "[moments][law]") {
  const Field z = random_field({40, 31}, 5).cube();
  const Moments plain = moments(z), up = moments(2.5e-6 * z + 1e-6), down = moments(-2.5e-6 * z);
  check_shape_equal(up, plain, 2.5e-6, round_off(z));
  CHECK(std::abs(down.ssk + plain.ssk) <= round_off(z));
  CHECK(relative_error(down.sp, 2.5e-6 * plain.sv) <= round_off(z));
  CHECK(std::abs(up.mean - (2.5e-6 * plain.mean + 1e-6)) <= 2.5e-6 * round_off(z));
}

// Heights that are multiples of 2⁻⁵⁰ m ≈ 1e-15 m remain exact on top of 1 m: the data are the same, any
// difference is the method's. Sums of raw powers would leave no digit of 1 nm² beside 1 m².
TEST_CASE("roughness of 1 nm on an offset of 1 m keeps ten digits in every moment", "[moments][exact]") {
  const double unit = std::ldexp(1.0, -50);
  const Field z = (random_field({64, 50}, 6) * (1e-9 / unit)).round() * unit;
  const Field high = z + 1.0;
  REQUIRE((high - 1.0 == z).all());
  check_shape_equal(moments(high), moments(z), 1, 1e-10);
}

TEST_CASE("moments do not change when the surface is turned over an axis or transposed", "[moments][law]") {
  const Field z = random_field({33, 20}, 7);
  const Moments m = moments(z);
  for (const Field& turned :
       {Field(z.colwise().reverse()), Field(z.rowwise().reverse()), Field(z.transpose())})
    check_shape_equal(moments(turned), m, 1, round_off(z));
}

TEST_CASE("moments are those of GSL's recurrences about the same mean and rms height", "[moments][exact]") {
  const Field z = random_field({41, 57}, 8).exp();
  const auto n = static_cast<std::size_t>(z.size());
  const Moments m = moments(z);
  const double gsl_mean = gsl_stats_mean(z.data(), 1, n);
  const double gsl_sq = std::sqrt(gsl_stats_variance_with_fixed_mean(z.data(), 1, n, gsl_mean));
  CHECK(relative_error(m.mean, gsl_mean) <= round_off(z));
  CHECK(relative_error(m.sa, gsl_stats_absdev_m(z.data(), 1, n, gsl_mean)) <= round_off(z));
  CHECK(relative_error(m.sq, gsl_sq) <= round_off(z));
  CHECK(relative_error(m.ssk, gsl_stats_skew_m_sd(z.data(), 1, n, gsl_mean, gsl_sq)) <= 10 * round_off(z));
  CHECK(relative_error(m.sku, 3 + gsl_stats_kurtosis_m_sd(z.data(), 1, n, gsl_mean, gsl_sq)) <= round_off(z));
}

TEST_CASE("a field of equal heights is refused by the name of its variable", "[moments][contract]") {
  try {
    moments(Field::Constant(8, 8, 0.3), "pressure");
    FAIL("not refused");
  } catch (const DataError& error) {
    CHECK(error.name == "pressure");
  }
}

// An infinite height once made NaN of all moments, and heights of 1e-160 a kurtosis of 0/0.
TEST_CASE("heights that are infinite or whose fourth powers leave the range of a double are refused",
          "[moments][contract]") {
  Field z = random_field({16, 16}, 4);
  CHECK(relative_error(moments(1e-70 * z).sku, moments(z).sku) <= round_off(z));
  CHECK(relative_error(moments(1e70 * z).sku, moments(z).sku) <= round_off(z));
  for (double scale : {1e-310, 1e-160, 1e160, 1e300}) CHECK_THROWS_AS(moments(scale * z), DataError);
  z(3, 4) = -std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(moments(z), ContainsSubstring("infinite"));
}

// The plane's values reach 1; what is left of them after the projection is their rounding.
TEST_CASE("removing the plane takes any plane away and leaves nothing for a second removal", "[form][law]") {
  const Field z = random_field({24, 37}, 9);
  const Field tilted = z + Field::NullaryExpr(24, 37, [](Index i, Index j) {
                         return 0.3 - 0.02 * static_cast<double>(i) + 0.01 * static_cast<double>(j);
                       });
  const Field flat = remove_form(z, 1);
  CHECK((remove_form(tilted, 1) - flat).abs().maxCoeff() <= round_off(z));
  CHECK((remove_form(flat, 1) - flat).abs().maxCoeff() <= round_off(z));
  CHECK(moments(flat).sq <= moments(z).sq);
}
