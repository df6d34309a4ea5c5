// Errors of means from the field's own long waves, and of the parameters that depend on such means.
#include "stats/uncertainty/long_waves.hpp"

#include <array>

#include "fields.hpp"
#include "holes.hpp"
#include "named.hpp"
#include "stats/height/height_error.hpp"
#include "stats/hybrid/derivative_error.hpp"
#include "stats/measure.hpp"
#include "stats/sample/moments.hpp"
#include "stats/uncertainty/interval.hpp"
#include "stats/uncertainty/sequence_error.hpp"

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

// Computed once by the formulas in another language (numpy).
TEST_CASE("flat and falling spectra have the errors and degrees of freedom of the average over spectra",
          "[wave-spectra][exact]") {
  const LongWaves waves(grid(64, 64), {100, 1});
  REQUIRE(waves.all().size() == 21);
  const WaveSpectra spectra(waves.numbers());
  const WaveError flat = spectra.error(Eigen::ArrayXd::Ones(21)),
                  falling = spectra.error((-0.05 * waves.numbers()).exp());
  CHECK(std::abs(flat.error - 1.125826) <= 5e-7);
  CHECK(std::abs(flat.degrees - 6.4565) <= 5e-5);
  CHECK(std::abs(falling.error - 0.948435) <= 5e-7);
  CHECK(std::abs(falling.degrees - 3.8872) <= 5e-5);
  // It has the unit of the amplitudes.
  const WaveError scaled = spectra.error(Eigen::ArrayXd::Constant(21, 1e-18));
  CHECK(relative_error(scaled.error, 1e-9 * flat.error) <= 1e-12);
  CHECK(relative_error(scaled.degrees, flat.degrees) <= 1e-12);
  CHECK(spectra.error(Eigen::ArrayXd::Zero(21)).error == 0);
  CHECK(std::isnan(WaveSpectra(Eigen::ArrayXd(0)).error(Eigen::ArrayXd(0)).error));
  // By its own weights a function has its own error.
  const Eigen::ArrayXd squares = Eigen::ArrayXd::LinSpaced(21, 1, 3);
  CHECK(relative_error((spectra.weights(squares) * squares).sum(),
                       std::pow(spectra.error(squares).error, 2)) <= 1e-12);
}

namespace {

// Of the amplitude A in one of the waves of this number ν.
double error_of_one(const Grid& g, double elongation, double nu, double amplitude) {
  const Eigen::ArrayXd numbers = LongWaves(g, {100, elongation}).numbers();
  Index k = 0;
  REQUIRE((numbers - nu).abs().minCoeff(&k) <= 1e-9 * nu);
  Eigen::ArrayXd squares = Eigen::ArrayXd::Zero(numbers.size());
  squares(k) = amplitude * amplitude;
  return WaveSpectra(numbers).error(squares).error;
}

}  // namespace

TEST_CASE("the error of a mean is that of the longest waves", "[long-waves][exact]") {
  const Shape shape{40, 40};
  const Grid free = grid(40, 40), periodic = grid(40, 40, true), along_y{shape, 1, 1, {false, true}};
  const double amplitude = 0.7;
  auto one = [&](const Grid& g, double nu, double elongation = 1) {
    return Approx(error_of_one(g, elongation, nu, amplitude)).epsilon(1e-10);
  };
  for (const double k : {1, 3, 4})
    CHECK(error_of_mean(5 + amplitude * half_waves(shape, k), free, 100) == one(free, k * k));
  CHECK(error_of_mean(5 + amplitude * half_waves(shape, 5), free, 4000) < 1e-12);
  // Of a periodic axis a sine and a cosine, wherever it begins.
  for (const double phase : {0.0, 0.4, 2.0})
    CHECK(error_of_mean(amplitude * half_waves(shape, 2, phase), periodic, 100) == one(periodic, 4));
  CHECK(error_of_mean(amplitude * half_waves(shape, 2), along_y, 100) == one(along_y, 4));
  // Of a long field, six waves along its long side; of a row, none across.
  const Field along = half_waves({400, 20}, 2).transpose(), row = half_waves({400, 1}, 2).transpose();
  CHECK(LongWaves(grid(20, 400), {300, 0.04}).all().size() == 6);
  CHECK(error_of_mean(amplitude * along, grid(20, 400), 300, 0.04) == one(grid(20, 400), 0.16, 0.04));
  CHECK(error_of_mean(amplitude * half_waves({20, 400}, 1), grid(20, 400), 300, 0.04) < 1e-12);
  CHECK(error_of_mean(amplitude * row, grid(1, 400), 4000, 1.0 / 400) == one(grid(1, 400), 0.01, 1.0 / 400));
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
// whatever the points, and the average over spectra allows for falling ones: its rms is 1.15 times the true
// error for 21 waves (2000 draws in numpy), more for fewer. Of 400 fields the rms is known to
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
    CHECK(std::sqrt(square * N) <= 1.3 + chance);
    CHECK(covered >= fields * (0.95 - 4 * std::sqrt(0.95 * 0.05 / fields)));
  }
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

