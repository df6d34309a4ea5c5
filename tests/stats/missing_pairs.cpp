// Missing points in what counts pairs of points, or transforms: correlation, its errors, spectra.
#include "core/error.hpp"
#include "holes.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/missing.hpp"
#include "stats/hybrid/slopes.hpp"
#include "stats/hybrid/spectral_moments.hpp"
#include "stats/hybrid/summits.hpp"
#include "stats/sample/moments.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/spatial/acf_length.hpp"
#include "stats/spatial/pairs.hpp"
#include "stats/spectrum/spectrum.hpp"
#include "stats/uncertainty/effective_size.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

bool same_or_both_unknown(double a, double b, double bound) {
  return (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= bound;
}

}  // namespace

// Transforms add ε log2(torus) ≤ 12 ε of Σd² to each sum of pairs; the fewest pairs are one.
TEST_CASE(
    "the ACF and the structure function of a field with holes are the direct sums over pairs, at every lag",
    "[missing][exact]") {
  for (const bool periodic : {false, true})
    for (Shape shape : {Shape{12, 11}, Shape{9, 20}, Shape{16, 16}}) {
      const Field z = with_holes(random_field(shape, 211) + 2, 0.3, 212);
      const Grid g = grid(shape.nx, shape.ny, periodic);
      const Shape all = periodic ? default_max_lag(g) : Shape{shape.nx - 1, shape.ny - 1};
      const LagField R = estimate_autocorrelation(z, g, {.max_lag = all}),
                     biased = estimate_autocorrelation(z, g, {.max_lag = all, .biased = true}),
                     S = structure_function(z, g, all);
      const Pairs pairs = Pairs::of(z, g);
      const Field d = remove_form(z);
      const double sum = zero_filled(d).square().sum(), bound = 12 * epsilon * sum;
      for (Index p = 0; p <= all.nx; ++p)
        for (Index q = -all.ny; q <= all.ny; ++q) {
          CAPTURE(periodic, shape.nx, p, q);
          double n = 0;
          for_each_pair(z, periodic, p, q, [&](double, double) { ++n; });
          CHECK(pairs.pair_fraction(p, q) * pairs.points() == Approx(n).epsilon(1e-15).margin(0));
          const double direct = mean_over_pairs(d, periodic, p, q, [](double a, double b) { return a * b; });
          CHECK(same_or_both_unknown(R(p, q), direct, bound));
          CHECK(std::abs(biased(p, q) - (n > 0 ? direct * n / pairs.points() : 0)) <= bound);
          const double differences =
              mean_over_pairs(d, periodic, p, q, [](double a, double b) { return (a - b) * (a - b); });
          CHECK(same_or_both_unknown(S(p, q), differences, 10 * bound));
        }
    }
}

TEST_CASE("at a lag without a pair the ACF is not a number, and lengths end before it",
          "[missing][contract]") {
  Field z = Field::Constant(12, 12, none);
  z.leftCols(3) = random_field({12, 3}, 213);
  z.rightCols(3) = random_field({12, 3}, 214);
  const Grid g = grid(12, 12);
  const LagField R = estimate_autocorrelation(z, g, {.max_lag = {5, 11}});
  for (Index q = 3; q <= 6; ++q) CHECK(std::isnan(R(0, q)));
  CHECK_FALSE(std::isnan(R(0, 2)));
  CHECK_FALSE(std::isnan(R(0, 7)));
  Eigen::ArrayXd profile(4);
  profile << 1, 0.9, none, 0.05;
  CHECK_FALSE(first_crossing(profile, 0.1));
  Field unknown = Field::Ones(3, 5);
  unknown(1, 2) = none;
  const CentralLobe lobe = central_lobe(LagField(unknown), g);
  CHECK_FALSE(lobe.r_max);
  CHECK(EffectiveSampleSize::of_estimate(R, Pairs::of(z, g)).effective(2) > 0);
}

TEST_CASE("with holes the sums S_k are those over all pairs of points, over their number",
          "[missing][exact]") {
  const LagField rho = triangular_correlation({4, 3});
  for (const bool periodic : {false, true}) {
    const Grid g = grid(13, 12, periodic);
    const Field z = with_holes(random_field(g.shape, 215), 0.2, 216);
    const EffectiveSampleSize size(rho, Pairs::of(z, g));
    double sum = 0;
    for (Index p = -3; p <= 3; ++p)
      for (Index q = -2; q <= 2; ++q)
        for_each_pair(z, periodic, p, q, [&](double, double) { sum += std::pow(rho(p, q), 2); });
    CHECK(relative_error(size.sum(2), sum / size.points()) <= 100 * epsilon);
  }
}

// 400 fields: a spread is known to 3.5 %.
TEST_CASE("over an ensemble with holes the errors of the moments hold", "[missing][statistics]") {
  const Shape window{4, 3};
  const Grid g = grid(48, 40);
  const LagField rho = triangular_correlation(window);
  const Field holes = with_holes(Field::Zero(48, 40), 0.1, 217);
  const MomentErrors expected = standard_errors({.sq = 1}, EffectiveSampleSize(rho, Pairs::of(holes, g)));
  Spread mean_height, sq;
  for (unsigned seed = 0; seed < 400; ++seed) {
    const Moments m = moments(moving_average(g.shape, window, 5000 + seed) + holes);
    mean_height.add(m.mean);
    sq.add(m.sq);
  }
  CHECK(mean_height.deviation() == Approx(expected.mean).epsilon(0.1));
  CHECK(sq.deviation() == Approx(expected.sq).epsilon(0.15));
}

