// Missing points are left out: every statistic of a field with holes beside a sum over what is there.
#include "stats/missing.hpp"

#include <algorithm>
#include <vector>

#include "fields.hpp"
#include "grid/error.hpp"
#include "stats/acf.hpp"
#include "stats/acf_error.hpp"
#include "stats/acf_length.hpp"
#include "stats/acf_lobe.hpp"
#include "stats/derivative_error.hpp"
#include "stats/distribution.hpp"
#include "stats/form.hpp"
#include "stats/gaussian_filter.hpp"
#include "stats/material_ratio.hpp"
#include "stats/moments.hpp"
#include "stats/pairs.hpp"
#include "stats/slopes.hpp"
#include "stats/spectral_moments.hpp"
#include "stats/spectrum.hpp"
#include "stats/structure_function.hpp"
#include "stats/summits.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// A hole of a fifth of the field that reaches its edge, and a share of single points; the first point is missing too.
Field with_holes(Field z, double share, unsigned seed) {
  z.block(z.rows() / 3, 0, z.rows() / 3, z.cols() / 2).setConstant(none);
  const Field chance = random_field(shape_of(z), seed);
  z = (chance < 2 * share - 1).select(none, z);
  z(0, 0) = none;
  return z;
}

std::vector<double> valid_heights(const Field& z) {
  std::vector<double> out;
  for (const double height : z.reshaped<Eigen::RowMajor>())
    if (!std::isnan(height)) out.push_back(height);
  return out;
}

long double mean_power(const std::vector<double>& heights, long double level, int power) {
  long double sum = 0;
  for (const double height : heights) sum += std::pow(static_cast<long double>(height) - level, power);
  return sum / static_cast<long double>(heights.size());
}

Field plane(const Grid& g, double a, double b, double c = 0) {
  return sample(g, [=](double x, double y) { return c + a * x + b * y; });
}

// visit(z, z', pairs so far) over the pairs of points at lag (p,q) that are there.
template <class Visit>
void for_each_pair(const Field& z, bool periodic, Index p, Index q, Visit visit) {
  const Index nx = z.rows(), ny = z.cols();
  for (Index i = 0; i < nx; ++i)
    for (Index j = 0; j < ny; ++j) {
      const Index a = i + p, b = j + q;
      if (!periodic && (a < 0 || a >= nx || b < 0 || b >= ny)) continue;
      const double first = z(i, j), second = z((a + nx) % nx, (b + ny) % ny);
      if (!std::isnan(first) && !std::isnan(second)) visit(first, second);
    }
}

double mean_over_pairs(const Field& z, bool periodic, Index p, Index q, double (*f)(double, double)) {
  double sum = 0, pairs = 0;
  for_each_pair(z, periodic, p, q, [&](double a, double b) { sum += f(a, b), ++pairs; });
  return sum / pairs;
}

bool same_or_both_unknown(double a, double b, double bound) {
  return (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= bound;
}

}  // namespace

TEST_CASE("moments of a field with holes are those of the heights that are there", "[missing][exact]") {
  const Field z = with_holes(random_field({41, 57}, 201).exp() + 1, 0.2, 202);
  const std::vector<double> heights = valid_heights(z);
  const long double level = mean_power(heights, 0, 1), square = mean_power(heights, level, 2);
  const Moments m = moments(z);
  const double bound = 4 * epsilon * static_cast<double>(41 + 57);
  CHECK(relative_error(m.mean, static_cast<double>(level)) <= bound);
  CHECK(relative_error(m.sq, static_cast<double>(std::sqrt(square))) <= bound);
  CHECK(relative_error(m.ssk, static_cast<double>(mean_power(heights, level, 3) / std::pow(square, 1.5L))) <=
        4 * bound);
  CHECK(relative_error(m.sku, static_cast<double>(mean_power(heights, level, 4) / (square * square))) <=
        bound);
  const auto [low, high] = std::ranges::minmax(heights);
  CHECK(relative_error(m.sp, high - m.mean) <= bound);
  CHECK(relative_error(m.sv, m.mean - low) <= bound);
}

