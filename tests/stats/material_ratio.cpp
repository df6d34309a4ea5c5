#include "stats/height/material_ratio.hpp"

#include <algorithm>
#include <vector>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_statistics_double.h>

#include "core/error.hpp"
#include "fields.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// n heights whose material ratio curve is c, in an order that is none.
template <class Curve>
Field heights_of_curve(Index n, Curve c) {
  Field z(n, 1);
  for (Index k = 0; k < n; ++k) z(k) = c(static_cast<double>(k) / static_cast<double>(n - 1));
  std::mt19937_64 generator(3);
  std::shuffle(z.data(), z.data() + n, generator);
  return z;
}

// Straight from (0, hill) by (0.1, 1) and (0.8, 0) to (1, -dale).
double bent(double p, double hill, double dale) {
  return p < 0.1 ? hill - (hill - 1) * p / 0.1 : p < 0.8 ? (0.8 - p) / 0.7 : -dale * (p - 0.8) / 0.2;
}

}  // namespace

// Sums of N terms of the size of the range: N ε at the most. The slope, drawn out from 40 % to the whole,
// magnifies a sum's error by 12 · 0.4/0.4³ = 75.
TEST_CASE("heights spread evenly over a range H have Sk = H, no hills, no dales, and parabolic volumes",
          "[material-ratio][exact]") {
  const double H = 3e-6;
  for (Index n : {2, 5, 64, 1001}) {
    const MaterialRatioCurve curve(heights_of_curve(n, [&](double p) { return H * (1 - p); }));
    const CoreParameters core = curve.core();
    const double bound = static_cast<double>(n) * epsilon;
    CAPTURE(n);
    CHECK(relative_error(core.sk, H) <= 75 * bound);
    CHECK(std::abs(core.spk) <= 75 * H * bound);
    CHECK(std::abs(core.svk) <= 75 * H * bound);
    CHECK(core.smr1 <= 75 * bound);
    CHECK(core.smr2 >= 1 - 75 * bound);
    for (const double beyond : {core.spkx, core.svkx, core.sak1, core.sak2}) {
      CHECK(beyond >= 0);
      CHECK(beyond <= 75 * H * bound);
    }
    CHECK(std::abs(curve.fall({0.1, 0.8}) - 0.7 * H) <= H * bound);
    CHECK(std::abs(curve.fall(sxp_ratios) - 0.475 * H) <= H * bound);
    for (double p : {0.1, 0.37, 0.8}) {
      CHECK(std::abs(curve.volumes(p, p).vmp - H * p * p / 2) <= H * bound);
      CHECK(std::abs(curve.volumes(p, p).vvv - H * (1 - p) * (1 - p) / 2) <= H * bound);
    }
  }
}

// The core's line is 1 - (p - 0.1)/0.7: 8/7 at p = 0 and -2/7 at p = 1. What stands above and below it are
// triangles already.
TEST_CASE("of a curve of three straight pieces the Sk family is what the drawing says",
          "[material-ratio][exact]") {
  const double hill = 2.5, dale = 1.25, u = 8.0 / 7, v = -2.0 / 7, bound = 1001 * epsilon;
  const MaterialRatioCurve curve(heights_of_curve(1001, [&](double p) { return bent(p, hill, dale); }));
  const CoreParameters core = curve.core();
  CHECK(std::abs(core.sk - (u - v)) <= 75 * bound);
  CHECK(std::abs(core.smr1 - 0.1 * (hill - u) / (hill - 1)) <= 75 * bound);
  CHECK(std::abs(core.smr2 - (0.8 - 0.2 * v / dale)) <= 75 * bound);
  CHECK(std::abs(core.spk - (hill - u)) <= 75 * bound);
  CHECK(std::abs(core.svk - (v + dale)) <= 75 * bound);
  CHECK(std::abs(core.spkx - (hill - u)) <= 75 * bound);
  CHECK(std::abs(core.svkx - (v + dale)) <= 75 * bound);
  CHECK(std::abs(core.sak1 - 0.05 * (hill - u) * (hill - u) / (hill - 1)) <= 75 * bound);
  CHECK(std::abs(core.sak2 - 0.1 * (v + dale) * (v + dale) / dale) <= 75 * bound);
  CHECK(std::abs(curve.fall({0.1, 0.8}) - 1) <= bound);
  CHECK(std::abs(curve.fall(sxp_ratios) - (hill - 0.25 * (hill - 1) - 0.3 / 0.7)) <= bound);

  const VolumeParameters volumes = curve.volumes();
  CHECK(std::abs(volumes.vmp - 0.05 * (hill - 1)) <= bound);
  CHECK(std::abs(volumes.vmc - (0.05 * (hill + 1) + 0.35 - volumes.vmp)) <= bound);
  CHECK(std::abs(volumes.vvv - 0.1 * dale) <= bound);
  CHECK(std::abs(volumes.vvc - (0.35 + 0.1 * (2 + dale) - volumes.vvv)) <= bound);
}

