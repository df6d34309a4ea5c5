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
#include "stats/sample/quantiles.hpp"
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
  return sums_of(z, g).means({n_eff, elongation}).error(itself);
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

// One of K waves has all the power A²: Var = A²/K, ν = K, and (4) is at its bound of 0.4.
TEST_CASE("the error of a mean is that of the longest waves", "[long-waves][exact]") {
  const Shape shape{40, 40}, long_one{20, 400};
  const Grid free = grid(40, 40), periodic = grid(40, 40, true), along_y{shape, 1, 1, {false, true}};
  const double amplitude = 0.7;
  auto one_of = [&](double K) { return Approx(amplitude / std::sqrt(K) / 0.6).epsilon(1e-12); };
  CHECK(error_of_mean(5 + amplitude * half_waves(shape, 1), free, 100) == one_of(3));
  CHECK(error_of_mean(5 + amplitude * half_waves(shape, 1), free, 300) == one_of(7));
  CHECK(error_of_mean(5 + amplitude * half_waves(shape, 3), free, 1000) == one_of(12));
  CHECK(error_of_mean(5 + amplitude * half_waves(shape, 4), free, 4000) == one_of(21));
  CHECK(error_of_mean(5 + amplitude * half_waves(shape, 5), free, 4000) < 1e-12);
  CHECK(error_of_mean(amplitude * half_waves(shape, 2, 0.4), periodic, 100) == one_of(4));
  CHECK(error_of_mean(amplitude * half_waves(shape, 2, 0.4), periodic, 1000) == one_of(8));
  CHECK(error_of_mean(amplitude * half_waves(shape, 1), periodic, 100) > 0);
  // One and two half waves along x, a sine and a cosine along y.
  CHECK(error_of_mean(amplitude * half_waves(shape, 2), along_y, 100) == one_of(4));
  // Of a long field, only waves along its long side; of a row, none across.
  const Field along = half_waves({400, 20}, 2).transpose(), row = half_waves({400, 1}, 2).transpose();
  CHECK(error_of_mean(amplitude * along, grid(20, 400), 300, 0.05) == one_of(4));
  CHECK(error_of_mean(amplitude * half_waves(long_one, 1), grid(20, 400), 300, 0.05) < 1e-12);
  CHECK(error_of_mean(amplitude * row, grid(1, 400), 4000, 1.0 / 400) == one_of(4));
  CHECK(error_of_mean(Field::Constant(40, 40, 3.0), free, 100) == 0);
}