TEST_CASE("a field of which every point is missing is refused", "[missing][contract]") {
  const Field z = Field::Constant(6, 5, none);
  CHECK_THROWS_AS(moments(z), DataError);
  CHECK_THROWS_AS(mean(z), DataError);
  CHECK_THROWS_AS(MaterialRatioCurve(z), DataError);
  CHECK_THROWS_AS(slope_parameters(z, grid(6, 5)), DataError);
  CHECK_THROWS_AS(counted_summits(z, grid(6, 5)), DataError);
}

TEST_CASE("the material ratio curve and the histogram hold the heights that are there and no others",
          "[missing][exact]") {
  const Field z = with_holes(random_field({30, 31}, 203), 0.3, 204);
  const std::vector<double> heights = valid_heights(z);
  const Field there = Eigen::Map<const Field>(heights.data(), 1, static_cast<Index>(heights.size()));
  const MaterialRatioCurve curve(z, 2), alone(there);
  for (double p : {0.0, 0.1, 0.37, 0.8, 1.0}) CHECK(curve.height(p) == alone.height(p));
  CHECK(curve.core().sk == alone.core().sk);
  const EffectiveSize size(triangular_correlation({1, 1}), Pairs::of(z, grid(30, 31)));
  CHECK(size.points() == static_cast<double>(heights.size()));
  const std::vector<Bin> bins = histogram(z, moments(z), size, 7),
                         expected = histogram(there, moments(there), size, 7);
  for (std::size_t b = 0; b < 7; ++b) CHECK(bins[b].count == expected[b].count);
}

TEST_CASE("a tilted plane with holes has the slope and the area of the plane", "[missing][exact]") {
  for (const bool single : {false, true}) {
    const Grid g{{17, 23}, 0.5, 0.25, false};
    const Field z = single ? Field(plane(g, 0.3, 0.7)) : with_holes(plane(g, 0.3, 0.7), 0.2, 205);
    const SlopeParameters p = slope_parameters(z, g);
    CHECK(std::abs(p.sdq - std::hypot(0.3, 0.7)) <= 200 * epsilon);
    CHECK(std::abs(p.sdr - (std::sqrt(1 + 0.3 * 0.3 + 0.7 * 0.7) - 1)) <= 200 * epsilon);
  }
}

TEST_CASE("Sdq and Sdr of rough heights are means over the sides and cells without a missing corner",
          "[missing][exact]") {
  for (const bool periodic : {false, true}) {
    const Grid g{{20, 31}, 0.7, 1.3, periodic};
    const Field z = with_holes(random_field(g.shape, 206), 0.15, 207);
    const auto slope2 = [](double a, double b) { return (a - b) * (a - b); };
    const double square = mean_over_pairs(z, periodic, 1, 0, slope2) / (0.7 * 0.7) +
                          mean_over_pairs(z, periodic, 0, 1, slope2) / (1.3 * 1.3);
    double excess = 0, cells = 0;
    auto at = [&](Index i, Index j) { return z(i % 20, j % 31); };
    for (Index i = 0; i < (periodic ? 20 : 19); ++i)
      for (Index j = 0; j < (periodic ? 31 : 30); ++j) {
        const double a = (at(i + 1, j) - at(i, j)) / 0.7, a2 = (at(i + 1, j + 1) - at(i, j + 1)) / 0.7;
        const double b = (at(i, j + 1) - at(i, j)) / 1.3, b2 = (at(i + 1, j + 1) - at(i + 1, j)) / 1.3;
        if (std::isnan(a + a2)) continue;
        const double am = (a + a2) / 2, bm = (b + b2) / 2;
        for (const auto& [u, v] : {std::pair{a, bm}, {a2, bm}, {am, b}, {am, b2}})
          excess += std::sqrt(1 + u * u + v * v) - 1;
        ++cells;
      }
    const SlopeParameters p = slope_parameters(z, g, 2);
    CHECK(relative_error(p.sdq, std::sqrt(square)) <= 100 * epsilon);
    CHECK(relative_error(p.sdr, excess / (4 * cells)) <= 100 * epsilon);
  }
}

