// Errors of means from the field's own long waves, and of the parameters that depend on such means.
#include "stats/uncertainty/long_waves.hpp"

#include <array>
#include <random>

#include "fields.hpp"
#include "holes.hpp"
#include "named.hpp"
#include "stats/height/height_error.hpp"
#include "stats/hybrid/derivative_error.hpp"
#include "stats/measure.hpp"
#include "stats/sample/moments.hpp"
#include "stats/uncertainty/interval.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// Of a field itself.
LocalSums sums_of(const Field& z, const Grid& g, int threads = 1) {
  LocalSums sums(g, 1);
  sums.add_rows(z.rows(), threads,
                [&](Index i, LocalSums::Values& values) { values.col(1) = z.row(i).transpose().matrix(); });
  return sums;
}

double itself(const Eigen::VectorXd& means) { return means(0); }

double error_of_mean(const Field& z, const Grid& g, double n_eff, double elongation = 1) {
  return sums_of(z, g).means({n_eff, elongation}).error(itself).error;
}

// Half waves along x, of mean square 1.
Field half_waves(Shape shape, double count, double phase = 0) {
  return Field::NullaryExpr(shape.nx, shape.ny, [=](Index i, Index) {
    return std::sqrt(2.0) * std::cos(std::numbers::pi * count * (static_cast<double>(i) + 0.5) /
                                         static_cast<double>(shape.nx) -
                                     phase);
  });
}

}  // namespace

// Computed once by the formulas in another language (Python).
TEST_CASE("flat and falling spectra have the errors and degrees of freedom of the average over spectra",
          "[wave-spectra][exact]") {
  const LongWaves waves(grid(64, 64), {100, 1});
  REQUIRE(waves.all().size() == 21);
  const WaveSpectra spectra(waves.numbers());
  const WaveError flat = spectra.error(Eigen::ArrayXd::Ones(21)),
                  falling = spectra.error((-0.05 * waves.numbers().nu).exp());
  CHECK(std::abs(flat.error - 1.103438) <= 5e-7);
  CHECK(std::abs(flat.degrees - 5.6721) <= 5e-5);
  CHECK(std::abs(falling.error - 0.929261) <= 5e-7);
  CHECK(std::abs(falling.degrees - 3.0083) <= 5e-5);
  // Of a ridge at 60°.
  const Eigen::ArrayX2d& half = waves.numbers().half_waves;
  auto beside = [&](double side) -> Eigen::ArrayXd {
    const Eigen::ArrayXd d = std::sqrt(0.75) * half.col(0) + 0.5 * side * half.col(1);
    return 0.5 / (1 + 0.5 * std::pow(std::numbers::pi, 2) * d.square());
  };
  const WaveError ridge = spectra.error(beside(1) + beside(-1));
  CHECK(std::abs(ridge.error - 0.862846) <= 5e-7);
  CHECK(std::abs(ridge.degrees - 2.9601) <= 5e-5);
  // It has the unit of the amplitudes.
  const WaveError scaled = spectra.error(Eigen::ArrayXd::Constant(21, 1e-18));
  CHECK(relative_error(scaled.error, 1e-9 * flat.error) <= 1e-12);
  CHECK(relative_error(scaled.degrees, flat.degrees) <= 1e-12);
  CHECK(spectra.error(Eigen::ArrayXd::Zero(21)).error == 0);
  CHECK(std::isnan(WaveSpectra(LongWaveNumbers{}).error(Eigen::ArrayXd(0)).error));
  // By its own weights a function has its own error.
  const Eigen::ArrayXd squares = Eigen::ArrayXd::LinSpaced(21, 1, 3);
  CHECK(relative_error((spectra.weights(squares) * squares).sum(),
                       std::pow(spectra.error(squares).error, 2)) <= 1e-12);
}

namespace {

// Of the amplitude A in the first wave of these half waves.
double error_of_one(const Grid& g, double elongation, const Eigen::Array2d& half_waves, double amplitude) {
  const LongWaveNumbers numbers = LongWaves(g, {100, elongation}).numbers();
  Index k = 0;
  REQUIRE((numbers.half_waves.rowwise() - half_waves.transpose()).square().rowwise().sum().minCoeff(&k) == 0);
  Eigen::ArrayXd squares = Eigen::ArrayXd::Zero(numbers.nu.size());
  squares(k) = amplitude * amplitude;
  return WaveSpectra(numbers).error(squares).error;
}

}  // namespace

