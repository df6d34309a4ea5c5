// A field in strips beside the same field whole.
#include <algorithm>
#include <vector>

#include "core/error.hpp"
#include "holes.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/missing.hpp"
#include "stats/height/material_ratio.hpp"
#include "stats/height/order.hpp"
#include "stats/hypothesis/gaussianity.hpp"
#include "stats/profile/profile.hpp"
#include "stats/sample/moments.hpp"
#include "stats/spatial/strip_acf.hpp"
#include "stats/uncertainty/effective_size.hpp"
#include "whole.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// visit(strip, core) for strips of `rows`, with a halo of two rows.
template <class Visit>
void for_each_strip(const Field& z, bool periodic, Index rows, Visit visit) {
  const Index nx = z.rows();
  for (Index first = 0; first < nx; first += rows) {
    const Index core = std::min(rows, nx - first),
                halo = periodic ? 2 : std::min<Index>(2, nx - first - core);
    visit(Field(Field::NullaryExpr(core + halo, z.cols(),
                                   [&](Index i, Index j) { return z((first + i) % nx, j); })),
          core);
  }
}

std::vector<HeightBin> runs_of(const Field& z, Index cells = HeightBins::default_count) {
  HeightBins out(moments(z), cells);
  for_each_strip(z, false, 7, [&](const Field& strip, Index core) { out.add(strip.topRows(core)); });
  return out.ascending();
}

}  // namespace

// Sums of rows are added in the order of the rows, whatever the strips.
TEST_CASE("slopes, spectral moments and summits of strips are those of the whole field to the last bit",
          "[strips][law]") {
  for (const bool periodic : {false, true})
    for (const bool holes : {false, true}) {
      const Grid g{{29, 23}, 0.5, 0.7, periodic};
      const Field z = holes ? with_holes(random_field(g.shape, 301), 0.1, 302) : random_field(g.shape, 301);
      for (Index rows : {4, 7, 28}) {
        SlopeSums slopes;
        SpectralMomentSums spectral;
        SummitSums summits;
        for_each_strip(z, periodic, rows, [&](const Field& strip, Index core) {
          slopes.add({strip, g, core});
          spectral.add({strip, g, core}, mean(z));
          summits.add({strip, g, core}, mean(z));
        });
        CAPTURE(periodic, holes, rows);
        const SpectralMoments m = spectral.moments(g), whole = spectral_moments(z, g);
        CHECK(slopes.parameters(g).sdq == slope_parameters(z, g).sdq);
        CHECK(slopes.parameters(g).sdr == slope_parameters(z, g).sdr);
        CHECK((m.m00 == whole.m00 && m.m20 == whole.m20 && m.m11 == whole.m11 && m.m02 == whole.m02));
        CHECK((m.m40 == whole.m40 && m.m31 == whole.m31 && m.m22 == whole.m22 && m.m13 == whole.m13));
        CHECK(m.m04 == whole.m04);
        CHECK(summits.summits(g).count == counted_summits(z, g).count);
        CHECK(summits.summits(g).mean_curvature == counted_summits(z, g).mean_curvature);
      }
    }
}

// Sums of 41 · 37 heights in another order, twice or three times improved on: some ε √N of the heights, 40 ε.
TEST_CASE("the form of strips is that of the whole field to round-off, points missing or not",
          "[strips][exact]") {
  Field z = random_field({41, 37}, 9) +
            Field::NullaryExpr(41, 37, [](Index i, Index j) { return 0.1 * static_cast<double>(i * i - j); });
  for (const bool holes : {false, true}) {
    if (holes) z.block(10, 5, 9, 12).setConstant(std::nan(""));
    const Field whole = remove_form(z, 2);
    FormFit fit({41, 37}, 2);
    Field out = z - 40;
    while (!fit.done()) {
      for (Index first = 0; first < 41; first += 6) {
        Field strip = (z - 40).middleRows(first, std::min<Index>(6, 41 - first));
        fit.remove(strip, first);
        fit.add(strip, first);
      }
      fit.end_pass();
    }
    fit.remove(out, 0);
    CAPTURE(holes);
    CHECK(holes == out.isNaN().any());
    CHECK(((out - whole).isNaN().select(0, out - whole)).abs().maxCoeff() <= 40 * epsilon * 170);
  }
}

// As for whole fields: heights of multiples of 2⁻⁵⁰ m remain exact on top of 1 m.
TEST_CASE("moments of strips are those of the whole field to round-off, 1 nm on 1 m included",
          "[strips][exact]") {
  const double unit = std::ldexp(1.0, -50);
  const Field z = with_holes((random_field({64, 50}, 303) * (1e-9 / unit)).round() * unit + 1.0, 0.1, 304);
  MeanSum level;
  for_each_strip(z, false, 9, [&](const Field& strip, Index core) { level.add(strip.topRows(core)); });
  MomentSums sums(level.mean());
  for_each_strip(z, false, 9, [&](const Field& strip, Index core) { sums.add(strip.topRows(core)); });
  const Moments m = sums.moments("heights"), whole = moments(z);
  CHECK(relative_error(m.sq, whole.sq) <= 1e-13);
  CHECK(relative_error(m.sa, whole.sa) <= 1e-13);
  CHECK(std::abs(m.ssk - whole.ssk) <= 1e-13);
  CHECK(relative_error(m.sku, whole.sku) <= 1e-13);
  CHECK(relative_error(m.sp, whole.sp) <= 1e-13);
  CHECK(level.count() == static_cast<double>((!z.isNaN()).count()));
  CHECK_THROWS_AS(MeanSum().mean(), DataError);
}

