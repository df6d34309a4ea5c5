#include "stats/hypothesis/gaussianity.hpp"

#include <gsl/gsl_cdf.h>

#include "fields.hpp"
#include "math/hermite.hpp"
#include "stats/hypothesis/simulated_law.hpp"
#include "stats/hypothesis/weighted_chi_squared.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

EffectiveSampleSize size_of(Shape window, const Grid& g) {
  return EffectiveSampleSize(triangular_correlation(window), g);
}

double normal_pdf(double x) { return std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi); }

// Some 800 independent patches at least.
Shape shape_for(Shape window) { return {16 * window.nx + 32, 16 * window.ny + 32}; }

// How often each of the four p-values, and each naive one, is below 5 %.
struct FalseAlarms {
  std::array<double, 4> rate{}, naive{};

  FalseAlarms(Shape shape, Shape window, int fields, unsigned seed) {
    const GaussianityTest test(size_of(window, grid(shape.nx, shape.ny)));
    for (int f = 0; f < fields; ++f) {
      const Field z = moving_average(shape, window, seed + static_cast<unsigned>(f));
      const auto fits = test(z, moments(z));
      for (std::size_t t = 0; t < 4; ++t) {
        rate[t] += (fits[t].p <= 0.05) / static_cast<double>(fields);
        naive[t] += (fits[t].naive_p <= 0.05) / static_cast<double>(fields);
      }
    }
  }
};

}  // namespace

// A few roundings of numbers below 3.
TEST_CASE("the Hermite functions are He_k φ/√k!", "[gaussianity][exact]") {
  for (double x : {-2.5, 0.0, 0.7, 3.0}) {
    const double phi = normal_pdf(x);
    HermiteFunction h(x, phi);
    for (double exact : {1.0, x, (x * x - 1) / std::sqrt(2), (x * x * x - 3 * x) / std::sqrt(6)})
      CHECK(std::abs(h.next() - exact * phi) <= 8 * epsilon);
  }
}

// Kolmogorov's 1.22385, 1.35810 and 1.62762 at 10 %, 5 % and 1 %, for D of a known Gaussian, a Brownian
// bridge; three of the simulation's errors √(p(1-p)/8192).
TEST_CASE("of a Brownian bridge the supremum has Kolmogorov's law", "[gaussianity][statistics]") {
  const Eigen::ArrayXd x = Eigen::ArrayXd::LinSpaced(97, -6, 6);
  const Eigen::MatrixXd bridge = Eigen::MatrixXd::NullaryExpr(97, 97, [&](Eigen::Index a, Eigen::Index b) {
    return gsl_cdf_ugaussian_P(x(std::min(a, b))) * gsl_cdf_ugaussian_Q(x(std::max(a, b)));
  });
  const NullDistribution law = supremum_distribution(x, bridge, 1);
  for (auto [value, p] : {std::pair{1.22385, 0.10}, {1.35810, 0.05}, {1.62762, 0.01}}) {
    CAPTURE(p, law.exceedance(value));
    CHECK(std::abs(law.exceedance(value) - p) <= 3 * std::sqrt(p * (1 - p) / NullDistribution::draws));
  }
}

// Stephens' table for a fitted Gaussian, J. Am. Stat. Assoc. 69 (1974) 730: 0.631, 0.752, 1.035 at 10 %, 5 %
// and 1 %. Half of the last digit is worth 1.5e-4 of p at most, the trapezoidal rule errs by 3e-4.
TEST_CASE("for independent heights A² has the law that is tabulated", "[gaussianity][exact]") {
  const Eigen::ArrayXd weights = anderson_darling_weights(size_of({1, 1}, grid(1000, 1000)));
  for (auto [value, p] : {std::pair{0.631, 0.10}, {0.752, 0.05}, {1.035, 0.01}})
    CHECK(std::abs(weighted_chi_squared_exceedance(weights, value) - p) <= 1.5e-4 + 3e-4);
}

