#include "marginal/johnson.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include "support.hpp"

using namespace asperity;
using namespace asperity::test;
using Family = Johnson::Family;

namespace {

// The trapezoidal rule in y itself. With a spacing of a quarter of δ or of 1 its error is below exp(-8π²):
// the poles of S_B lie πδ from the real axis. φ is 1e-125 at the ends, and the fourth power of S_U at K = 1e4
// below 1e70.
HeightMoments integrated(const Johnson& j) {
  const double h = std::min(j.delta, 1.0) / 4;
  const Index points = static_cast<Index>(48 / h);
  Eigen::ArrayXd y = Eigen::ArrayXd::LinSpaced(points, -24, 24), weight = (-y.square() / 2).exp();
  weight /= weight.sum();
  const Eigen::ArrayXd z = y.unaryExpr([&](double value) { return j(value); });
  const double mean = (weight * z).sum();
  const Eigen::ArrayXd d = z - mean;
  const double variance = (weight * d.square()).sum();
  return {mean, variance, (weight * d.cube()).sum() / std::pow(variance, 1.5),
          (weight * d.square().square()).sum() / (variance * variance)};
}

double kurtosis_of_lognormal(double skewness) {
  const double theta = 2 * std::asinh(skewness / 2), W = 4 * std::pow(std::sinh(theta / 6), 2), w = 1 + W;
  return 3 + W * (w * w * w + 3 * w * w + 6 * w + 6);
}

struct Pair {
  double skewness, kurtosis;
};

// From the least kurtosis to the largest, both sides of S_L, and about the normal, at logarithmic distances.
std::vector<Pair> plane() {
  std::vector<Pair> out;
  for (const double s : {0.0, 1e-12, 1e-9, 1e-6, 1e-4, 0.01, 0.2, 0.7, 1.5, 3.0, 6.0, 12.0, 25.0, 50.0}) {
    const double least = least_kurtosis(s), line = kurtosis_of_lognormal(s);
    auto add = [&](double k) {
      if (k >= least && k <= largest_kurtosis) out.push_back({s, k});
    };
    for (const double k : {least, 3.0, line, largest_kurtosis}) add(k);
    for (double step = 1e-13; step < 1e4; step *= 30)
      for (const double k : {least + step, line - step, line + step, 3 - step, 3 + step}) add(k);
  }
  return out;
}

double size(double moment) { return std::max(1.0, std::abs(moment)); }

}  // namespace

TEST_CASE("Any skewness and kurtosis of the plane is that of the heights to 1e-10, by another integral",
          "[johnson][law]") {
  for (const Pair& p : plane()) {
    const Johnson j = fit_johnson(p.skewness, p.kurtosis);
    const HeightMoments m = integrated(j);
    CAPTURE(p.skewness, p.kurtosis, name_of(j.family), j.gamma, j.delta);
    CHECK(std::abs(m.mean) <= 1e-12);
    CHECK(std::abs(m.variance - 1) <= 1e-12);
    CHECK(std::abs(m.skewness - p.skewness) <= 1e-10 * size(p.skewness));
    CHECK(std::abs(m.kurtosis - p.kurtosis) <= 1e-10 * p.kurtosis);
  }
}

// 256 terms of weight sum 1 carry a few ε of the largest of z⁴ φ, which is of the size of K.
TEST_CASE("The moments of a Johnson distribution are its integrals", "[johnson][law]") {
  for (const Pair& p : plane()) {
    const Johnson j = fit_johnson(p.skewness, p.kurtosis);
    const HeightMoments m = johnson_moments(j), exact = integrated(j);
    CAPTURE(p.skewness, p.kurtosis, name_of(j.family), j.gamma, j.delta);
    CHECK(std::abs(m.mean - exact.mean) <= 1e-13);
    CHECK(std::abs(m.variance - exact.variance) <= 1e-12);
    CHECK(std::abs(m.skewness - exact.skewness) <= 1e-12 * size(p.skewness));
    CHECK(std::abs(m.kurtosis - exact.kurtosis) <= 1e-12 * p.kurtosis);
  }
}

