// Errors of shares, densities and quantiles from the field's own long waves.
#include "stats/uncertainty/share_error.hpp"

#include <array>

#include <gsl/gsl_cdf.h>

#include "core/error.hpp"
#include "fields.hpp"
#include "stats/height/distribution.hpp"
#include "stats/height/height_error.hpp"
#include "stats/height/kernel_density.hpp"
#include "stats/measure/quantile_estimates.hpp"
#include "stats/sample/quantiles.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// The heights above a level, by their excess: a part of a correlated field, whose shares are known.
Field excess_of(const Field& z, double level) { return (z > level).select(z - level, NAN); }

}  // namespace

// Sums over classes and over points are the same sums in another order.
TEST_CASE("errors of shares are those of the means of their indicators", "[share-error][exact]") {
  const Grid g{{70, 50}, 1, 1, {true, false}};
  Field z = moving_average(g.shape, {4, 3}, 11);
  z.block(10, 5, 20, 9).setConstant(NAN);
  const FieldExtent extent{700, 1.3};
  const double slope = 0.3;
  ShareErrors of(g, extent, 4);
  auto class_of = [](double height) { return static_cast<Index>(std::clamp(height + 2, 0.0, 3.0)); };
  of.add(z, class_of);
  ShareErrors::Function f(of);
  f.add(1, 0.5), f.add(2, -2);
  LocalSums sums(g, 1);
  sums.add_rows(z.rows(), 1, [&](Index i, LocalSums::Values& values) {
    for (Index j = 0; j < z.cols(); ++j) {
      const double height = z(i, j);
      const double of_class = std::isnan(height)      ? NAN
                              : class_of(height) == 1 ? 0.5
                              : class_of(height) == 2 ? -2
                                                      : 0;
      values(j, 1) = of_class + slope * height;
    }
  });
  const LocalMeans means = sums.means(extent);
  CHECK(of.points() == sums.count());
  const auto [error, degrees] = means.error([](const Eigen::VectorXd& m) { return m(0); });
  CHECK(relative_error(f.error(slope).error, error) <= 1e-9);
  CHECK(relative_error(f.error(slope).degrees, degrees) <= 1e-9);
  CHECK(std::abs(f.error().error - error) > 0.01 * error);
  CHECK(f.mean() == Approx(0.5 * of.share(1) - 2 * of.share(2)).epsilon(1e-12));
  of.accumulate();
  CHECK(of.share(3) == 1);
  CHECK(of.share(1) == Approx(static_cast<double>((z < 0).count()) / of.points()).epsilon(1e-12));
}

namespace {

void set_intervals_of_twelve(std::vector<Frequency>& frequencies, double most) {
  for (Frequency& f : frequencies) f.degrees = 12;
  set_intervals(frequencies, most);
}

}  // namespace

// Each end is t errors of its own off the share, or at the bound.
TEST_CASE("the ends of a share's interval are t of their own errors away from it", "[share-error][exact]") {
  const double t = student_quantile(0.025, 12);
  std::vector<Frequency> shares{{0, 0, 0},          {2e-4, 5e-5, 4},   {0.01, 0.004, 200},
                                {0.8, 0.03, 16000}, {0.1, 0.02, 2000}, {0, 0, 0}};
  set_intervals_of_twelve(shares, 1);
  for (const Frequency& f : shares) {
    CAPTURE(f.value, f.error);
    CHECK(f.interval.low >= 0);
    CHECK(f.interval.low <= f.value);
    CHECK(f.interval.high >= f.value);
  }
  for (std::size_t k : {2, 3, 4}) {
    const Frequency& f = shares[k];
    const double independent = f.value * (1 - f.value) / (f.error * f.error);
    for (const double p : {f.interval.low, f.interval.high})
      CHECK(std::abs(std::pow(p - f.value, 2) - t * t * p * (1 - p) / independent) <= 1e-12 * f.value);
  }
  // Of four points and of none, n' is that of the next 200, on the other side of 2000.
  const double rare = 0.01 * 0.99 / (0.004 * 0.004), other = 0.1 * 0.9 / (0.02 * 0.02);
  CHECK(std::isnan(shares[1].error));  // of 0.1 independent heights
  CHECK(std::isnan(shares[0].error));
  CHECK(shares[2].error == Approx(0.004).epsilon(1e-12));
  CHECK(shares[0].interval.high == Approx(t * t / (rare + t * t)).epsilon(1e-12));
  CHECK(shares[5].interval.high == Approx(t * t / (other + t * t)).epsilon(1e-12));
  CHECK(shares[5].interval.low == 0);
  // Of 1.9 independent heights of 40, and of 2.1.
  std::vector<Frequency> few{{0.1, std::sqrt(0.1 * 0.9 / 19), 40}, {0.1, std::sqrt(0.1 * 0.9 / 21), 41}};
  set_intervals_of_twelve(few, 1);
  CHECK(std::isnan(few[0].error));
  CHECK(few[0].interval.known());
  CHECK(few[1].error == Approx(std::sqrt(0.1 * 0.9 / 21)).epsilon(1e-12));
  // What the mean adds at the ends is independent of the share.
  std::vector<Frequency> moved{{0.1, 0.01, 1000}, {0.1, 0.01, 900, {}, 0.04, 0.03}};
  set_intervals_of_twelve(moved, 1);
  CHECK(0.1 - moved[1].interval.low == Approx(std::hypot(0.1 - moved[0].interval.low, 0.04)).epsilon(1e-12));
  CHECK(moved[1].interval.high - 0.1 ==
        Approx(std::hypot(moved[0].interval.high - 0.1, 0.03)).epsilon(1e-12));
  std::vector<Frequency> densities{{40, 10, 100}};
  set_intervals_of_twelve(densities, std::numeric_limits<double>::infinity());
  for (const double p : {densities[0].interval.low, densities[0].interval.high})
    CHECK(std::pow(p - 40, 2) == Approx(t * t * p * 100 / 40).epsilon(1e-9));
  std::vector<Frequency> all{{1, 0, 500}};
  set_intervals_of_twelve(all, 1);
  CHECK((all[0].interval.low == 1 && all[0].interval.high == 1));
}