// ---- sequence error ----

namespace {

// The k-th longest wave, of amplitude A.
Eigen::ArrayXd sequence_wave(Index n, Index k, double amplitude, bool periodic = false) {
  return amplitude * axis_waves(n, periodic, k).col(k).array();
}

// Means over `window` neighbours of 100 independent values, or a piece of such.
Eigen::ArrayXd averaged(Index window, unsigned seed, bool periodic) {
  const Index n = 100;
  const Eigen::ArrayXd noise = white_noise({1, n + window}, seed).row(0).transpose();
  return Eigen::ArrayXd::NullaryExpr(n, [&](Index j) {
    double sum = 0;
    for (Index k = j; k < j + window; ++k) sum += noise(periodic ? k % n : k);
    return sum;
  });
}

}  // namespace

// One of six waves, of ν = k², has all the power.
TEST_CASE("the errors of a sequence are those of its longest waves and of the longest of its squares",
          "[sequence-error][exact]") {
  const Index n = 90;
  const double amplitude = 0.7;
  const WaveSpectra spectra(Eigen::ArrayXd::LinSpaced(6, 1, 6).square());
  auto one = [&](Index k, double a) {
    Eigen::ArrayXd squares = Eigen::ArrayXd::Zero(6);
    squares(k - 1) = a * a;
    return spectra.error(squares).error;
  };
  for (const Index k : {1, 2, 6}) {
    const SequenceMean m = sequence_mean(5 + sequence_wave(n, k, amplitude), 20.0 / n, false);
    CAPTURE(k);
    CHECK(relative_error(m.mean, 5) <= 1e-14);
    CHECK(relative_error(m.spread, amplitude) <= 1e-13);
    CHECK(relative_error(m.of_mean.error, one(k, amplitude)) <= 1e-10);
  }
  CHECK(sequence_mean(5 + sequence_wave(n, 7, amplitude), 20.0 / n, false).of_mean.error <= 1e-12);
  CHECK(std::isnan(sequence_mean(sequence_wave(n, 1, amplitude), 2.99 / n, false).of_mean.error));
  CHECK(std::isnan(sequence_mean(Eigen::ArrayXd::Constant(n, NAN), 1, false).mean));
  // v² = s² (1 + b u), u the wave of two halves, and v changes its sign in the middle, where u is even: v̄ = 0,
  // f = s b u/2.
  const double s = 3, b = 0.5;
  Eigen::ArrayXd v = s * (1 + sequence_wave(n, 2, b)).sqrt();
  v.tail(n / 2) *= -1;
  const SequenceMean m = sequence_mean(v, 80.001 / n, false);
  CHECK(relative_error(m.spread, s) <= 1e-13);
  CHECK(relative_error(m.of_spread.error, one(2, s * b / 2)) <= 1e-10);
}