// E[χ²] = B - 1 - B Σ (∫ He_1 φ)² - B Σ (∫ He_2 φ)²/2 over the bins.
TEST_CASE("the mean of Pearson's statistic is B - 1 less what the fit explains", "[gaussianity][exact]") {
  const EffectiveSampleSize size = size_of({1, 1}, grid(100, 100));
  for (int bins : {6, 20, 64}) {
    auto edge = [bins](int a) { return gsl_cdf_ugaussian_Pinv(static_cast<double>(a) / bins); };
    auto primitive = [&](int a, int k) {
      if (a == 0 || a == bins) return 0.0;
      const double x = edge(a);
      return (k == 1 ? 1 : x / std::sqrt(2)) * normal_pdf(x);
    };
    double explained = 0;
    for (int a = 0; a < bins; ++a)
      for (int k : {1, 2}) explained += bins * std::pow(primitive(a + 1, k) - primitive(a, k), 2);
    CHECK(pearson_weights(size, bins).sum() == Approx(bins - 1 - explained).epsilon(1e-9));
  }
}

TEST_CASE("the covariance of the empirical process is its Hermite series", "[gaussianity][exact]") {
  const Eigen::ArrayXd x = Eigen::ArrayXd::LinSpaced(5, -1, 1.5);
  const EffectiveSampleSize size = size_of({7, 4}, grid(80, 60));
  const Eigen::MatrixXd c = fitted_process_covariance(x, size);
  for (Eigen::Index a = 0; a < 5; ++a)
    for (Eigen::Index b = 0; b < 5; ++b) {
      HermiteFunction ha(x(a), normal_pdf(x(a))), hb(x(b), normal_pdf(x(b)));
      double series = 0;
      for (int k = 1; k <= EffectiveSampleSize::powers; ++k) {
        const double term = ha.next() * hb.next() / k;
        if (k >= 3) series += size.sum(k) * term;
      }
      // The terms beyond 512: |h_k h_k|/k < 0.13 k^{-3/2}, alternating where a ≠ b.
      CHECK(std::abs(c(a, b) - series) <= 0.26 / std::sqrt(512));
    }
}

// The rate's own error at 5 % over 300 fields is √(0.05·0.95/300) = 1.3 %; three of them. The naive p-value
// is the same where heights are independent.
TEST_CASE(
    "Gaussian fields of short and of long correlation are rejected at the stated rate, by the naive "
    "p-value far more often",
    "[gaussianity][statistics][slow]") {
  const double bound = 3 * std::sqrt(0.05 * 0.95 / 300);
  for (const Shape window : {Shape{1, 1}, Shape{3, 2}, Shape{8, 5}}) {
    const FalseAlarms alarms(shape_for(window), window, 300, 1000);
    for (std::size_t t = 0; t < 4; ++t) {
      CAPTURE(window.nx, t, alarms.rate[t], alarms.naive[t]);
      CHECK(std::abs(alarms.rate[t] - 0.05) <= bound);
      if (window == Shape{8, 5}) CHECK(alarms.naive[t] >= 0.3);
    }
  }
}

// A field whose heights are squares (χ² of one degree) has a skewness of √8.
TEST_CASE("heights that are squares of a Gaussian field's are not taken for Gaussian", "[gaussianity][law]") {
  const Shape window{6, 4};
  const Grid g = grid(128, 96);
  const Field z = moving_average(g.shape, window, 7).square();
  for (const GoodnessOfFit& fit : GaussianityTest(size_of(window, g))(z, moments(z)))
    CHECK(fit.p <= 1.001 / (NullDistribution::draws + 1));
}

// Sheppard's corrections leave errors of exp(-2π²(Sq/s)²): 3e-9 of steps of one Sq, times 2π²… to the second
// power in Sku.
TEST_CASE("a Gaussian rounded to steps has its moments before rounding", "[gaussianity][exact]") {
  for (const double step : {0.1, 0.5, 1.0}) {
    Moments m;
    double second = 0, third = 0, fourth = 0;
    for (int k = -200; k <= 200; ++k) {
      const double z = step * (k + 0.3),
                   p = gsl_cdf_ugaussian_P(z + step / 2) - gsl_cdf_ugaussian_P(z - step / 2);
      second += p * z * z, third += p * z * z * z, fourth += p * std::pow(z, 4);
    }
    m.sq = std::sqrt(second), m.ssk = third / std::pow(second, 1.5), m.sku = fourth / (second * second);
    const Moments before = before_rounding(m, step);
    CHECK(std::abs(before.sq - 1) <= 1e-5);
    CHECK(std::abs(before.ssk) <= 1e-5);
    CHECK(std::abs(before.sku - 3) <= 1e-5);
  }
}