// The core is 30 % to 70 %, |x| < b; ∫ x (Φ - ½) φ dx over it, by parts, gives the slope. N heights at the
// mid-ranks (k + ½)/N stand for the population: shares shift by 1/(2N), heights by that over φ, and the
// highest 1/N of the area, at heights of √(2 ln N), is cut off: some 20/N in all.
TEST_CASE("the Sk family of Gaussian heights tends to its closed form at order 1 in 1/N",
          "[material-ratio][order]") {
  const double b = gsl_cdf_ugaussian_Pinv(0.7);
  const double numerator = std::erf(b) / (2 * std::sqrt(std::numbers::pi)) - 0.4 * gsl_ran_ugaussian_pdf(b);
  const double sk = 12 * numerator / 0.064, u = sk / 2, share = gsl_cdf_ugaussian_Q(u);
  const double spk = 2 * (gsl_ran_ugaussian_pdf(u) / share - u);
  for (double n : {1e3, 1e4, 1e5}) {
    const Index points = static_cast<Index>(n);
    const MaterialRatioCurve curve(heights_of_curve(
        points, [&](double p) { return gsl_cdf_ugaussian_Qinv((std::round(p * (n - 1)) + 0.5) / n); }));
    const CoreParameters core = curve.core();
    CAPTURE(n, sk, spk, core.sk - sk, core.spk - spk);
    CHECK(std::abs(core.sk - sk) <= 20 / n);
    CHECK(std::abs(core.smr1 - share) <= 20 / n);
    CHECK(std::abs(core.smr2 - (1 - share)) <= 20 / n);
    CHECK(std::abs(core.spk - spk) <= 40 / n / share);
    CHECK(std::abs(core.svk - spk) <= 40 / n / share);
    CHECK(std::abs(core.sak1 - share * spk / 2) <= 40 / n);
    CHECK(std::abs(core.sak2 - share * spk / 2) <= 40 / n);
    CHECK(std::abs(core.spkx - (gsl_cdf_ugaussian_Qinv(0.5 / n) - u)) <= 20 / n);
    CHECK(std::abs(core.svkx - (gsl_cdf_ugaussian_Qinv(0.5 / n) - u)) <= 20 / n);
    CHECK(std::abs(curve.fall(sxp_ratios) - gsl_cdf_ugaussian_Qinv(0.025)) <= 20 / n);
    CHECK(std::abs(curve.volumes().vvv - curve.volumes().vmp) >= 0.01);  // at 80 % and 10 %, not mirrored
    CHECK(std::abs(curve.volumes(0.2, 0.8).vvv - curve.volumes(0.2, 0.8).vmp) <= 20 / n);
  }
}

TEST_CASE("a surface turned upside down exchanges hills and dales", "[material-ratio][law]") {
  const Field z = random_field({40, 25}, 41).cube() + 0.2 * random_field({40, 25}, 42);
  const double bound = 1000 * epsilon;
  const CoreParameters up = MaterialRatioCurve(z).core(), down = MaterialRatioCurve(1 - 2 * z).core();
  CHECK(std::abs(down.sk - 2 * up.sk) <= 150 * bound);
  CHECK(std::abs(down.spk - 2 * up.svk) <= 150 * bound);
  CHECK(std::abs(down.svk - 2 * up.spk) <= 150 * bound);
  CHECK(std::abs(down.smr1 - (1 - up.smr2)) <= 75 * bound);
  CHECK(std::abs(down.smr2 - (1 - up.smr1)) <= 75 * bound);
}