TEST_CASE("the error of a mean is that of the longest waves", "[long-waves][exact]") {
  const Shape shape{40, 40};
  const Grid free = grid(40, 40), periodic = grid(40, 40, true), along_y{shape, 1, 1, {false, true}};
  const double amplitude = 0.7;
  auto one = [&](const Grid& g, double x, double y, double elongation = 1) {
    return Approx(error_of_one(g, elongation, {x, y}, amplitude)).epsilon(1e-10);
  };
  for (const double k : {1, 3, 4})
    CHECK(error_of_mean(5 + amplitude * half_waves(shape, k), free, 100) == one(free, k, 0));
  CHECK(error_of_mean(5 + amplitude * half_waves(shape, 5), free, 4000) < 1e-12);
  // Of a periodic axis a sine and a cosine, wherever it begins.
  for (const double phase : {0.0, 0.4, 2.0})
    CHECK(error_of_mean(amplitude * half_waves(shape, 2, phase), periodic, 100) == one(periodic, 2, 0));
  CHECK(error_of_mean(amplitude * half_waves(shape, 2), along_y, 100) == one(along_y, 2, 0));
  // Of a long field, six waves along its long side; of a row, none across.
  const Field along = half_waves({400, 20}, 2).transpose(), row = half_waves({400, 1}, 2).transpose();
  CHECK(LongWaves(grid(20, 400), {300, 0.04}).all().size() == 6);
  CHECK(error_of_mean(amplitude * along, grid(20, 400), 300, 0.04) == one(grid(20, 400), 0, 2, 0.04));
  CHECK(error_of_mean(amplitude * half_waves({20, 400}, 1), grid(20, 400), 300, 0.04) < 1e-12);
  CHECK(error_of_mean(amplitude * row, grid(1, 400), 4000, 1.0 / 400) == one(grid(1, 400), 0, 2, 1.0 / 400));
  CHECK(error_of_mean(Field::Constant(40, 40, 3.0), free, 100) == 0);
}

TEST_CASE("a period has the same errors wherever it is cut, and a field those of its mirror images",
          "[long-waves][law]") {
  const Shape shape{60, 44};
  for (const bool holes : {false, true}) {
    Field z = moving_average(shape, {6, 4}, 5);
    if (holes) z.block(3, 30, 20, 9).setConstant(NAN);
    const Field over = z.colwise().reverse(), back = z.rowwise().reverse();
    Field shifted(60, 44);
    for (Index i = 0; i < 60; ++i)
      for (Index j = 0; j < 44; ++j) shifted((i + 13) % 60, (j + 7) % 44) = z(i, j);
    for (const bool periodic : {false, true}) {
      const Grid g = grid(60, 44, periodic);
      const double error = error_of_mean(z, g, 100, 0.9);
      CAPTURE(holes, periodic);
      CHECK(relative_error(error_of_mean(over, g, 100, 0.9), error) <= 1e-9);
      CHECK(relative_error(error_of_mean(back, g, 100, 0.9), error) <= 1e-9);
      if (periodic) CHECK(relative_error(error_of_mean(shifted, g, 100, 0.9), error) <= 1e-9);
    }
  }
}

// A point is 1/N of a wave's square, and two waves of nearly one ν may mix.
TEST_CASE("a missing point hardly changes the error", "[long-waves][law]") {
  Field z = moving_average({90, 70}, {6, 4}, 5);
  const double error = error_of_mean(z, grid(90, 70), 100, 1.1);
  z(31, 44) = NAN;
  CHECK(relative_error(error_of_mean(z, grid(90, 70), 100, 1.1), error) <= 0.01);
}

TEST_CASE("the error of a mean does not depend on threads or an offset", "[long-waves][contract]") {
  const Grid g = grid(150, 70);
  Field z = moving_average({150, 70}, {4, 3}, 3);
  for (const bool holes : {false, true}) {
    if (holes) z.block(20, 10, 9, 30).setConstant(NAN);
    const LocalSums whole = sums_of(z, g);
    const double error = whole.means({1000}).error(itself).error;
    CHECK(whole.count() == static_cast<double>((!z.isNaN()).count()));
    CHECK(whole.means({1000})(itself) == Approx(z.isNaN().select(0, z).sum() / whole.count()).epsilon(1e-12));
    CHECK(sums_of(z, g, 3).means({1000}).error(itself).error == error);
    CHECK(sums_of(1e3 + z, g).means({1000}).error(itself).error == Approx(error).epsilon(1e-6));
    CHECK(sums_of(1e-9 * z, g).means({1000}).error(itself).error == Approx(1e-9 * error).epsilon(1e-10));
  }
}