// Second differences of x² are 2, whatever is missing around them.
TEST_CASE("spectral moments and summits count complete stencils only", "[missing][exact]") {
  const Grid g = grid(25, 24);
  const Field parabola =
      with_holes(sample(g, [](double x, double y) { return x * x + 0.5 * y * y + 2 * x * y; }), 0.1, 208);
  const SpectralMoments m = spectral_moments(parabola, g);
  CHECK(m.m40 == Approx(4).epsilon(1e-11));
  CHECK(m.m04 == Approx(1).epsilon(1e-11));
  CHECK(m.m22 == Approx(2).epsilon(1e-11));
  CHECK(m.m31 == Approx(4).epsilon(1e-11));

  const Field z = with_holes(random_field(g.shape, 209), 0.1, 210);
  double summits = 0, complete = 0;
  for (Index i = 1; i < 24; ++i)
    for (Index j = 1; j < 23; ++j) {
      const auto around = z.block<3, 3>(i - 1, j - 1);
      if (around.isNaN().any()) continue;
      ++complete;
      summits += (around < z(i, j)).count() == 8;
    }
  const CountedSummits counted = counted_summits(z, g);
  CHECK(counted.count == summits);
  CHECK(counted.density == Approx(summits / complete).epsilon(1e-14));
}

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
      const Field d = without_form(z);
      const double sum = zero_filled(d).square().sum(), bound = 12 * epsilon * sum;
      for (Index p = 0; p <= all.nx; ++p)
        for (Index q = -all.ny; q <= all.ny; ++q) {
          CAPTURE(periodic, shape.nx, p, q);
          double n = 0;
          for_each_pair(z, periodic, p, q, [&](double, double) { ++n; });
          CHECK(pairs.share(p, q) * pairs.points() == Approx(n).epsilon(1e-15).margin(0));
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
  CHECK_FALSE(lobe.slowest);
  CHECK(EffectiveSize::of_estimate(R, Pairs::of(z, g)).effective(2) > 0);
}

TEST_CASE("with holes the sums S_k are those over all pairs of points, over their number",
          "[missing][exact]") {
  const LagField rho = triangular_correlation({4, 3});
  for (const bool periodic : {false, true}) {
    const Grid g = grid(13, 12, periodic);
    const Field z = with_holes(random_field(g.shape, 215), 0.2, 216);
    const EffectiveSize size(rho, Pairs::of(z, g));
    double sum = 0;
    for (Index p = -3; p <= 3; ++p)
      for (Index q = -2; q <= 2; ++q)
        for_each_pair(z, periodic, p, q, [&](double, double) { sum += std::pow(rho(p, q), 2); });
    CHECK(relative_error(size.sum(2), sum / size.points()) <= 100 * epsilon);
  }
}

// 400 fields: a spread is known to 3.5 %, that of the skewed sums near lag zero to twice that; the weights of the
// mask are an upper bound, and the mask's holes a fifth of the field: 20 % as for a complete field.
TEST_CASE("over an ensemble with holes Bartlett's errors of the ACF and those of the moments hold",
          "[missing][statistics]") {
  const Shape window{4, 3};
  const Grid g = grid(48, 40);
  const LagField rho = triangular_correlation(window);
  const Field holes = with_holes(Field::Zero(48, 40), 0.1, 217);
  const Pairs pairs = Pairs::of(holes, g);
  const AcfError error(rho, pairs);
  const MomentErrors expected = standard_errors({.sq = 1}, EffectiveSize(rho, pairs));
  const DerivativeErrors slopes = derivative_errors(rho, DifferencePairs(pairs, holes));
  const std::pair<Index, Index> lags[] = {{0, 0}, {1, 0}, {0, 2}, {2, -1}, {5, 5}};
  Spread mean_height, sq, m20, m04, of_lag[5];
  for (unsigned seed = 0; seed < 400; ++seed) {
    const Field z = moving_average(g.shape, window, 5000 + seed) + holes;
    const Moments m = moments(z);
    mean_height.add(m.mean);
    sq.add(m.sq);
    const SpectralMoments derivatives = spectral_moments(z, g);
    m20.add(derivatives.m20);
    m04.add(derivatives.m04);
    const LagField acf = estimate_autocorrelation(z, pairs, {.max_lag = {6, 6}, .level = 0.0});
    for (std::size_t k = 0; k < 5; ++k) of_lag[k].add(acf(lags[k].first, lags[k].second));
  }
  CHECK(mean_height.deviation() == Approx(expected.mean).epsilon(0.1));
  CHECK(sq.deviation() == Approx(expected.sq).epsilon(0.15));
  CHECK(m20.deviation() / m20.mean() == Approx(slopes.m20).epsilon(0.15));
  CHECK(m04.deviation() / m04.mean() == Approx(slopes.m04).epsilon(0.15));
  for (std::size_t k = 0; k < 5; ++k) {
    const auto [p, q] = lags[k];
    CAPTURE(p, q);
    CHECK(std::abs(of_lag[k].mean() - rho(p, q)) <= 3.5 * error.absolute(p, q) / 20);
    CHECK(of_lag[k].deviation() == Approx(error.absolute(p, q)).epsilon(0.2));
  }
}