TEST_CASE("ranks are those of the sorted heights, of both signs, repeated, tiny and infinite range",
          "[strips][exact]") {
  Field z = with_holes(random_field({40, 33}, 305), 0.1, 306);
  z.topRows(9) = (8 * z.topRows(9)).round() / 8;  // many are equal
  z(10, 30) = 1e300, z(11, 30) = -1e300, z(12, 30) = 5e-324, z(13, 30) = -5e-324, z(14, 30) = 0.0;
  std::vector<double> sorted;
  for (const double height : z.reshaped())
    if (!std::isnan(height)) sorted.push_back(height);
  std::ranges::sort(sorted);
  const std::vector<std::uint64_t> ranks{
      0, 1, 17, sorted.size() / 2, sorted.size() / 2 + 1, sorted.size() - 1};
  RankSelection selection(ranks);
  for (int pass = 0; pass < RankSelection::passes; ++pass) {
    for_each_strip(z, false, 7, [&](const Field& strip, Index core) { selection.add(strip.topRows(core)); });
    selection.end_pass();
  }
  for (std::size_t i = 0; i < ranks.size(); ++i) CHECK(selection.height(i) == sorted[ranks[i]]);
}

// Transforms add ε log2(torus) ≤ 12 ε of Σd² to each sum of pairs.
TEST_CASE("the ACF of strips is the direct mean over the pairs that lie in one strip", "[strips][exact]") {
  for (const bool holes : {false, true}) {
    const Grid g = grid(23, 14);
    const Field z = holes ? with_holes(random_field(g.shape, 307), 0.2, 308) : random_field(g.shape, 307);
    const Index rows = 6;
    StripAutocorrelation acf(g, rows);
    for_each_strip(z, false, rows, [&](const Field& strip, Index core) { acf.add(strip.topRows(core)); });
    const LagField R = acf.estimate();
    CHECK(R.max_p() == 3);
    for (Index p = 0; p <= R.max_p(); ++p)
      for (Index q = -R.max_q(); q <= R.max_q(); ++q) {
        double sum = 0, pairs = 0;
        for_each_strip(z, false, rows, [&](const Field& strip, Index core) {
          for_each_pair(strip.topRows(core), false, p, q, [&](double a, double b) { sum += a * b, ++pairs; });
        });
        CAPTURE(holes, p, q);
        CHECK(std::abs(R(p, q) - sum / pairs) <= 12 * epsilon * zero_filled(z).square().sum() / pairs);
      }
    CHECK(acf.pairs().complete() == !holes);
    CHECK(acf.pairs().points() == Approx(static_cast<double>((!z.isNaN()).count())).epsilon(1e-14));
  }
}

TEST_CASE("a correlation still above a tenth at the strips' longest lag is told, and none that is shorter",
          "[strips][contract]") {
  const StripAutocorrelation strips(grid(60, 20), 12);
  CHECK_FALSE(strips.reaches_beyond(triangular_correlation({6, 3})));
  CHECK(strips.reaches_beyond(triangular_correlation({12, 3})));
  CHECK_FALSE(StripAutocorrelation(grid(60, 20), 60).reaches_beyond(triangular_correlation({31, 3})));
}

// Cells of 2e-6 Sa hold one or two of 1320 heights, or many that are equal.
TEST_CASE("what rests on the order of heights is that of the whole field where runs hold two or equal ones",
          "[strips][exact]") {
  Field z = with_holes(random_field({40, 33}, 311), 0.1, 312);
  z.topRows(9) = (8 * z.topRows(9)).round() / 8;
  z(10, 30) = 1e3, z(11, 30) = -1e3;
  const std::vector<HeightBin> runs = runs_of(z);
  for (const HeightBin& run : runs) CHECK((run.count <= 2 || run.lowest == run.highest));
  CHECK(std::ranges::is_sorted(runs, {}, &HeightBin::highest));

  const MaterialRatioCurve curve(runs), whole(z);
  for (const double p : {0.0, 0.013, 0.1, 0.5, 0.8, 0.999, 1.0}) {
    CAPTURE(p);
    CHECK(std::abs(curve.height(p) - whole.height(p)) <= 4 * epsilon * std::abs(whole.height(p)));
    CHECK(curve.ratio(whole.height(p)) ==
          Approx(whole.ratio(whole.height(p))).margin(4 * epsilon).epsilon(0));
  }
  const CoreParameters core = curve.core(), of_whole = whole.core();
  CHECK(core.sk == Approx(of_whole.sk).epsilon(1e-11));
  CHECK(core.smr1 == Approx(of_whole.smr1).epsilon(1e-11));
  CHECK(core.spk == Approx(of_whole.spk).epsilon(1e-11));
  CHECK(core.svk == Approx(of_whole.svk).epsilon(1e-11));
  CHECK(curve.volumes().vmc == Approx(whole.volumes().vmc).epsilon(1e-11));
  CHECK(curve.volumes().vvv == Approx(whole.volumes().vvv).epsilon(1e-11));

  const GaussianityTest test(
      EffectiveSampleSize(triangular_correlation({3, 2}), Grid{{40, 33}, 1, 1, false}));
  const auto fits = test(runs, moments(z)), fits_of_whole = test(z, moments(z));
  for (std::size_t t = 0; t < fits.size(); ++t)
    CHECK(fits[t].statistic == Approx(fits_of_whole[t].statistic).epsilon(1e-11));
}