namespace {

// The points of a disc, of a row, of every second cell, of a corner, of three quarters of a field.
Field points_of(int which, Index n) {
  return Field::NullaryExpr(n, n, [=](Index i, Index j) {
    const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(n),
                 y = (static_cast<double>(j) + 0.5) / static_cast<double>(n);
    const bool in = which == 0   ? std::hypot(x - 0.5, y - 0.5) < 0.4
                    : which == 1 ? i == n / 3
                    : which == 2 ? (i + j) % 2 == 0
                    : which == 3 ? x < 0.25 && y < 0.25
                                 : x > 0.5 || y > 0.5;
    return in ? 1.0 : NAN;
  });
}

}  // namespace

// Once, waves had the variance that they have over the whole grid. Of white noise E[c_k²] = σ²/N exactly,
// whatever the points, and the average over spectra allows for falling ones: its rms is 1.165 times the
// true error for 21 waves (1500 draws in Python), up to 1.5 for two. Of 400 fields the rms is known to
// √(1/(2 · 400 K)), of which four are allowed.
TEST_CASE("the mean of white noise at any points has the error of so many heights, or somewhat more",
          "[long-waves][statistics]") {
  constexpr Index n = 40;
  constexpr int fields = 400;
  for (int which = 0; which < 5; ++which) {
    const Field points = points_of(which, n);
    const double N = static_cast<double>((!points.isNaN()).count());
    double square = 0, covered = 0, waves = 0;
    for (unsigned seed = 0; seed < fields; ++seed) {
      const LocalMeans of = sums_of(points * white_noise({n, n}, seed), grid(n, n), n).means({100, 1});
      const WaveError error = of.error(itself);
      square += error.error * error.error / fields;
      covered += std::abs(of(itself)) <= error.half_width();
      waves = static_cast<double>(of.waves());
    }
    CAPTURE(which, N, waves);
    const double chance = 4 / std::sqrt(2.0 * fields * waves);
    CHECK(std::sqrt(square * N) >= 1 - chance);
    CHECK(std::sqrt(square * N) <= (waves > 20 ? 1.165 : 1.5) + chance);
    CHECK(covered >= fields * (0.95 - 4 * std::sqrt(0.95 * 0.05 / fields)));
  }
}

namespace {

// Some twelve lines at 60°, each 0.05 of the side wide, at random places.
Field grooves(Index n, std::mt19937& random) {
  Field z = Field::Zero(n, n);
  std::uniform_real_distribution<> place(-0.7, 0.7);
  for (int lines = std::poisson_distribution<>(12)(random); lines > 0; --lines) {
    const double at = place(random);
    z += Field::NullaryExpr(n, n, [&](Index i, Index j) {
      const double x = static_cast<double>(i) / static_cast<double>(n) - 0.5,
                   y = static_cast<double>(j) / static_cast<double>(n) - 0.5;
      return std::abs(std::sqrt(0.75) * x + 0.5 * y - at) < 0.025 ? 1.0 : 0.0;
    });
  }
  return z;
}

}  // namespace

// Waves beside the ridge tell nothing of it: by spectra that are alike in all directions the ratio is 0.6. Of 300 fields
// it is known to √(1/600).
TEST_CASE("the mean of lines that cross a field has the error of their number", "[long-waves][statistics]") {
  constexpr Index n = 48;
  constexpr int fields = 300;
  std::mt19937 random(11);
  Spread mean;
  double square = 0;
  for (int f = 0; f < fields; ++f) {
    const LocalMeans of = sums_of(grooves(n, random), grid(n, n)).means({100, 1});
    mean.add(of(itself)), square += std::pow(of.error(itself).error, 2) / fields;
  }
  const double ratio = std::sqrt(square) / mean.deviation(), chance = 4 * std::sqrt(0.5 / fields);
  CAPTURE(ratio);
  CHECK(ratio >= 1 - chance);
  CHECK(ratio <= 1.3 + chance);
}