// The line of (0.4 rank) cos πp over p = 0 to 0.4: ∫ (p - 0.2) cos πp dp = s, twelve s/0.4³ the slope, about
// the mean sin(0.4π)/(0.4π). From rank to rank the sum differs from the integral by some 1/n². Dales lie below
// where the line leaves the curve for good.
TEST_CASE("of a sine the core is the first of its two flattest secants, as ISO 13565-2 has it",
          "[material-ratio][order]") {
  const double pi = std::numbers::pi, mean = std::sin(0.4 * pi) / (0.4 * pi),
               s = 0.2 * std::sin(0.4 * pi) / pi + (std::cos(0.4 * pi) - 1) / (pi * pi),
               slope = 12 * s / 0.064;
  for (const double n : {200.0, 2000.0}) {
    const Field z = heights_of_curve(static_cast<Index>(n) + 1, [&](double p) { return std::cos(pi * p); });
    for (const Field& either : {z, Field(-z)}) {
      const CoreParameters core = MaterialRatioCurve(either).core();
      CHECK(std::abs(core.sk + slope) <= 40 / (n * n));
      CHECK(std::abs(core.upper - (mean - 0.2 * slope)) <= 40 / (n * n));
      CHECK(core.smr2 < 1);
      CHECK((core.upper > 1 && core.spkx == 0 && core.sak1 == 0));  // nothing rises above the line
      CHECK(std::abs(core.svkx - (core.lower + 1)) <= 4 * epsilon);
    }
  }
  // Half at 1, half at 0: the first of the two flats, all of it.
  Field two = Field::Zero(20, 10);
  two.topRows(10) = 1;
  const CoreParameters core = MaterialRatioCurve(two).core();
  CHECK((core.sk == 0 && core.upper == 1 && core.smr1 == 0 && core.spk == 0));
  CHECK(core.svk > 1);
}

// u = v = 0 is the flat's height. Of the N = 2 m heights below the mid-ranks' Gaussian, m are 0: the last of
// them has the rank m - 1, the next height, within 2/N of 0, the rank m. ∫ x φ dx from 0 on is φ(0).
TEST_CASE("Gaussian heights clipped at their mean have Sk = 0, a base of one half, and 4 φ(0) on it",
          "[material-ratio][order]") {
  for (double n : {1e3, 1e4, 1e5}) {
    const Field z = heights_of_curve(static_cast<Index>(n), [&](double p) {
      return std::min(gsl_cdf_ugaussian_Qinv((std::round(p * (n - 1)) + 0.5) / n), 0.0);
    });
    for (const double sign : {1.0, -1.0}) {
      const CoreParameters core = MaterialRatioCurve(sign * z).core();
      CAPTURE(n, sign);
      CHECK((core.sk == 0 && (sign > 0 ? core.spk : core.svk) == 0));
      CHECK((sign > 0 ? core.smr1 : 1 - core.smr2) == 0);
      CHECK(std::abs((sign > 0 ? core.smr2 : 1 - core.smr1) - (0.5 * n - 1) / (n - 1)) <= n * epsilon);
      CHECK(std::abs((sign > 0 ? core.svk : core.spk) - 4 * gsl_ran_ugaussian_pdf(0)) <= 40 / n);
    }
  }
}

// One rank of N - 1 is the base; the triangle on it, of the pit's depth, is the pit.
TEST_CASE("a pit in a flat has its depth for Svk, a spike its height for Spk, and nothing else is there",
          "[material-ratio][exact]") {
  for (const double flat : {0.0, 0.1 / 3}) {
    Field z = Field::Constant(32, 32, flat);
    z(3, 4) -= 1;
    const CoreParameters pit = MaterialRatioCurve(z).core(), spike = MaterialRatioCurve(-z).core();
    CHECK((pit.sk == 0 && pit.spk == 0 && !std::signbit(pit.spk) && pit.smr1 == 0));
    CHECK(std::abs(pit.svk - 1) <= 1024 * epsilon);
    CHECK(std::abs(pit.smr2 - 1022.0 / 1023) <= 1024 * epsilon);
    CHECK((spike.sk == 0 && spike.svk == 0 && !std::signbit(spike.svk) && spike.smr2 == 1));
    CHECK(std::abs(spike.spk - 1) <= 1024 * epsilon);
    CHECK((pit.spkx == 0 && pit.sak1 == 0 && spike.svkx == 0 && spike.sak2 == 0));
    for (const double one : {pit.svkx, spike.spkx, 2 * 1023 * pit.sak2, 2 * 1023 * spike.sak1})
      CHECK(std::abs(one - 1) <= 2048 * epsilon);
    CHECK(std::abs(spike.smr1 - 1.0 / 1023) <= 1024 * epsilon);
  }
}