// Each height strays by less than the range of its run; a volume by their mean, and by c(p)'s twice. In least
// squares over 0.4 the slope strays by 3 δ/0.4, drawn out to the whole Sk by 7.5 δ. The others as the header
// says.
TEST_CASE(
    "with many heights a run the curve and the tests stray less than the runs are wide, and Sk by 7.5 of it",
    "[strips][exact]") {
  const Field z = moving_average({160, 150}, {4, 3}, 313);
  const Moments m = moments(z);
  const double n = static_cast<double>(z.size());
  for (const Index cells : {512, 4096}) {
    const std::vector<HeightBin> runs = runs_of(z, cells);
    const double w = 2 / static_cast<double>(cells);
    double mean_range = 0, largest_share = 0;
    for (const auto& [count, lowest, highest] : runs) {
      const double x = std::max(std::abs(lowest - m.mean), std::abs(highest - m.mean)) / m.sa;
      CHECK(highest - lowest <= 1.001 * w * (1 + x) * (1 + x) * m.sa);
      mean_range += count * (highest - lowest) / n, largest_share = std::max(largest_share, count / n);
    }
    CAPTURE(cells, mean_range, largest_share);
    CHECK(largest_share * n > 3);

    const MaterialRatioCurve curve(runs), whole(z);
    const double in_core = w * 10 * m.sa;  // |x| ≤ 2.1
    for (const double p : {0.05, 0.1, 0.3, 0.5, 0.77, 0.95})
      CHECK(std::abs(curve.height(p) - whole.height(p)) <= in_core);
    const CoreParameters core = curve.core(), of_whole = whole.core();
    CHECK(std::abs(core.sk - of_whole.sk) <= 7.5 * in_core);
    CHECK(std::abs(core.spk - of_whole.spk) <= 2 * 7.5 * in_core);
    CHECK(std::abs(core.svk - of_whole.svk) <= 2 * 7.5 * in_core);
    CHECK(std::abs(curve.volumes().vmp - whole.volumes().vmp) <= mean_range + 0.1 * in_core);
    CHECK(std::abs(curve.volumes().vvv - whole.volumes().vvv) <= mean_range + 0.2 * in_core);

    const GaussianityTest test(
        EffectiveSampleSize(triangular_correlation({4, 3}), Grid{{160, 150}, 1, 1, false}));
    const auto fits = test(runs, m), exact = test(z, m);
    const double ks = exact[1].statistic, chi = exact[3].statistic, bins = test.bins();
    CHECK(std::abs(fits[1].statistic - ks) <= std::sqrt(n) * largest_share);
    CHECK(std::abs(fits[2].statistic - exact[2].statistic) <= 15 * std::sqrt(n) * w * ks);
    CHECK(std::abs(fits[3].statistic - chi) <=
          4 * bins * largest_share * (std::sqrt(n * chi) + bins * largest_share * n));
  }
}

TEST_CASE("profile parameters of parts of the field average to those of the whole to the last bit",
          "[strips][law]") {
  for (const bool periodic : {false, true}) {
    const Field z = with_holes(random_field({30, 26}, 315), 0.1, 316);
    const Grid g{{30, 26}, 0.5, 0.7, periodic};
    const LagField rho = triangular_correlation({3, 2});
    for (const Axis1D along : {Axis1D::x, Axis1D::y}) {
      ProfileSums sums(g, along, 4);
      for (Index first = 0; first < (along == Axis1D::x ? 26 : 30); first += 9)
        sums.add(along == Axis1D::x ? Field(z.middleCols(first, std::min<Index>(9, 26 - first)))
                                    : Field(z.middleRows(first, std::min<Index>(9, 30 - first))));
      const ProfileAverages parts = sums.averages(g, rho), whole = average_profiles(z, g, along, 4, rho);
      for (std::size_t k = 0; k < parts.of.size(); ++k) {
        const SequenceMean &a = parts.of[k], &b = whole.of[k];
        CHECK((a.mean == b.mean && a.spread == b.spread));
        CHECK((a.mean_error == b.mean_error && a.spread_error == b.spread_error));
      }
    }
  }
}