// K = (w⁴+2w²+3)/2 = 13.5 at w = 2. dK/dw = 20, so an error of 1e-13 of K moves w by 1e-13.
TEST_CASE("The symmetric S_U of K = 13.5 is sinh(y sqrt(ln 2)) / sqrt(3/2)", "[johnson][exact]") {
  const Johnson j = fit_johnson(0, 13.5);
  REQUIRE(j.family == Family::unbounded);
  CHECK(j.gamma == 0);
  CHECK(relative_error(j.delta, 1 / std::sqrt(std::numbers::ln2)) <= 1e-12);
  for (const double y : {-6.0, -1.0, -1e-3, 0.0, 0.5, 3.0}) {
    const double z = std::sinh(y * std::sqrt(std::numbers::ln2)) / std::sqrt(1.5);
    CHECK(std::abs(j(y) - z) <= 1e-11 * size(z));
  }
}

// w = 2: Sk = √1 · 4, K = 16 + 16 + 12 - 3.
TEST_CASE("Skewness 4 and kurtosis 41 are the lognormal of w = 2", "[johnson][exact]") {
  const Johnson j = fit_johnson(4, 41);
  REQUIRE(j.family == Family::lognormal);
  CHECK(relative_error(j.delta, 1 / std::sqrt(std::numbers::ln2)) <= 8 * epsilon);
  for (const double y : {-9.0, -1.0, 0.0, 1.0, 5.0}) {
    const double z = (std::exp(y * std::sqrt(std::numbers::ln2)) - std::numbers::sqrt2) / std::numbers::sqrt2;
    CHECK(std::abs(j(y) - z) <= 32 * epsilon * size(z));
  }
}

// Of chosen γ and δ: sinh t is a sum of lognormals, whose raw moments are E[exp(kt)] = exp(k²/2δ² - kγ/δ).
TEST_CASE("S_U gives back the parameters whose raw lognormal moments it was asked for", "[johnson][exact]") {
  for (const double delta : {0.9, 1.5, 4.0})
    for (const double gamma : {-5.0, -1.0, -0.1, 0.3, 2.0}) {
      auto e = [&](int k) { return std::exp(k * k / (2 * delta * delta) - k * gamma / delta); };
      const double m1 = (e(1) - e(-1)) / 2, m2 = (e(2) - 2 + e(-2)) / 4;
      const double m3 = (e(3) - 3 * e(1) + 3 * e(-1) - e(-3)) / 8;
      const double m4 = (e(4) - 4 * e(2) + 6 - 4 * e(-2) + e(-4)) / 16;
      const double variance = m2 - m1 * m1, third = m3 - 3 * m1 * m2 + 2 * m1 * m1 * m1;
      const double fourth = m4 - 4 * m1 * m3 + 6 * m1 * m1 * m2 - 3 * m1 * m1 * m1 * m1;
      CAPTURE(delta, gamma);
      const Johnson j = fit_johnson(third / std::pow(variance, 1.5), fourth / (variance * variance));
      REQUIRE(j.family == Family::unbounded);
      // Central moments lose up to 1e4 in the subtraction; S_L, d = exp(2γ/δ) = 1e-5, is approached to 1e-5.
      CHECK(std::abs(j.delta - delta) <= 1e-9);
      CHECK(std::abs(j.gamma - gamma) <= 1e-6);
      for (const double y : {-3.0, 0.0, 2.0})
        CHECK(std::abs(j(y) - (std::sinh((y - gamma) / delta) - m1) / std::sqrt(variance)) <= 1e-7);
    }
}

TEST_CASE("S_B gives back the parameters whose moments it was fitted to", "[johnson][law]") {
  for (const double delta : {0.02, 0.1, 0.5, 1.0, 2.5})
    for (const double gamma : {-2.5, -1.0, 0.0, 0.1, 1.7, 3.0}) {
      const Johnson given{Family::bounded, gamma, delta, gamma < 0 ? -1.0 : 1.0};
      const HeightMoments m = integrated(given);
      const Johnson found = fit_johnson(m.skewness, m.kurtosis);
      CAPTURE(delta, gamma, m.skewness, m.kurtosis);
      REQUIRE(found.family == Family::bounded);
      CHECK(std::abs(found.delta - delta) <= 1e-9 * size(delta));
      CHECK(std::abs(found.gamma - gamma) <= 1e-9 * size(gamma));
    }
}

