#include "stats/uncertainty/effective_size.hpp"

#include <gsl/gsl_cdf.h>

#include "core/error.hpp"
#include "fields.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/uncertainty/moment_interval.hpp"
#include "stats/hypothesis/weighted_chi_squared.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// Σ_{|p|<a} (1 - |p|/a)², the square of a triangle of base 2a.
double squared_triangle(double a) { return (2 * a * a + 1) / (3 * a); }

// N_eff for Sq of moving averages, from each field's own correlation, over that from the known one.
Spread estimated_over_known(const Grid& g, Shape window, unsigned fields, bool interlaced = false) {
  const double known = EffectiveSampleSize(triangular_correlation(window), g).effective(2);
  Spread out;
  for (unsigned seed = 0; seed < fields; ++seed) {
    Field z = moving_average(g.shape, window, seed);
    for (Index i = 1; interlaced && i < z.rows(); i += 2) z.row(i) = NAN;
    const Pairs pairs = Pairs::of(z, g);
    const LagField acf = estimate_autocorrelation(z, pairs, {.max_lag = default_max_lag(g)});
    out.add(EffectiveSampleSize::of_estimate(acf, pairs).effective(2) / known);
  }
  return out;
}

}  // namespace

TEST_CASE("N independent heights are worth N points for every moment", "[effective-size][exact]") {
  const EffectiveSampleSize size(triangular_correlation({1, 1}), grid(32, 20));
  for (int k : {1, 2, 3, 4, EffectiveSampleSize::powers}) CHECK(size.effective(k) == 640);
}

// Sums of 7 × 9 terms, each rounded.
TEST_CASE("a moving average over a x b points is worth N/(ab) points for the mean, N/(T(a)T(b)) for Sq",
          "[effective-size][exact]") {
  const EffectiveSampleSize size(triangular_correlation({4, 5}), grid(64, 64, true));
  CHECK(relative_error(size.effective(1), 4096.0 / 20) <= 64 * epsilon);
  CHECK(relative_error(size.effective(2), 4096.0 / (squared_triangle(4) * squared_triangle(5))) <=
        64 * epsilon);
}

// Σ cos² over a period is half its points, so S_2 = N/2, and Σ cos = 0.
TEST_CASE("a periodic sine is worth two points for Sq however many samples it has", "[effective-size][law]") {
  for (Index n : {16, 64, 256}) {
    const Grid g = grid(n, 8, true);
    const LagField acf = estimate_autocorrelation(sine(g.shape, 1e-6, 2), g, {.max_lag = default_max_lag(g)});
    CHECK(relative_error(EffectiveSampleSize(acf, g).effective(2), 2) <=
          100 * epsilon * static_cast<double>(n));
  }
}

TEST_CASE("Var of the mean equals the double sum of the correlation over all pairs of points",
          "[effective-size][exact]") {
  const LagField rho = triangular_correlation({5, 3});
  const Grid g = grid(9, 7);
  double sum = 0;
  for (Index i = 0; i < 9; ++i)
    for (Index j = 0; j < 7; ++j)
      for (Index k = 0; k < 9; ++k)
        for (Index l = 0; l < 7; ++l) sum += rho(k - i, l - j);
  CHECK(relative_error(EffectiveSampleSize(rho, g).sum(1) / 63, sum / (63 * 63)) <= 100 * epsilon);
}

// E|x| = √(2/π), E x² = 1.
TEST_CASE("Sa of N independent Gaussian heights has the variance (1 - 2/pi)/N", "[effective-size][exact]") {
  const EffectiveSampleSize size(triangular_correlation({1, 1}), grid(10, 10));
  const MomentErrors errors = standard_errors({.sq = 1}, size);
  CHECK(relative_error(errors.sa * errors.sa, (1 - 2 / std::numbers::pi) / 100) <= 1e-13);
  CHECK(relative_error(errors.sku, std::sqrt(0.24)) <= 4 * epsilon);
}