// The waves along the row are those of a complete field of one row.
TEST_CASE("a single measured row has the errors of a field of one row", "[long-waves][law]") {
  const Field row = moving_average({1, 200}, {1, 4}, 3);
  Field z = Field::Constant(60, 200, NAN);
  z.row(17) = row;
  const Grid g = grid(60, 200), of_row = grid(1, 200);
  auto extent_of = [](const Field& of, const Grid& on, Shape reach) {
    const LagField rho = LagField::of(reach, [](Index p, Index q) {
      return std::exp(-std::hypot(static_cast<double>(p), static_cast<double>(q)) / 4);
    });
    return ErrorBasis{rho, false, Pairs::of(of, on)}.extent();
  };
  const FieldExtent alone = extent_of(row, of_row, {0, 50}), within = extent_of(z, g, {30, 50});
  CHECK(relative_error(within.patches, alone.patches) <= 1e-12);
  CHECK(relative_error(within.elongation, alone.elongation) <= 1e-12);
  const LocalMeans of = sums_of(z, g, 60).means(within), expected = sums_of(row, of_row, 1).means(alone);
  CHECK(relative_error(of.error(itself).degrees, expected.error(itself).degrees) <= 1e-9);
  CHECK(relative_error(of.error(itself).error, expected.error(itself).error) <= 1e-9);
}

// Their sums vanish along the grooves but for rounding.
TEST_CASE("grooves have errors of slopes across them and none along them", "[derivative-error][law]") {
  for (const bool periodic : {false, true}) {
    const Field z = moving_average({40, 1}, {3, 1}, 4).replicate(1, 30) + 1e-3;
    const Grid g = grid(40, 30, periodic);
    const DerivativeErrors e(z, g, {100});
    CHECK(e([](const Derivatives& d) { return d.moments.m20; }).error > 0);
    CHECK(e([](const Derivatives& d) { return d.moments.m40; }).error > 0);
    CHECK(e([](const Derivatives& d) { return d.moments.m02; }).error == 0);
    CHECK(e([](const Derivatives& d) { return d.moments.m04; }).error == 0);
  }
}

namespace {

Parameters parameters_of(const Field& z, Group group) {
  MeasureOptions options{.groups = {group}};
  options.quantiles = {0.5};
  return measure(Surface{grid(z.rows(), z.cols()), 1e-6 * z}, options);
}

}  // namespace

// One row in four is missing. A variance from every fourth row knew nothing of such a field.
TEST_CASE("slopes of interlaced rows have the errors of interlaced columns", "[long-waves][law]") {
  Field z = moving_average({128, 128}, {4, 4}, 8);
  for (Index i = 0; i < z.rows(); i += 4) z.row(i).setConstant(NAN);
  const Parameters rows = parameters_of(z, Group::hybrid),
                   columns = parameters_of(z.transpose(), Group::hybrid);
  for (const auto& [x, y] : {std::pair{"Sdq", "Sdq"}, {"m2_x", "m2_y"}, {"m4_y", "m4_x"}}) {
    CAPTURE(x);
    CHECK(named(rows, x).standard_error == Approx(named(columns, y).standard_error).epsilon(1e-6));
  }
}

// The median of a plateau is certain but for the mean, which deep grooves move: its interval is that of the mean,
// some three errors to either side, and does not reach into the grooves.
TEST_CASE("the interval of a plateau's median is as wide as its error", "[long-waves][law]") {
  Field z = 0.05 * moving_average({160, 160}, {3, 3}, 5);
  for (const Index column : {11, 37, 70, 71, 112, 140}) z.col(column) -= 2;
  const Parameters all = parameters_of(z, Group::quantiles);
  const Parameter& median = named(all, "quantile_0.5");
  const Interval ends = median.interval_95();
  REQUIRE(median.standard_error > 0);
  CHECK(ends.low >= median.value - 6 * median.standard_error);
  CHECK(ends.high <= median.value + 6 * median.standard_error);
}

TEST_CASE("no interval of a kurtosis reaches below 1", "[long-waves][law]") {
  Field z = moving_average({96, 96}, {4, 4}, 2);
  z(40, 50) = 1000;
  const Parameters heights = parameters_of(z, Group::height);
  const Parameter& sku = named(heights, "Sku");
  CHECK(sku.value > 100);
  CHECK(sku.interval_95().low >= 1);
}