// Symmetric S_B is tanh(y/2δ). With φ = φ(0)(1 - y²/2 + …), ∫ t² sech² = π²/6 and ∫ t² sech⁴ = (π²-6)/9,
//     A = E[sech²] = φ(0) [4δ - 2π²δ³/3],   B = E[sech² tanh²] = φ(0) [4δ/3 - 4δ³ (π²/18 + 2/3)],
// K = (1-A-B)/(1-A)². The next term of A is φ(0)/8 ∫ y⁴ sech²(y/2δ) dy = φ(0) 7π⁴/30 δ⁵ = 9 δ⁵, and K's less
// than twice that.
TEST_CASE("The least kurtosis at skewness 0 is that of two values with a narrow ascent", "[johnson][exact]") {
  const double delta = 1.0 / 64, phi = 1 / std::sqrt(2 * std::numbers::pi),
               pi2 = std::numbers::pi * std::numbers::pi;
  const double A = phi * (4 * delta - 2 * pi2 / 3 * std::pow(delta, 3));
  const double B = phi * (4 * delta / 3 - 4 * (pi2 / 18 + 2.0 / 3) * std::pow(delta, 3));
  CHECK(std::abs(least_kurtosis(0) - (1 - A - B) / ((1 - A) * (1 - A))) <= 18 * std::pow(delta, 5));
}

// z = y + Sk (y²-1)/6 + (K-3)(y³-3y)/24 - Sk² (2y³-5y)/36 + O(Sk³) where K-3 is of the order of Sk².
TEST_CASE("Near the normal g is the expansion of Cornish and Fisher", "[johnson][order]") {
  for (const double excess : {-5.0, 0.0, 1.0, 16.0 / 9, 4.0}) {
    auto error = [&](double s) {
      const Johnson j = fit_johnson(s, 3 + excess * s * s);
      double largest = 0;
      for (double y = -3; y <= 3; y += 0.25)
        largest = std::max(
            largest, std::abs(j(y) - y - s * (y * y - 1) / 6 - excess * s * s * (y * y * y - 3 * y) / 24 +
                              s * s * (2 * y * y * y - 5 * y) / 36));
      return largest;
    };
    const double coarse = error(0.02), fine = error(0.01);
    CAPTURE(excess, coarse, fine);
    CHECK(observed_order(coarse, fine) == Approx(3).margin(0.15));
    CHECK(fine <= 10 * std::pow(0.01, 3));
  }
}

TEST_CASE("g passes S_L from S_B to S_U without a jump", "[johnson][law]") {
  for (const double s : {0.1, 1.0, 4.0, 20.0}) {
    const double line = kurtosis_of_lognormal(s);
    const Johnson below = fit_johnson(s, line * (1 - 1e-9)), at = fit_johnson(s, line),
                  above = fit_johnson(s, line * (1 + 1e-9));
    CHECK(below.family == Family::bounded);
    CHECK(at.family == Family::lognormal);
    CHECK(above.family == Family::unbounded);
    for (double y = -4; y <= 4; y += 0.5)
      for (const Johnson& j : {below, above}) CHECK(std::abs(j(y) - at(y)) <= 1e-7 * size(at(y)));
  }
}

TEST_CASE("Negative skewness mirrors g to the last bit", "[johnson][law]") {
  for (const Pair& p : {Pair{0.5, 4}, Pair{1.3, 6}, Pair{2, 10}, Pair{4, 41}, Pair{1, 2.1}}) {
    const Johnson positive = fit_johnson(p.skewness, p.kurtosis),
                  negative = fit_johnson(-p.skewness, p.kurtosis);
    CHECK(negative.gamma == -positive.gamma);
    CHECK(negative.delta == positive.delta);
    for (double y = -8; y <= 8; y += 0.37) CHECK(negative(y) == -positive(-y));
  }
}

// Where S_B has saturated, z differs by its rounding: that of q, of a q and of the difference.
TEST_CASE("g increases", "[johnson][law]") {
  for (const Pair& p : plane()) {
    const Johnson j = fit_johnson(p.skewness, p.kurtosis);
    CAPTURE(p.skewness, p.kurtosis, name_of(j.family));
    double former = j(-8);
    for (double y = -7.75; y <= 8; y += 0.25) {
      const double z = j(y);
      CHECK(z - former >= -4 * epsilon * (size(z) + std::abs(j.offset)));
      former = z;
    }
    const double ascent = j.family == Family::bounded ? j.gamma : 0;
    CHECK(j(ascent + 0.1) > j(ascent - 0.1));
  }
}