// E|xy| = (2/π)(√(1-ρ²) + ρ asin ρ) for a Gaussian pair: the closed form of the series behind Sa's error. The
// series ends at ρ⁵¹²; what it lacks of weight, O(512^{-3/2}), is counted with too large a sum.
TEST_CASE("Sa's standard error from the Hermite series is that of the closed form",
          "[effective-size][exact]") {
  const LagField rho = triangular_correlation({6, 4});
  const Grid g = grid(50, 30, true);
  double sum = 0;
  for_each_lag(rho, g, [&](Index p, Index q, double weight) {
    const double r = rho(p, q);
    sum += weight * 2 / std::numbers::pi * (std::sqrt(1 - r * r) + r * std::asin(r) - 1);
  });
  CHECK(relative_error(standard_errors({.sq = 1}, EffectiveSampleSize(rho, g)).sa, std::sqrt(sum / 1500)) <=
        1e-6);
}

// Admitted by chance are 0.27 % of the lags, each with ρ² of about 10/N: S_2 grows by 3 % at most.
TEST_CASE("the estimated correlation of white noise leaves N_eff within 6 % of N",
          "[effective-size][statistics]") {
  const Grid g = grid(96, 80);
  for (unsigned seed = 0; seed < 10; ++seed) {
    const LagField acf =
        estimate_autocorrelation(white_noise(g.shape, seed), g, {.max_lag = default_max_lag(g)});
    const EffectiveSampleSize size = EffectiveSampleSize::of_estimate(acf, g);
    CHECK(std::abs(size.effective(2) / 7680 - 1) <= 0.06);
    CHECK(std::abs(size.effective(4) / 7680 - 1) <= 0.01);
  }
}

// Of half the points, no other correlation is seen: lags without pairs once cut the sums short by a half. The
// mean of 20 estimates, each known to some 15 %.
TEST_CASE("a field of which every second row is missing is worth as much as the whole",
          "[effective-size][statistics]") {
  const Spread ratio = estimated_over_known(grid(144, 80), {9, 4}, 20, true);
  CHECK(ratio.mean() == Approx(1).epsilon(0.15));
}

// ρ = c of a part, 1 at lag zero: N_p is that of the part alone.
TEST_CASE("noise of single points does not add to the number of patches", "[effective-size][exact]") {
  const Grid g = grid(60, 50);
  const LagField part = triangular_correlation({8, 7});
  const double patches = EffectiveSampleSize(part, g).patches();
  CHECK(patches == Approx(EffectiveSampleSize(part, g).effective(2)).epsilon(1e-12));
  for (const double c : {0.9, 0.5, 0.2}) {
    const LagField both = LagField::of(
        part.max_lag(), [&](Index p, Index q) { return p == 0 && q == 0 ? 1.0 : c * part(p, q); });
    CAPTURE(c);
    // The sum of ρ² beside lag zero over c², and 1.
    CHECK(EffectiveSampleSize(both, g).patches() == Approx(patches).epsilon(1e-12));
  }
}

// Without the choice of lags, noise alone would add lags/N ≈ 1 times S_2 and the errors would be √2 too
// large; the admitted noise adds 3 % to S_2, the tail below 3√(S_2/N) = 0.12 takes as much away. S_1's window
// of four times the lags has a noise of some √(2·4·80/7680) = 30 % a field, 3 % over 100 of them.
TEST_CASE("standard errors from the estimated ACF are on average those from the known one",
          "[effective-size][statistics]") {
  const Shape window{5, 4};
  const Grid g = grid(96, 80);
  const MomentErrors known =
      standard_errors({.sq = 1}, EffectiveSampleSize(triangular_correlation(window), g));
  Spread mean, sq, sku;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Field z = moving_average(g.shape, window, seed);
    const LagField acf = estimate_autocorrelation(z, g, {.max_lag = default_max_lag(g)});
    const MomentErrors errors = standard_errors({.sq = 1}, EffectiveSampleSize::of_estimate(acf, g));
    mean.add(errors.mean), sq.add(errors.sq), sku.add(errors.sku);
  }
  CHECK(mean.mean() == Approx(known.mean).epsilon(0.10));
  CHECK(sq.mean() == Approx(known.sq).epsilon(0.05));
  CHECK(sku.mean() == Approx(known.sku).epsilon(0.05));
}

// S_2/N = 0.7 %: noise hides a tail of 7 % of S_2. 400 estimates, each known to 18 %: four of 0.9 %.
TEST_CASE("where the correlation is long, N_eff from the estimated ACF is on average that from the known one",
          "[effective-size][statistics]") {
  const Spread ratio = estimated_over_known(grid(64, 64), {8, 8}, 400);
  CHECK(ratio.mean() == Approx(1).epsilon(0.036));
}