TEST_CASE("the PSD of a field with holes adds up to its Sq squared", "[missing][exact]") {
  const Grid g{{24, 30}, 0.5, 0.25, true};
  const Field d = remove_form(with_holes(random_field(g.shape, 224), 0.2, 225));
  const LagField psd = power_spectrum(d, g, {DataWindow::none, DataWindow::none});
  double sum = 0;
  for_each_lag(psd, g, [&](Index p, Index q, double weight) { sum += weight * psd(p, q); });
  const double sq = moments(d).sq;
  CHECK(relative_error(sum / (g.size_x() * g.size_y()), sq * sq) <= 1e-13);
}

// 300 masks of a wave of amplitude √2, Sq = 1, whose C is N ΔxΔy/2 at ±q and nothing elsewhere. The floor is
// a mean over 300 × 700 wave numbers, of which half are independent: 4 standard errors are 1.2 %, the mean
// taken off 0.3 %.
TEST_CASE("holes here and there, a share g, lay a floor of g Sq^2 dx dy below the PSD",
          "[missing][statistics]") {
  const Grid g{{32, 24}, 0.5, 0.25, true};
  const Field wave = sine(g.shape, std::numbers::sqrt2, 4);
  for (double share : {0.1, 0.4}) {
    Spread peak, floor;
    for (unsigned seed = 0; seed < 300; ++seed) {
      const Field chance = random_field(g.shape, 7000 + seed);
      const Field d = (chance < 2 * share - 1).select(none, wave);
      const LagField psd = power_spectrum(d, g, {DataWindow::none, DataWindow::none});
      peak.add(psd(4, 0));
      for_each_lag(psd, g, [&](Index p, Index q, double) {
        if (q != 0) floor.add(psd(p, q));
      });
    }
    const double C = 32 * 24 * g.cell_area() / 2;
    CHECK(peak.mean() == Approx((1 - share) * C + share * g.cell_area()).epsilon(0.01));
    CHECK(floor.mean() == Approx(share * g.cell_area()).epsilon(0.02));
  }
}

// Rings of white noise: 4 as for a complete field (tests of the spectrum).
TEST_CASE("rings of the PSD of white noise with holes stray by one standard error", "[missing][statistics]") {
  const Grid g = grid(128, 100);
  const DataWindows windows{DataWindow::hann, DataWindow::hann};
  const Field d = remove_form(with_holes(white_noise(g.shape, 226), 0.1, 227));
  double squares = 0, rings = 0;
  const LagField psd = power_spectrum(d, g, windows);
  for (const SpectrumPoint& ring : radial_spectrum(psd, g, shared_power(d, windows))) {
    if (ring.count < 30) continue;
    squares += std::pow((ring.density - 1) / ring.standard_error, 2);
    ++rings;
  }
  CHECK(squares / rings == Approx(1).margin(1.0));
}

TEST_CASE("a field whose holes are at its edge has the statistics of what they leave", "[missing][law]") {
  const Field inner = random_field({20, 18}, 228);
  Field z = Field::Constant(26, 21, none);
  z.block(3, 2, 20, 18) = inner;
  const Grid g = grid(26, 21), h = grid(20, 18);
  CHECK(relative_error(moments(z).sku, moments(inner).sku) <= 200 * epsilon);
  CHECK(relative_error(slope_parameters(z, g).sdr, slope_parameters(inner, h).sdr) <= 200 * epsilon);
  CHECK(relative_error(spectral_moments(z, g).m22, spectral_moments(inner, h).m22) <= 1000 * epsilon);
  CHECK(counted_summits(z, g).density == Approx(counted_summits(inner, h).density).epsilon(1e-14));
  CHECK(zero_filled(remove_form(z, 4)).abs().sum() ==
        Approx(remove_form(inner, 4).abs().sum()).epsilon(1e-11));
  const LagField R = estimate_autocorrelation(z, g, {.max_lag = {9, 8}}),
                 alone = estimate_autocorrelation(inner, h, {.max_lag = {9, 8}});
  CHECK((R.half_plane() - alone.half_plane()).abs().maxCoeff() <= 12 * epsilon * inner.square().sum());
  const LagField S = structure_function(z, g, {9, 8}), S_alone = structure_function(inner, h, {9, 8});
  CHECK((S.half_plane() - S_alone.half_plane()).abs().maxCoeff() <= 40 * epsilon * inner.square().sum());
}

// Of few pairs an estimated correlation exceeds 1, whose 512th power gave Sa an error of 1e43. Of 200 points, some
// independent, Sa is known to half of itself at least.
TEST_CASE("few pairs of points leave the errors of moments finite", "[missing][effective-size][law]") {
  const Grid g = grid(64, 64);
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Field chance = random_field(g.shape, 400 + seed);
    const Field z = (chance < 0.9).select(none, remove_form(moving_average(g.shape, {6, 6}, seed)));
    const Pairs pairs = Pairs::of(z, g);
    const LagField acf = estimate_autocorrelation(z, pairs, {.max_lag = default_max_lag(g)});
    const MomentErrors errors = standard_errors({.sq = 1}, EffectiveSampleSize::of_estimate(acf, pairs));
    CAPTURE(seed, errors.sa);
    CHECK(errors.sa <= 0.5);
  }
}