// The polynomial's values reach 4; the condition of the sums over what is there is below 1e3.
TEST_CASE("a polynomial with holes is taken away whole, and leaves the same of any heights on it",
          "[missing][law]") {
  const Grid g{{31, 26}, 0.06, 0.08, false};
  const auto polynomial = [](double x, double y) {
    return 1 + x - 2 * y + 0.5 * x * x - x * y + y * y * y - x * x * y;
  };
  const Field form = sample(g, polynomial), rough = with_holes(random_field(g.shape, 218), 0.2, 219);
  CHECK(zero_filled(without_form(with_holes(form, 0.2, 219), 3)).abs().maxCoeff() <= 1e4 * epsilon);
  for (int degree : {3, 5}) {
    const Field left = without_form(rough, degree), again = without_form(rough + form, degree);
    CHECK(zero_filled(left - again).abs().maxCoeff() <= 1e4 * epsilon);
    CHECK((left.isNaN() == rough.isNaN()).all());
  }
  // Normal equations: what is left is at right angles to every term, over the points that are there.
  const Field left = zero_filled(without_form(rough, 2));
  for (const auto& term :
       {plane(g, 0, 0, 1), plane(g, 1, 0), plane(g, 0, 1), Field(plane(g, 1, 0) * plane(g, 0, 1))})
    CHECK(std::abs((left * term).sum()) <= 1e4 * epsilon);
}

TEST_CASE("a form that the points that are there do not determine is refused as --level",
          "[missing][contract]") {
  Field z = Field::Constant(9, 9, none);
  z.row(3) = random_field({1, 9}, 220);
  CHECK_NOTHROW(without_form(z, 0));
  CHECK_THROWS_AS(without_form(z, 1), ParameterError);
}

TEST_CASE("the Gaussian filter leaves a constant with holes as it is, and is the direct weighted mean",
          "[missing][exact]") {
  for (const bool periodic : {false, true}) {
    const Grid g{{24, 20}, 1.0, 1.5, periodic};
    const Field flat = gaussian_mean_surface(with_holes(Field::Constant(24, 20, 3.0), 0.2, 221), g, 8);
    CHECK(zero_filled(flat - 3).abs().maxCoeff() <= 1e-14);
    const Field z = with_holes(random_field(g.shape, 222), 0.2, 223), smooth = gaussian_mean_surface(z, g, 8);
    if (periodic) continue;  // its weights repeat themselves
    for (Index i : {1, 7, 20})
      for (Index j : {2, 13, 19}) {
        double sum = 0, weights = 0;
        for (Index k = 0; k < 24; ++k)
          for (Index l = 0; l < 20; ++l) {
            if (std::isnan(z(k, l))) continue;
            const double r2 =
                std::pow(static_cast<double>(k - i), 2) + std::pow(1.5 * static_cast<double>(l - j), 2);
            const double w = std::exp(-std::pow(std::numbers::pi, 2) * r2 / (std::numbers::ln2 * 64));
            sum += w * z(k, l), weights += w;
          }
        CAPTURE(i, j);
        CHECK((std::isnan(z(i, j)) ? std::isnan(smooth(i, j))
                                   : std::abs(smooth(i, j) - sum / weights) <= 1e-13));
      }
  }
}