// 3/√9 is 1: nothing but lag zero can stand out of the noise of nine points.
TEST_CASE("of a field of nine points lag zero is admitted", "[effective-size][exact]") {
  const Grid g = grid(3, 3);
  Field z(3, 3);
  z << 1, 2, 5, 3, 4, 0, 2, 2, 1;
  const LagField acf = estimate_autocorrelation(z - z.mean(), g, {.max_lag = {1, 1}});
  CHECK(significant_lags(acf, g)(0, 0) == 1);
  CHECK(EffectiveSampleSize::of_estimate(acf, g).effective(2) <= 9);
}

// Sums of at most 54 lags in another order, and transforms of the same heights, whose values of ρ differ by ε.
TEST_CASE("a map, its transpose and its mirror image are worth the same number of points",
          "[effective-size][law]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Shape shape{3 + static_cast<Index>(seed % 4), 3 + static_cast<Index>(seed / 4 % 7)};
    const Grid g{shape, 1, 1, seed % 3 == 0}, turned{{shape.ny, shape.nx}, 1, 1, seed % 3 == 0};
    const Field z = moving_average(shape, {2, 2}, seed);
    auto worth = [](const Field& heights, const Grid& grid) {
      const LagField acf =
          estimate_autocorrelation(heights - heights.mean(), grid, {.max_lag = longest_lags(grid)});
      return EffectiveSampleSize::of_estimate(acf, grid, FormModes(grid, 0)).effective(2);
    };
    CAPTURE(seed, shape.nx, shape.ny);
    CHECK(relative_error(worth(z.transpose(), turned), worth(z, g)) <= 1e-12);
    CHECK(relative_error(worth(z.rowwise().reverse(), g), worth(z, g)) <= 1e-12);
    CHECK(relative_error(worth(z.colwise().reverse(), g), worth(z, g)) <= 1e-12);
  }
}

// The lags in the order of their certainty, from all of them: what two passes find in less memory.
TEST_CASE("the lags that exceed noise are those that come before the first within three errors",
          "[effective-size][exact]") {
  for (const Grid& g : {grid(256, 80), grid(201, 67), Grid{{200, 96}, 2, 1.5, true}}) {
    const LagField rho =
        estimate_autocorrelation(3 + moving_average(g.shape, {4, 3}, 7), g, {.max_lag = default_max_lag(g)})
            .normalised();
    const Pairs pairs(g);
    std::vector<std::pair<double, WeightedLag>> all;
    for_each_lag(rho, pairs, [&](Index p, Index q, double weight) {
      const double z =
          p == 0 && q == 0 ? INFINITY : std::abs(rho(p, q)) * std::sqrt(pairs.pair_fraction(p, q));
      all.push_back({z, {p, q, rho(p, q), weight}});
    });
    std::ranges::sort(all, std::greater(), [](const auto& lag) { return lag.first; });
    double sum = 0;
    std::size_t admitted = 0;
    for (const auto& [z, lag] : all) {
      if (z <= 3 * std::sqrt(sum / pairs.points())) break;
      sum += lag.weight * lag.rho * lag.rho;
      ++admitted;
    }
    CAPTURE(text(g.shape));
    CHECK(admitted > 12);
    CHECK(significant(rho, pairs).size() == admitted);
  }
}

// ---- weighted chi squared ----

namespace {

// exp(-y) Σ yᵏ/k! over k < n/2, y = x/2, of n degrees, n even; erfc(√y) of one.
double chi_squared_exceedance(double x, int degrees) {
  if (degrees == 1) return std::erfc(std::sqrt(x / 2));
  double term = std::exp(-x / 2), sum = term;
  for (int k = 1; k < degrees / 2; ++k) sum += term *= x / 2 / k;
  return sum;
}

}  // namespace

// The rule's error, 4e-17 of the integrand, and the round-off of a hundred nodes, each of a K and an x s up
// to 100: 100 · 100 ε = 2e-12. 1e-10 is what the header says.
TEST_CASE("equal weights give the chi-squared law of as many degrees", "[weighted-chi-squared][exact]") {
  for (int degrees : {1, 2, 4, 12, 60})
    for (double weight : {1.0, 3e-7})
      for (double quantile : {0.01, 0.5, 0.95, 0.999, 1 - 1e-12}) {
        const double x = gsl_cdf_chisq_Pinv(quantile, degrees);
        const double p =
            weighted_chi_squared_exceedance(Eigen::ArrayXd::Constant(degrees, weight), weight * x);
        CAPTURE(degrees, weight, quantile);
        CHECK(relative_error(p, chi_squared_exceedance(x, degrees)) <= 1e-10);
      }
}

