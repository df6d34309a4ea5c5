// Errors of the mean and the spread of a sequence.
#include "stats/uncertainty/sequence_error.hpp"

#include <algorithm>
#include <vector>

#include "fields.hpp"
#include "stats/uncertainty/interval.hpp"
#include "stats/uncertainty/long_waves.hpp"

using namespace asperity;
using namespace asperity::test;

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
  const WaveSpectra spectra({Eigen::ArrayXd::LinSpaced(6, 1, 6).square()});
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