TEST_CASE("the PSD of a field with holes adds up to its Sq squared", "[missing][exact]") {
  const Grid g{{24, 30}, 0.5, 0.25, true};
  const Field d = without_form(with_holes(random_field(g.shape, 224), 0.2, 225));
  const LagField psd = power_spectrum(d, g, {Window::none, Window::none});
  double sum = 0;
  for_each_lag(psd, g, [&](Index p, Index q, double weight) { sum += weight * psd(p, q); });
  const double sq = moments(d).sq;
  CHECK(relative_error(sum / (g.size_x() * g.size_y()), sq * sq) <= 1e-13);
}

// 300 masks of a wave of amplitude √2, Sq = 1, whose C is N ΔxΔy/2 at ±q and nothing elsewhere. The floor is a mean
// over 300 × 700 wave numbers, of which half are independent: 4 standard errors are 1.2 %, the mean taken off 0.3 %.
TEST_CASE("holes here and there, a share g, lay a floor of g Sq^2 dx dy below the PSD",
          "[missing][statistics]") {
  const Grid g{{32, 24}, 0.5, 0.25, true};
  const Field wave = sine(g.shape, std::numbers::sqrt2, 4);
  for (double share : {0.1, 0.4}) {
    Spread peak, floor;
    for (unsigned seed = 0; seed < 300; ++seed) {
      const Field chance = random_field(g.shape, 7000 + seed);
      const Field d = (chance < 2 * share - 1).select(none, wave);
      const LagField psd = power_spectrum(d, g, {Window::none, Window::none});
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
  const Windows windows{Window::hann, Window::hann};
  const Field d = without_form(with_holes(white_noise(g.shape, 226), 0.1, 227));
  double squares = 0, rings = 0;
  const LagField psd = power_spectrum(d, g, windows);
  for (const SpectrumPoint& ring : radial_spectrum(psd, g, spectrum_inflation(d, windows))) {
    if (ring.count < 30) continue;
    squares += std::pow((ring.density - 1) / ring.standard_error, 2);
    ++rings;
  }
  CHECK(squares / rings == Approx(1).margin(1.0));
}

// One point more that is missing changes only what it enters: of a field without roughness beyond it nothing.
TEST_CASE("a field whose holes are at its edge has the statistics of what they leave", "[missing][law]") {
  const Field inner = random_field({20, 18}, 228);
  Field z = Field::Constant(26, 21, none);
  z.block(3, 2, 20, 18) = inner;
  const Grid g = grid(26, 21), h = grid(20, 18);
  CHECK(relative_error(moments(z).sku, moments(inner).sku) <= 200 * epsilon);
  CHECK(relative_error(slope_parameters(z, g).sdr, slope_parameters(inner, h).sdr) <= 200 * epsilon);
  CHECK(relative_error(spectral_moments(z, g).m22, spectral_moments(inner, h).m22) <= 1000 * epsilon);
  CHECK(counted_summits(z, g).density == Approx(counted_summits(inner, h).density).epsilon(1e-14));
  CHECK(zero_filled(without_form(z, 4)).abs().sum() ==
        Approx(without_form(inner, 4).abs().sum()).epsilon(1e-11));
  const LagField R = estimate_autocorrelation(z, g, {.max_lag = {9, 8}}),
                 alone = estimate_autocorrelation(inner, h, {.max_lag = {9, 8}});
  CHECK((R.half_plane() - alone.half_plane()).abs().maxCoeff() <= 12 * epsilon * inner.square().sum());
  const LagField S = structure_function(z, g, {9, 8}), S_alone = structure_function(inner, h, {9, 8});
  CHECK((S.half_plane() - S_alone.half_plane()).abs().maxCoeff() <= 40 * epsilon * inner.square().sum());
}