TEST_CASE("the error of a mean does not depend on threads or an offset", "[long-waves][contract]") {
  const Grid g = grid(150, 70);
  Field z = moving_average({150, 70}, {4, 3}, 3);
  for (const bool holes : {false, true}) {
    if (holes) z.block(20, 10, 9, 30).setConstant(NAN);
    const LocalSums whole = sums_of(z, g);
    const double error = whole.means({1000}).error(itself);
    CHECK(whole.count() == static_cast<double>((!z.isNaN()).count()));
    CHECK(whole.means({1000})(itself) == Approx(z.isNaN().select(0, z).sum() / whole.count()).epsilon(1e-12));
    CHECK(sums_of(z, g, 3).means({1000}).error(itself) == error);
    CHECK(sums_of(1e3 + z, g).means({1000}).error(itself) == Approx(error).epsilon(1e-6));
    CHECK(sums_of(1e-9 * z, g).means({1000}).error(itself) == Approx(1e-9 * error).epsilon(1e-10));
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
// whatever the points. (5) has K N_p/(N_p + 20) degrees of freedom, N_p = 100 here. (4) adds
// L = ¾ (0.3/√N + 2.8/N) at ν = N, and by the spread of ν up to 1 + 2/K times that: E[x²] of x = χ²/K. Of 400
// fields the rms is known to √(1/(2 · 400 K)), of which four are allowed.
TEST_CASE("the mean of white noise at any points has the error of so many heights",
          "[long-waves][statistics]") {
  constexpr Index n = 40;
  constexpr int fields = 400;
  for (int which = 0; which < 5; ++which) {
    const Field points = points_of(which, n);
    const double N = static_cast<double>((!points.isNaN()).count());
    double square = 0;
    double degrees = 0;
    for (unsigned seed = 0; seed < fields; ++seed) {
      const LocalMeans of = sums_of(points * white_noise({n, n}, seed), grid(n, n), n).means({100, 1});
      square += std::pow(of.error(itself), 2) / fields;
      degrees = of.degrees();
    }
    const double L = 0.75 * (0.3 / std::sqrt(N) + 2.8 / N),
                 k = std::array{3, 1, 3, 2, 2}[static_cast<std::size_t>(which)],
                 excess = std::sqrt(square * N) - 1, chance = 4 / std::sqrt(2.0 * fields * k);
    CAPTURE(which, N, k);
    CHECK(degrees == Approx(k == 1 ? 1 : k * 100 / 120));
    CHECK(excess >= -chance);
    CHECK(excess <= L * (1 + 2 / k) + chance);
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
  CHECK(of.degrees() == expected.degrees());
  CHECK(relative_error(of.error(itself), expected.error(itself)) <= 1e-10);
}

// Their sums vanish along the grooves but for rounding.
TEST_CASE("grooves have errors of slopes across them and none along them", "[derivative-error][law]") {
  for (const bool periodic : {false, true}) {
    const Field z = moving_average({40, 1}, {3, 1}, 4).replicate(1, 30) + 1e-3;
    const Grid g = grid(40, 30, periodic);
    const DerivativeErrors e(z, g, {100});
    CHECK(e([](const Derivatives& d) { return d.moments.m20; }) > 0);
    CHECK(e([](const Derivatives& d) { return d.moments.m40; }) > 0);
    CHECK(e([](const Derivatives& d) { return d.moments.m02; }) == 0);
    CHECK(e([](const Derivatives& d) { return d.moments.m04; }) == 0);
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
// t(3) = 3.2 or t(7) = 2.4 errors to either side, and does not reach into the grooves.
TEST_CASE("the interval of a plateau's median is as wide as its error", "[long-waves][law]") {
  Field z = 0.05 * moving_average({160, 160}, {3, 3}, 5);
  for (const Index column : {11, 37, 70, 71, 112, 140}) z.col(column) -= 2;
  const Parameters all = parameters_of(z, Group::quantiles);
  const Parameter& median = named(all, "quantile_0.5");
  const Interval ends = median.interval_95();
  REQUIRE(median.standard_error > 0);
  CHECK(ends.low >= median.value - 5 * median.standard_error);
  CHECK(ends.high <= median.value + 5 * median.standard_error);
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

// One of K waves has all the power A²: SE² = A²/K, ν = K, L = K/(6ν) = 1/6.
TEST_CASE("the error of a sequence's mean is that of its longest waves", "[sequence-error][exact]") {
  const Index n = 90;
  const double amplitude = 0.7;
  for (const auto& [independent, degrees] : {std::pair{3, 2}, {10, 3}, {20, 6}, {80, 16}}) {
    const double share = static_cast<double>(independent) / static_cast<double>(n) * (1 + 1e-12);
    for (const Index k : {1, degrees}) {
      const SequenceMean m = sequence_mean(5 + sequence_wave(n, k, amplitude), share, false);
      CAPTURE(independent, k);
      CHECK(m.degrees == degrees);
      CHECK(relative_error(m.mean, 5) <= 1e-14);
      CHECK(relative_error(m.spread, amplitude) <= 1e-13);
      CHECK(relative_error(m.mean_error, amplitude / std::sqrt(degrees) * 6 / 5) <= 1e-12);
    }
    CHECK(sequence_mean(5 + sequence_wave(n, degrees + 1, amplitude), share, false).mean_error <= 1e-12);
  }
  const SequenceMean around = sequence_mean(sequence_wave(n, 3, amplitude, true), 10.001 / n, true);
  CHECK(around.degrees == 4);
  CHECK(relative_error(around.mean_error, amplitude / 2 * 6 / 5) <= 1e-12);
  CHECK(std::isnan(sequence_mean(sequence_wave(n, 1, amplitude), 2.99 / n, false).mean_error));
  CHECK(std::isnan(sequence_mean(Eigen::ArrayXd::Constant(n, NAN), 1, false).mean));
}

// v² = s² (1 + b u), u the wave of two halves, and v changes its sign in the middle, where u is even: v̄ = 0,
// f = s b u/2, ν = K, L = 1/6 + 0.6/√K.
TEST_CASE("the error of a sequence's spread is that of the longest waves of its squares",
          "[sequence-error][exact]") {
  const Index n = 90;
  const double s = 3, b = 0.5, degrees = 16;
  Eigen::ArrayXd v = s * (1 + sequence_wave(n, 2, b)).sqrt();
  v.tail(n / 2) *= -1;
  const SequenceMean m = sequence_mean(v, 80.001 / n, false);
  CHECK(relative_error(m.spread, s) <= 1e-13);
  CHECK(relative_error(m.spread_error,
                       s * b / 2 / std::sqrt(degrees) / (1 - 1.0 / 6 - 0.6 / std::sqrt(degrees))) <= 1e-12);
}

TEST_CASE("errors of a sequence move with its scale, not with its place, its direction or absent values",
          "[sequence-error][law]") {
  const Field z = moving_average({1, 200}, {1, 5}, 3);
  const Eigen::ArrayXd v = z.row(0).transpose();
  const SequenceMean m = sequence_mean(v, 0.2, false), moved = sequence_mean(7 - 1e-3 * v, 0.2, false),
                     back = sequence_mean(v.reverse(), 0.2, false);
  CHECK(relative_error(moved.mean_error, 1e-3 * m.mean_error) <= 1e-10);
  CHECK(relative_error(moved.spread_error, 1e-3 * m.spread_error) <= 1e-10);
  CHECK(relative_error(back.mean_error, m.mean_error) <= 1e-10);
  // A sequence turned around its period, and one that lacks a value in three.
  Eigen::ArrayXd turned(200), fewer = v;
  turned << v.tail(77), v.head(123);
  CHECK(relative_error(sequence_mean(turned, 0.2, true).mean_error, sequence_mean(v, 0.2, true).mean_error) <=
        1e-10);
  for (Index j = 0; j < 200; j += 3) fewer(j) = NAN;
  const SequenceMean some = sequence_mean(fewer, 0.2, false);
  CHECK(some.count == 133);
  CHECK(some.independent == Approx(0.2 * 133).epsilon(1e-14));
  CHECK(std::abs(std::log(some.mean_error / m.mean_error)) <= 0.5);
}

// Of n sequences the mean square of the error has the relative deviation √(2/(K n)), that of the true one
// √(2/n), and the share of intervals √(0.95 · 0.05/n). What (3) takes too little or too much off is within a
// tenth.
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
        square += m.mean_error * m.mean_error / sequences;
        square_of_spread += m.spread_error * m.spread_error / sequences;
        covered += std::abs(m.mean) <= student_quantile(0.025, static_cast<double>(m.degrees)) * m.mean_error;
      }
      CAPTURE(periodic, window);
      const double margin = 0.1 + 4 * std::sqrt(0.5 / sequences);
      CHECK(std::sqrt(square) / mean.deviation() == Approx(1).margin(margin));
      CHECK(std::sqrt(square_of_spread) / spread.deviation() == Approx(1).margin(margin));
      CHECK(std::abs(covered / sequences - 0.95) <= 4 * std::sqrt(0.95 * 0.05 / sequences));
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
    intervals.push_back(Interval::of_inverse(
        m.spread, student_quantile(0.025, m.spread_degrees) * m.spread_error / m.spread));
  }
  const double truth = spread.mean();
  const auto covered =
      std::ranges::count_if(intervals, [&](const Interval& i) { return i.low <= truth && truth <= i.high; });
  CAPTURE(covered);
  CHECK(covered >= 880);
  CHECK(covered <= 980);
}