TEST_CASE("errors of a sequence move with its scale, not with its place, its direction or absent values",
          "[sequence-error][law]") {
  const Field z = moving_average({1, 200}, {1, 5}, 3);
  const Eigen::ArrayXd v = z.row(0).transpose();
  const SequenceMean m = sequence_mean(v, 0.2, false), moved = sequence_mean(7 - 1e-3 * v, 0.2, false),
                     back = sequence_mean(v.reverse(), 0.2, false);
  CHECK(relative_error(moved.of_mean.error, 1e-3 * m.of_mean.error) <= 1e-10);
  CHECK(relative_error(moved.of_spread.error, 1e-3 * m.of_spread.error) <= 1e-10);
  CHECK(relative_error(back.of_mean.error, m.of_mean.error) <= 1e-10);
  // A sequence turned around its period, and one that lacks a value in three.
  Eigen::ArrayXd turned(200), fewer = v;
  turned << v.tail(77), v.head(123);
  CHECK(relative_error(sequence_mean(turned, 0.2, true).of_mean.error,
                       sequence_mean(v, 0.2, true).of_mean.error) <= 1e-10);
  for (Index j = 0; j < 200; j += 3) fewer(j) = NAN;
  const SequenceMean some = sequence_mean(fewer, 0.2, false);
  CHECK(some.count == 133);
  CHECK(some.independent == Approx(0.2 * 133).epsilon(1e-14));
  CHECK(std::abs(std::log(some.of_mean.error / m.of_mean.error)) <= 0.5);
}

// Of n sequences the mean square of the error has the relative deviation √(2/(K n)), that of the true one
// √(2/n), and the share of intervals √(0.95 · 0.05/n). Errors allow for spectra that fall, up to a third of
// them, and what ten independent values lose is within a fifth.
TEST_CASE("errors of a sequence are the spread over an ensemble, and Student's intervals cover",
          "[sequence-error][statistics]") {
  constexpr int sequences = 1000;
  for (const bool periodic : {false, true})
    for (const Index window : {1, 4, 10}) {
      Spread mean, spread;
      double square = 0, square_of_spread = 0, covered = 0;
      for (unsigned seed = 0; seed < sequences; ++seed) {
        const SequenceMean m =
            sequence_mean(averaged(window, seed, periodic), 1.0 / static_cast<double>(window), periodic);
        mean.add(m.mean), spread.add(m.spread);
        square += m.of_mean.error * m.of_mean.error / sequences;
        square_of_spread += m.of_spread.error * m.of_spread.error / sequences;
        covered += std::abs(m.mean) <= m.of_mean.half_width();
      }
      CAPTURE(periodic, window);
      const double chance = 4 * std::sqrt(0.5 / sequences);
      for (const double ratio :
           {std::sqrt(square) / mean.deviation(), std::sqrt(square_of_spread) / spread.deviation()}) {
        CHECK(ratio >= 0.8 - chance);
        CHECK(ratio <= 1.33 + chance);
      }
      CHECK(covered / sequences >= 0.95 - 4 * std::sqrt(0.95 * 0.05 / sequences));
    }
}

// Lognormal values: a few decide the spread. Of 1000 sequences the covering share is known to 1 %. With the
// degrees of all independent values it is 85 %.
TEST_CASE("intervals of the spread of a sequence hold it where heavy tails decide",
          "[sequence-error][statistics]") {
  constexpr int sequences = 1000;
  constexpr Index window = 4;
  constexpr double per_window = 1.0 / window;
  Spread spread;
  std::vector<Interval> intervals;
  for (unsigned seed = 0; seed < sequences; ++seed) {
    const Eigen::ArrayXd v = (0.8 * std::sqrt(per_window) * averaged(window, seed, false)).exp();
    const SequenceMean m = sequence_mean(v, per_window, false);
    spread.add(m.spread);
    intervals.push_back(Interval::of_inverse(m.spread, m.of_spread.half_width() / m.spread));
  }
  const double truth = spread.mean();
  const auto covered =
      std::ranges::count_if(intervals, [&](const Interval& i) { return i.low <= truth && truth <= i.high; });
  CAPTURE(covered);
  CHECK(covered >= 880);
}