// Of n independent cells a share f has the error √(f (1 - f)/n), and the average over spectra an rms of 1.165 times
// that, as spectra may fall (long_waves.cpp). With some five degrees of freedom 60 fields know it to 1/√(2 · 5 · 60) =
// 4 %, of which three are allowed.
TEST_CASE("shares of independent cells have the binomial error", "[share-error][statistics]") {
  const std::vector<double> edges{0.2, 0.5, 1, 1.5};
  const Grid g = grid(160, 120);
  std::vector<Spread> square(edges.size());
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Field z = excess_of(white_noise(g.shape, seed), 0.3);
    const QuantileErrors errors(z, g, {1000, 160.0 / 120}, edges);
    const double n = static_cast<double>((!z.isNaN()).count());
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const double f = static_cast<double>((z <= edges[k]).count()) / n;
      square[k].add(std::pow(errors(k).error, 2) / (f * (1 - f) / n));
    }
  }
  for (const Spread& r : square) CHECK(std::abs(std::sqrt(r.mean()) - 1.165) <= 0.14);
}

// Of 300 fields the covering share is known to √(0.05 · 0.95/300) = 1.3 %, and three of these below 95 %; the ratio
// of the errors to the deviation to √(1/600), four of these beyond 0.8 and 1.3. N_eff is that of the field, N/S_2 with
// S_2 = Σ (1 - |p|/w)⁴ ≈ (2w/3)² for a window w.
TEST_CASE("95 % intervals of shares of a correlated part of a field cover the true share",
          "[share-error][statistics][slow]") {
  const double level = 0.5, edge = 0.7;
  const double above = gsl_cdf_ugaussian_Q(level), truth = 1 - gsl_cdf_ugaussian_Q(level + edge) / above;
  const Grid g = grid(96, 80);
  for (const Index window : {2, 5, 10}) {
    int covered = 0;
    const int fields = 300;
    Spread share, square;
    for (unsigned seed = 0; seed < fields; ++seed) {
      const Field z = excess_of(moving_average(g.shape, {window, window}, seed), level);
      const Sample sample({.grid = g, .heights = z, .variable = "pressure", .units = "Pa"});
      std::vector<Bin> bins = histogram(z, 2, HeightRange{0, 2 * edge});
      set_errors(bins, z, g, sample.extent());
      // The second bin holds all above the edge.
      covered += bins[0].share.interval.low <= truth && truth <= bins[0].share.interval.high;
      share.add(bins[0].share.value), square.add(bins[0].share.error * bins[0].share.error);
    }
    const double ratio = std::sqrt(square.mean()) / share.deviation(), chance = 4 * std::sqrt(0.5 / fields);
    CAPTURE(window, covered, ratio);
    CHECK(covered >= 0.91 * fields);
    CHECK((ratio >= 0.8 - chance && ratio <= 1.3 + chance));
  }
}

// Two populations of steep flanks, z = 0.4 y + tanh 4y: the mean of a field strays over a flank, whose slope
// changes there. Of 300 fields the covering share is known to 1.3 %; with one slope over ± 2e alone it is 86 %.
TEST_CASE("shares beside a flank of the distribution hold as the mean strays over it",
          "[share-error][statistics]") {
  const Grid g = grid(96, 80);
  constexpr int fields = 300;
  auto height = [](double y) { return 0.4 * y + std::tanh(4 * y); };
  auto below = [&](double z) {
    double low = -6, high = 6;
    for (int k = 0; k < 60; ++k) (height((low + high) / 2) < z ? low : high) = (low + high) / 2;
    return gsl_cdf_ugaussian_P(low);
  };
  std::array<int, 2> covered{};
  for (unsigned seed = 0; seed < fields; ++seed) {
    Field z = moving_average(g.shape, {7, 6}, seed).unaryExpr(height);
    z -= mean(z);
    std::vector<Bin> bins = histogram(z, 40, HeightRange{-10, 10});
    set_errors(bins, z, g, {350, 0.97}, std::sqrt(z.square().mean()));
    for (std::size_t k : {0, 1}) {
      const Bin& bin = bins[22 + k];
      const double truth = below(bin.upper) - below(bin.lower);
      covered[k] += bin.share.interval.low <= truth && truth <= bin.share.interval.high;
    }
  }
  for (const int count : covered) {
    CAPTURE(count);
    CHECK(count >= 0.91 * fields);
  }
}