// KS of the steps had p < 1.3e-4, A² and χ² 1e-100. The least of four p-values of a Gaussian field is below
// 2.5e-4 in less than one field of a thousand.
TEST_CASE("Gaussian heights in steps are no less Gaussian, and skewed ones still are not",
          "[gaussianity][statistics]") {
  const Field z = moving_average({96, 96}, {2, 2}, 31);
  const EffectiveSampleSize size = size_of({2, 2}, grid(96, 96));
  for (const double step : {0.3333333, 1.0}) {
    const double s = step * moments(z).sq;
    auto tested = [&](const Field& heights) {
      const Field rounded = s * (heights / s + 0.3).round();
      const HeightSteps found = height_steps(rounded);
      CHECK(std::abs(found.step - s) <= 1e-9 * s);
      return gaussianity_of_steps(runs_of_equal(rounded), moments(rounded), found, size);
    };
    for (const GoodnessOfFit& fit : tested(z)) {
      CAPTURE(step, fit.test, fit.p);
      CHECK(fit.p >= 2.5e-4);
    }
    for (const GoodnessOfFit& fit : tested(z + z.square() / moments(z).sq / 2)) CHECK(fit.p <= 1e-3);
  }
  const Field coarse = 2 * moments(z).sq * (z / (2 * moments(z).sq)).round();
  for (const GoodnessOfFit& fit :
       gaussianity_of_steps(runs_of_equal(coarse), moments(coarse), height_steps(coarse), size)) {
    CHECK(std::isnan(fit.p));
    CHECK_THAT(fit.why, ContainsSubstring("steps of "));
  }
}

// ---- simulated law ----

using Eigen::ArrayXd, Eigen::ArrayXXd;

namespace {

ArrayXd normals(Index count, unsigned seed) {
  return white_noise({1, count}, seed).reshaped<Eigen::RowMajor>();
}

SimulatedTogether all_of(const ArrayXXd& simulated, const ArrayXXd& observed) {
  std::vector<Compared> each;
  for (Index i = 0; i < simulated.cols(); ++i) each.push_back({simulated.col(i), observed.col(i)});
  return SimulatedTogether(each);
}

}  // namespace

// Skewness is odd: of values that are symmetric in ln x, √x or x² it vanishes at λ = 0, ½ and 2, and nowhere
// else. The root is where it is below 1e-6, and its slope in λ is of the order of the spread, ½ to 1 here.
TEST_CASE("the power without skewness is the one whose inverse made the values", "[simulated-law][exact]") {
  ArrayXd symmetric(6);
  symmetric << -0.9, -0.5, -0.1, 0.1, 0.5, 0.9;
  CHECK(std::abs(NormalisingPower(symmetric.exp()).lambda()) <= 1e-5);
  CHECK(std::abs(NormalisingPower((2 + symmetric).square()).lambda() - 0.5) <= 1e-5);
  CHECK(std::abs(NormalisingPower((2 + symmetric).sqrt()).lambda() - 2) <= 1e-5);
}

// Of -1, 0, 1 the mean is 0 and the deviation 1. t = 2/√(1 + 1/3) = √3 for one value of 2, and P(|t| > √3) = 1
// - √3/√(2 + 3) of two degrees; for the mean of three such, t = 2/√(2/3) = √6.
TEST_CASE("a mean is compared by Student's t of both means", "[simulated-law][exact]") {
  ArrayXd simulated(3);
  simulated << -1, 0, 1;
  CHECK(std::abs(p_of_mean({simulated, ArrayXd::Constant(1, 2)}) - (1 - std::sqrt(3.0 / 5))) <= 1e-14);
  CHECK(std::abs(p_of_mean({simulated, ArrayXd::Constant(3, -2)}) - (1 - std::sqrt(6.0 / 8))) <= 1e-14);
}

// Of -1, 0, 1 against a limit of -1 and a worth of 4: the mean is to be -1 + (0 + 1)/4 and its error that of four, and
// of twelve sixteen times as many simulated ones, √(1/4 + 1/48). Without a limit it is 0, and √(1/4 + 1/3).
TEST_CASE("a surface that is worth several simulated ones has their bias and error over as many",
          "[simulated-law][exact]") {
  ArrayXd simulated(3);
  simulated << -1, 0, 1;
  const Compared known{simulated, ArrayXd::Constant(1, 2), 4, -1},
      unknown{simulated, ArrayXd::Constant(1, 2), 4};
  CHECK(std::abs(known.t() - 2.75 / std::sqrt(1.0 / 4 + 1.0 / 48)) <= 1e-14);
  CHECK(std::abs(unknown.t() - 2 / std::sqrt(1.0 / 4 + 1.0 / 3)) <= 1e-14);
  CHECK(std::abs(unknown.mapped([](double x) { return std::exp(x); }).limit - 1) <= 1e-14);
}