// Straight lines between the ranks end in half a step at either end: ∫ c dp is the trapezoidal rule.
TEST_CASE("the material above a height less the void below it is the mean height less that height",
          "[material-ratio][law]") {
  const Field z = random_field({30, 30}, 43);
  const MaterialRatioCurve curve(z);
  const double mean = (z.sum() - 0.5 * (z.maxCoeff() + z.minCoeff())) / 899;
  for (double p : {0.0, 0.01, 0.1, 0.512345, 0.8, 1.0})
    CHECK(std::abs(curve.volumes(p, p).vmp - curve.volumes(p, p).vvv - (mean - curve.height(p))) <=
          900 * epsilon);
}

TEST_CASE("quantiles are GSL's, and Smr undoes Smc", "[material-ratio][exact]") {
  const Field z = random_field({31, 17}, 44).exp();
  const MaterialRatioCurve curve(z);
  Field sorted = z;
  std::sort(sorted.data(), sorted.data() + sorted.size());
  const auto n = static_cast<std::size_t>(z.size());
  for (double p : {0.0, 1e-4, 0.025, 0.5, 0.77, 0.999, 1.0}) {
    CHECK(relative_error(curve.quantile(p), gsl_stats_quantile_from_sorted_data(sorted.data(), 1, n, p)) <=
          1000 * epsilon);
    CHECK(std::abs(curve.ratio(curve.height(p)) - p) <= 1000 * epsilon);
  }
  CHECK(curve.ratio(z.maxCoeff() + 1) == 0);
  CHECK(curve.ratio(z.minCoeff() - 1) == 1);
}

TEST_CASE("the material ratio curve is the same on any number of threads", "[material-ratio][law]") {
  const Field z = random_field({50, 41}, 45);
  const CoreParameters one = MaterialRatioCurve(z).core(), three = MaterialRatioCurve(z, 3).core();
  CHECK((one.sk == three.sk && one.spk == three.spk && one.svk == three.svk));
  CHECK((one.smr1 == three.smr1 && one.smr2 == three.smr2));
}

TEST_CASE("shares outside 0 to 1, shares out of order and a single height are refused",
          "[material-ratio][contract]") {
  const MaterialRatioCurve curve(random_field({5, 5}, 46));
  CHECK_THROWS_AS(curve.height(1.01), ParameterError);
  CHECK_THROWS_AS(curve.height(std::nan("")), ParameterError);
  CHECK_THROWS_AS(curve.volumes(0.8, 0.1), ParameterError);
  CHECK_THROWS_AS(curve.fall({0.8, 0.1}), ParameterError);
  CHECK_THROWS_AS(curve.fall({0.1, std::nan("")}), ParameterError);
  CHECK_THROWS_AS(MaterialRatioCurve(Field::Ones(1, 1)), DataError);
}

// All S_k are 1: the series is exact whatever its length. The k = 1 term, 1, is the mean's.
TEST_CASE("the error of a quantile of independent heights is p(1-p)/phi^2 less the mean's share",
          "[material-ratio][exact]") {
  const EffectiveSampleSize size(triangular_correlation({1, 1}), grid(20, 20));
  for (double p : {0.02, 0.1, 0.5, 0.8}) {
    const double a = gsl_cdf_ugaussian_Pinv(p), density = gsl_ran_ugaussian_pdf(a);
    const double exact = 2 * std::sqrt((p * (1 - p) / (density * density) - 1) / 400);
    CHECK(relative_error(material_height_error(p, {.sq = 2}, size), exact) <= 1e-10);
  }
}
