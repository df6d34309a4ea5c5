// Missing points are left out: every statistic of a field with holes beside a sum over what is there.
#include "stats/filter/missing.hpp"

#include <algorithm>
#include <vector>

#include "core/error.hpp"
#include "holes.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/gaussian_filter.hpp"
#include "stats/height/distribution.hpp"
#include "stats/height/material_ratio.hpp"
#include "stats/hybrid/slopes.hpp"
#include "stats/hybrid/spectral_moments.hpp"
#include "stats/hybrid/summits.hpp"
#include "stats/sample/moments.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

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

Field tilted_plane(const Grid& g, double a, double b, double c = 0) {
  return sample(g, [=](double x, double y) { return c + a * x + b * y; });
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
  const EffectiveSampleSize size(triangular_correlation({1, 1}), Pairs::of(z, grid(30, 31)));
  CHECK(size.points() == static_cast<double>(heights.size()));
  const std::vector<Bin> bins = histogram(z, 7), expected = histogram(there, 7);
  for (std::size_t b = 0; b < 7; ++b) CHECK(bins[b].count == expected[b].count);
}

TEST_CASE("a tilted plane with holes has the slope and the area of the plane", "[missing][exact]") {
  for (const bool single : {false, true}) {
    const Grid g{{17, 23}, 0.5, 0.25, false};
    const Field z =
        single ? Field(tilted_plane(g, 0.3, 0.7)) : with_holes(tilted_plane(g, 0.3, 0.7), 0.2, 205);
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

// The polynomial's values reach 4; the condition of the sums over what is there is below 1e3.
TEST_CASE("a polynomial with holes is taken away whole, and leaves the same of any heights on it",
          "[missing][law]") {
  const Grid g{{31, 26}, 0.06, 0.08, false};
  const auto polynomial = [](double x, double y) {
    return 1 + x - 2 * y + 0.5 * x * x - x * y + y * y * y - x * x * y;
  };
  const Field form = sample(g, polynomial), rough = with_holes(random_field(g.shape, 218), 0.2, 219);
  CHECK(zero_filled(remove_form(with_holes(form, 0.2, 219), 3)).abs().maxCoeff() <= 1e4 * epsilon);
  for (int degree : {3, 5}) {
    const Field left = remove_form(rough, degree), again = remove_form(rough + form, degree);
    CHECK(zero_filled(left - again).abs().maxCoeff() <= 1e4 * epsilon);
    CHECK((left.isNaN() == rough.isNaN()).all());
  }
  // Normal equations: what is left is at right angles to every term, over the points that are there.
  const Field left = zero_filled(remove_form(rough, 2));
  for (const auto& term : {tilted_plane(g, 0, 0, 1), tilted_plane(g, 1, 0), tilted_plane(g, 0, 1),
                           Field(tilted_plane(g, 1, 0) * tilted_plane(g, 0, 1))})
    CHECK(std::abs((left * term).sum()) <= 1e4 * epsilon);
}

TEST_CASE("a form that the points that are there do not determine is refused as --remove-form",
          "[missing][contract]") {
  Field z = Field::Constant(9, 9, none);
  z.row(3) = random_field({1, 9}, 220);
  CHECK_NOTHROW(remove_form(z, 0));
  CHECK_THROWS_AS(remove_form(z, 1), ParameterError);
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