// A kurtosis that is as skewed as 1/x² of a normal has λ = -2: the power is below ½, whatever the value.
TEST_CASE("a value far beyond the simulated ones is as improbable as it is far",
          "[simulated-law][contract]") {
  const ArrayXd simulated = (1 + 0.2 * normals(200, 1)).max(0.2).rsqrt();
  CHECK(NormalisingPower(simulated).lambda() < -1);
  double last = 1;
  for (const double far : {2.0, 4.0, 20.0, 1000.0}) {
    const double p = p_of_skewed_mean({simulated, ArrayXd::Constant(1, far)});
    CAPTURE(far, p);
    CHECK(p < last);
    last = p;
  }
  CHECK(last <= 1e-6);
  CHECK(p_of_skewed_mean({simulated, ArrayXd::Constant(1, 1e-3)}) <= 1e-6);
}

// Forty quantities of forty simulated surfaces, the first twenty hardly differing, and 60 sets of them; five surfaces
// each, alone or together. Three errors √(0.05·0.95/300) above and below 5 %: 1.2 to 8.8 %; alone the five have the
// set in common, which adds half as much.
TEST_CASE("the largest of many is exceeded as often as stated, with forty simulated surfaces",
          "[simulated-law][statistics]") {
  const Index quantities = 40, surfaces = 40;
  auto drawn = [&](Index count, unsigned seed) {
    ArrayXXd x = normals(count * quantities, seed).reshaped(count, quantities);
    x.leftCols(20) = 0.1 * x.leftCols(20) + normals(count, seed + 7000).replicate(1, 20);
    return x;
  };
  int alone = 0, together = 0;
  for (unsigned set = 0; set < 60; ++set) {
    const ArrayXXd simulated = drawn(surfaces, 2 * set), observed = drawn(5, 2 * set + 1);
    for (Index m = 0; m < 5; ++m) alone += all_of(simulated, observed.row(m)).p() <= 0.05;
    together += all_of(simulated, observed).p() <= 0.05;
  }
  CAPTURE(alone, together);
  CHECK(alone <= 300 * (0.05 + 1.5 * 3 * std::sqrt(0.05 * 0.95 / 300)));
  CHECK(alone >= 1);
  CHECK(together <= 60 * (0.05 + 3 * std::sqrt(0.05 * 0.95 / 60)));
}

// Of one quantity |t| is the largest, and each simulated value's is that against the other eleven: by (2), without (3).
// λ is known to 1e-6, round-off of t is amplified in the tail, and 1e-4 is far below what any other t_k would change.
TEST_CASE("the simulated largest deviations are those of each surface against the others",
          "[simulated-law][exact]") {
  const ArrayXd x = normals(12, 5);
  auto t = [](const ArrayXd& of, double value) {
    const auto n = static_cast<double>(of.size());
    const double deviation = std::sqrt((of - of.mean()).square().sum() / (n - 1));
    return std::abs(value - of.mean()) / (deviation * std::sqrt(1 + 1 / n));
  };
  ArrayXd largest(12), others(11);
  for (Index k = 0; k < 12; ++k) {
    others << x.head(k), x.tail(11 - k);
    largest(k) = t(others, x(k));
  }
  const double value = 4, p = all_of(x, ArrayXd::Constant(1, value)).p();
  CHECK(p == Approx(p_of_skewed_mean({largest, ArrayXd::Constant(1, t(x, value))}) / 2).epsilon(1e-4));
}

TEST_CASE("the deviation of the quantity that strays is the largest, and its p-value small",
          "[simulated-law][law]") {
  const ArrayXXd simulated = normals(200 * 9, 3).reshaped(200, 9);
  ArrayXXd observed = ArrayXXd::Zero(1, 9);
  CHECK(all_of(simulated, observed).p() >= 0.5);
  observed(0, 4) = -7;
  const SimulatedTogether strays = all_of(simulated, observed);
  Index most = 0;
  strays.deviations().abs().maxCoeff(&most);
  CHECK(most == 4);
  CHECK(strays.deviations()(4) < 0);
  CHECK(strays.p() <= 1e-6);
}