// Pairs a, a, b, b, c, c: Σ λ²/Π(λ - λ') exp(-x/2λ), a mixture of exponentials whose terms cancel to a tenth.
TEST_CASE("pairs of weights give the closed mixture of exponentials", "[weighted-chi-squared][exact]") {
  const double a = 1, b = 0.5, c = 0.3;
  Eigen::ArrayXd weights(6);
  weights << a, b, c, c, b, a;
  for (double x : {0.1, 1.0, 4.0, 10.0, 30.0, 200.0}) {
    auto term = [x](double l, double m, double n) {
      return l * l / ((l - m) * (l - n)) * std::exp(-x / 2 / l);
    };
    const double exact = term(a, b, c) + term(b, a, c) + term(c, a, b);
    CAPTURE(x);
    CHECK(relative_error(weighted_chi_squared_exceedance(weights, x), exact) <= 1e-10);
  }
}

// A² of a known Gaussian has the weights 1/(j(j+1)); its quantiles at 10 %, 5 % and 1 % are 1.932958,
// 2.492367 and 3.878125 (Marsaglia and Marsaglia, J. Stat. Softw. 9 (2004) 2). The weights beyond 400 are
// worth their mean, 1/401, and a variance of 2/(3·401³), 1e-8.
TEST_CASE("the weights 1/j(j+1) give the quantiles of Anderson and Darling",
          "[weighted-chi-squared][exact]") {
  const Eigen::ArrayXd weights = Eigen::ArrayXd::NullaryExpr(
      400, [](Eigen::Index j) { return 1 / static_cast<double>((j + 1) * (j + 2)); });
  for (auto [quantile, p] : {std::pair{1.932958, 0.10}, {2.492367, 0.05}, {3.878125, 0.01}})
    CHECK(std::abs(weighted_chi_squared_exceedance(weights, quantile - 1.0 / 401) - p) <= 1e-6);
}

TEST_CASE("no weight, or a value below zero, leaves no doubt", "[weighted-chi-squared][contract]") {
  CHECK(weighted_chi_squared_exceedance(Eigen::ArrayXd::Zero(3), 0.1) == 0);
  CHECK(weighted_chi_squared_exceedance(Eigen::ArrayXd::Ones(8), 0) == 1);
  CHECK(weighted_chi_squared_exceedance(Eigen::ArrayXd::Ones(8), 1e7) == 0);
}

// ---- moment interval ----

// All S_k are 1.
TEST_CASE("independent heights have Fisher's intervals", "[moment-interval][exact]") {
  const EffectiveSampleSize size(triangular_correlation({1, 1}), grid(5, 8));
  const Moments m{.mean = 7, .sa = 1.5, .sq = 2, .ssk = 0.3, .sku = 2.5};
  const MomentIntervals i = confidence_intervals(m, size);
  const double left = std::sqrt(39.0 / 40), t = gsl_cdf_tdist_Qinv(0.025, 39);
  CHECK(relative_error(i.mean.high - 7, t * 2 / std::sqrt(39)) <= 1e-12);
  CHECK(relative_error(7 - i.mean.low, t * 2 / std::sqrt(39)) <= 1e-12);
  CHECK(relative_error(i.sq.low, 2 / left * std::sqrt(40 / gsl_cdf_chisq_Pinv(0.975, 40))) <= 1e-12);
  CHECK(relative_error(i.sq.high, 2 / left * std::sqrt(40 / gsl_cdf_chisq_Pinv(0.025, 40))) <= 1e-12);
  CHECK(relative_error(i.ssk.high - i.ssk.low, 2 * 1.959964 * std::sqrt(6 * 38 / (41.0 * 43))) <= 1e-6);
  CHECK(relative_error(i.sku.high + i.sku.low, 2 * (2.5 + 6 / 40.0)) <= 1e-12);
  CHECK(relative_error(i.sku.high - i.sku.low,
                       2 * 1.959964 * std::sqrt(24 * 40.0 * 38 * 37 / (41.0 * 41 * 43 * 45))) <= 1e-6);
}