// e^u - 1 is within 1.5 ε here and 1 ε in the C library, u = y/δ within ε in both, which is |u| ε of e^u, and
// the rest adds a few ε of z and of b.
TEST_CASE("apply gives every value that g does, whatever its neighbours", "[johnson][law]") {
  for (const Pair& p : plane()) {
    const Johnson j = fit_johnson(p.skewness, p.kurtosis);
    CAPTURE(p.skewness, p.kurtosis, name_of(j.family), j.delta);
    std::vector<double> y(37);
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = -9 + 0.5 * static_cast<double>(i);
    std::vector<double> z = y, tail(y.begin() + 5, y.end());
    j.apply(z);
    j.apply(tail);
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double exact = j(y[i]), scale = size(exact) + std::abs(j.offset);
      CHECK(std::abs(z[i] - exact) <= (8 + 2 * std::abs(y[i] / j.delta)) * epsilon * scale);
      if (i >= 5) CHECK(tail[i - 5] == z[i]);
    }
  }
}

TEST_CASE("Skewness 0 and kurtosis 3 are the normal itself", "[johnson][exact]") {
  for (const Pair& p : {Pair{0, 3}, Pair{1e-13, 3}, Pair{-1e-13, 3 - 1e-12}, Pair{0, 3 + 1e-12}}) {
    const Johnson j = fit_johnson(p.skewness, p.kurtosis);
    CHECK(j.family == Family::normal);
    std::array values{-3.0, 0.1, 40.0};
    j.apply(values);
    CHECK(values == std::array{-3.0, 0.1, 40.0});
    CHECK(j(1.25) == 1.25);
  }
}

TEST_CASE("The families are called normal, S_L, S_U and S_B", "[johnson][contract]") {
  CHECK(name_of(fit_johnson(0, 3).family) == "normal");
  CHECK(name_of(fit_johnson(4, 41).family) == "S_L");
  CHECK(name_of(fit_johnson(-0.5, 4).family) == "S_U");
  CHECK(name_of(fit_johnson(0, 1.8).family) == "S_B");
}

TEST_CASE("A kurtosis beyond the edge is answered with the least", "[johnson][contract]") {
  CHECK_THROWS_WITH(fit_johnson(-1, 1.9),
                    "1.9: must lie in 2.022059 ... 10000 at skewness -1 "
                    "(heights of two values have the least, skewness^2 + 1 = 2)");
  CHECK_THROWS_WITH(fit_johnson(0, 11000), "11000: must lie in 1.016827 ... 10000 at skewness 0");
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  for (const Pair& p :
       {Pair{0, 1}, Pair{0, 1.01}, Pair{1, -5}, Pair{0, 1.1e4}, Pair{0, not_a_number}, Pair{20, 400}})
    try {
      fit_johnson(p.skewness, p.kurtosis);
      FAIL(p.skewness << ", " << p.kurtosis << " was taken");
    } catch (const ParameterError& error) {
      CHECK(error.name == "kurtosis");
    }
}

TEST_CASE("A skewness beyond 50 is refused, whatever the kurtosis", "[johnson][contract]") {
  for (const double skewness :
       {50.1, -1e3, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    try {
      fit_johnson(skewness, 9000);
      FAIL(skewness << " was taken");
    } catch (const ParameterError& error) {
      CHECK(error.name == "skewness");
    }
    CHECK_THROWS_AS(least_kurtosis(skewness), ParameterError);
  }
}

TEST_CASE("The least kurtosis is taken, what is below it is not", "[johnson][contract]") {
  for (const double s : {-50.0, -3.0, 0.0, 1.0, 10.0}) {
    const double least = least_kurtosis(s);
    CHECK(least > s * s + 1);
    CHECK(least == least_kurtosis(-s));
    CHECK(relative_error(fit_johnson(s, least).delta, 1.0 / 64) <= 1e-10);
    CHECK_THROWS_AS(fit_johnson(s, least * (1 - 1e-12)), ParameterError);
  }
}
