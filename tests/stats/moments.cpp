#include "stats/sample/moments.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gsl/gsl_statistics_double.h>

#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "fields.hpp"
#include "stats/filter/form.hpp"
#include "stats/measure.hpp"
#include "stats/spatial/acf.hpp"

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

// ---- measured ----

namespace {

using Long = long double;

struct Map {
  Grid grid;
  Field z;

  explicit Map(const char* name) {
    std::ifstream file(ASPERITY_TEST_DATA "/" + std::string(name), std::ios::binary);
    std::stringstream bytes;
    bytes << file.rdbuf();
    const Dataset data = decode_netcdf(bytes.str());
    grid = grid_of(data);
    z = field_of(data, "heights");
  }
  Long operator()(Index i, Index j) const { return z(i, j); }
  Index nx() const { return z.rows(); }
  Index ny() const { return z.cols(); }

  Long mean() const {
    return sum(nx(), ny(), [&](Index i, Index j) { return (*this)(i, j); }) / static_cast<Long>(z.size());
  }
  /// Σ f(i,j) over the first rows and columns.
  template <class Function>
  static Long sum(Index rows, Index columns, Function f) {
    Long total = 0;
    for (Index i = 0; i < rows; ++i)
      for (Index j = 0; j < columns; ++j) total += f(i, j);
    return total;
  }
};

double off(double value, Long exact) { return static_cast<double>(std::abs((value - exact) / exact)); }

}  // namespace

// 1e-12 is asked; what the sums' roundings amount to, ε (nx + ny) times the condition of the third moment, is
// 1e-13.
TEST_CASE("moments of a measured surface are those of long double to 1e-12", "[measured][exact]") {
  const Map map("afm-64x64.nc");
  const Long mean = map.mean(), n = static_cast<Long>(map.z.size());
  auto moment = [&](int power) {
    return Map::sum(map.nx(), map.ny(), [&](Index i, Index j) { return std::pow(map(i, j) - mean, power); }) /
           n;
  };
  const Long sa =
      Map::sum(map.nx(), map.ny(), [&](Index i, Index j) { return std::abs(map(i, j) - mean); }) / n;
  const Long sq = std::sqrt(moment(2));
  const Moments m = moments(map.z);
  CHECK(off(m.mean, mean) <= 1e-12);
  CHECK(off(m.sa, sa) <= 1e-12);
  CHECK(off(m.sq, sq) <= 1e-12);
  CHECK(off(m.ssk, moment(3) / (sq * sq * sq)) <= 1e-12);
  CHECK(off(m.sku, moment(4) / (sq * sq * sq * sq)) <= 1e-12);
  CHECK(off(m.sp, map.z.maxCoeff() - mean) <= 1e-12);
  CHECK(off(m.sv, mean - map.z.minCoeff()) <= 1e-12);
}

// Slopes are differences of neighbours, exact but for the rounding of heights that the file already has.
TEST_CASE("slopes, areas and spectral moments of a measured surface are those of long double to 1e-12",
          "[measured][exact]") {
  const Map map("afm-64x64.nc");
  const Long dx = map.grid.dx, dy = map.grid.dy;
  auto a = [&](Index i, Index j) { return (map(i + 1, j) - map(i, j)) / dx; };
  auto b = [&](Index i, Index j) { return (map(i, j + 1) - map(i, j)) / dy; };
  const Index rows = map.nx(), columns = map.ny();
  const Long m20 = Map::sum(rows - 1, columns, [&](Index i, Index j) { return a(i, j) * a(i, j); }) /
                   static_cast<Long>((rows - 1) * columns);
  const Long m02 = Map::sum(rows, columns - 1, [&](Index i, Index j) { return b(i, j) * b(i, j); }) /
                   static_cast<Long>(rows * (columns - 1));
  auto area = [](Long gx, Long gy) { return std::sqrt(1 + gx * gx + gy * gy); };
  const Long sdr = Map::sum(rows - 1, columns - 1,
                            [&](Index i, Index j) {
                              const Long ax = (a(i, j) + a(i, j + 1)) / 2, by = (b(i, j) + b(i + 1, j)) / 2;
                              return (area(a(i, j), by) + area(a(i, j + 1), by) + area(ax, b(i, j)) +
                                      area(ax, b(i + 1, j))) /
                                         4 -
                                     1;
                            }) /
                   static_cast<Long>((rows - 1) * (columns - 1));
  const Long m40 = Map::sum(rows - 2, columns,
                            [&](Index i, Index j) { return std::pow((a(i + 1, j) - a(i, j)) / dx, 2); }) /
                   static_cast<Long>((rows - 2) * columns);
  const SlopeParameters slopes = slope_parameters(map.z, map.grid);
  const SpectralMoments m = spectral_moments(map.z, map.grid);
  CHECK(off(slopes.sdq, std::sqrt(m20 + m02)) <= 1e-12);
  CHECK(off(slopes.sdr, sdr) <= 1e-12);
  CHECK(off(m.m20, m20) <= 1e-12);
  CHECK(off(m.m02, m02) <= 1e-12);
  CHECK(off(m.m40, m40) <= 1e-12);
}

// Relative to the variance: far lags of an estimate pass through zero.
TEST_CASE("the ACF and the structure function of a measured surface are the sums over pairs to 1e-12",
          "[measured][exact]") {
  const Map map("afm-64x64.nc");
  const Shape most{20, 20};
  const Long mean = map.mean();
  const LagField acf = estimate_autocorrelation(map.z, map.grid, {.max_lag = most});
  const LagField structure = structure_function(map.z, map.grid, most);
  const double variance = acf(0, 0);
  double worst = 0, worst_structure = 0;
  for (Index p = 0; p <= most.nx; ++p)
    for (Index q = -most.ny; q <= most.ny; ++q) {
      const Index left = std::max<Index>(0, -q), rows = map.nx() - p, columns = map.ny() - std::abs(q);
      const Long pairs = static_cast<Long>(rows * columns);
      const Long product = Map::sum(rows, columns, [&](Index i, Index j) {
        return (map(i, j + left) - mean) * (map(i + p, j + left + q) - mean);
      });
      const Long square = Map::sum(rows, columns, [&](Index i, Index j) {
        return std::pow(map(i, j + left) - map(i + p, j + left + q), 2);
      });
      worst = std::max(worst, static_cast<double>(std::abs(acf(p, q) - product / pairs)));
      worst_structure =
          std::max(worst_structure, static_cast<double>(std::abs(structure(p, q) - square / pairs)));
    }
  CHECK(worst <= 1e-12 * variance);
  CHECK(worst_structure <= 1e-12 * variance);
}

// Memory behind the field was written.
TEST_CASE("a field that is not of its grid's shape is refused", "[measured][contract]") {
  const Field z = white_noise({16, 8}, 3);
  for (const Grid& other : {grid(8, 16), grid(16, 16), grid(16, 7)}) {
    CHECK_THROWS_AS(measure({other, z}), DataError);
    CHECK_THROWS_AS(Sample(Surface{other, z}), DataError);
  }
}