// 1500 fields of 4 × 4 correlation lengths know their deviation to 1/√3000 = 1.8 %, four of which are
// allowed, and 4 % for the third order. To first order, and as of independent heights, the variance would be
// 6/ν_3 and 0.92 of that: the deviation too large by 22 and 17 %.
TEST_CASE("the skewness of few patches varies as the second order says, not the first",
          "[moment-interval][statistics]") {
  const EffectiveSampleSize size(triangular_correlation({16, 16}), grid(64, 64));
  Spread ssk;
  for (unsigned seed = 0; seed < 1500; ++seed) ssk.add(moments(moving_average({64, 64}, {16, 16}, seed)).ssk);
  const Interval i = confidence_intervals({.mean = 0, .sa = 0.8, .sq = 1, .ssk = 0, .sku = 3}, size).ssk;
  CHECK(std::abs(i.high / 1.959964 / ssk.deviation() - 1) <= 4 * 0.018 + 0.04);
}

// Wilson and Hilferty's cube root against the chi-squared's own quantiles: 0.05 ν^{-3/2} of them, half of it
// of a root.
TEST_CASE("at ten thousand independent heights the interval of Sq goes on as it was",
          "[moment-interval][exact]") {
  const EffectiveSampleSize size(triangular_correlation({1, 1}), grid(100, 100));
  const Interval sq = confidence_intervals({.sa = 0.8, .sq = 1, .sku = 3}, size).sq;
  const double left = std::sqrt(1 - 1e-4), bound = 0.025 * std::pow(1e4, -1.5);
  CHECK(relative_error(sq.low, std::sqrt(1e4 / gsl_cdf_chisq_Pinv(0.975, 1e4)) / left) <= bound);
  CHECK(relative_error(sq.high, std::sqrt(1e4 / gsl_cdf_chisq_Pinv(0.025, 1e4)) / left) <= bound);
}

// Of 4e6 to 4e8 heights the intervals are 1.96 standard errors to first order; the second is their square.
TEST_CASE("of millions of independent heights the intervals are 1.96 standard errors",
          "[moment-interval][law]") {
  for (Index n : {2000, 6000, 20000}) {
    const EffectiveSampleSize size(triangular_correlation({1, 1}), grid(n, n));
    const Moments m{.mean = 0, .sa = 0.7978845608, .sq = 1, .ssk = 0, .sku = 3};
    const MomentErrors error = standard_errors(m, size);
    const MomentIntervals i = confidence_intervals(m, size);
    auto halves = [&](const Interval& interval, double value, double of) {
      CHECK(std::abs((interval.high - value) / (1.959964 * of) - 1) <= 6 * of / value + 1e-6);
      CHECK(std::abs((value - interval.low) / (1.959964 * of) - 1) <= 6 * of / value + 1e-6);
    };
    CAPTURE(n);
    halves(i.sq, 1, error.sq);
    halves(i.sa, m.sa, error.sa);
    halves(i.sku, 3, error.sku);
    CHECK(relative_error(i.mean.high, 1.959964 * error.mean) <= 1e-5);
    CHECK(relative_error(i.ssk.high, 1.959964 * error.ssk) <= 1e-5);
  }
}

TEST_CASE("an interval of half the confidence is narrower, and about the same scale",
          "[moment-interval][law]") {
  const Field z = moving_average({40, 40}, {3, 3}, 5);
  const EffectiveSampleSize size(triangular_correlation({3, 3}), grid(40, 40));
  const MomentIntervals wide = confidence_intervals(moments(z), size),
                        narrow = confidence_intervals(moments(z), size, 0.5);
  for (auto part : {&MomentIntervals::mean, &MomentIntervals::sa, &MomentIntervals::sq, &MomentIntervals::ssk,
                    &MomentIntervals::sku}) {
    CHECK((wide.*part).low < (narrow.*part).low);
    CHECK((narrow.*part).high < (wide.*part).high);
  }
}

TEST_CASE("a confidence that is none is refused, and so few patches have no interval",
          "[moment-interval][contract]") {
  const EffectiveSampleSize few(triangular_correlation({9, 9}), grid(3, 3));
  const Moments m{.mean = 0, .sa = 0.8, .sq = 1, .ssk = 0, .sku = 3};
  for (double level : {0.0, 1.0, -2.0, std::nan("")})
    CHECK_THROWS_AS(confidence_intervals(m, few, level), ParameterError);
  CHECK(std::isnan(confidence_intervals(m, few).sku.low));
}
