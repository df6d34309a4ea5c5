#include "stats/hypothesis/prescribed_slopes.hpp"

#include <numbers>
#include <string>

#include "fields.hpp"
#include "holes.hpp"
#include "stats/hypothesis/specification.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

LagField gaussian_correlation(double length, Index lags = 32) {
  return LagField::of({lags, lags}, [&](Index p, Index q) {
    return std::exp(-static_cast<double>(p * p + q * q) / (length * length));
  });
}

}  // namespace

// A ninth of independent heights are summits (Greenwood 1984). Of exp(-r²/l²) Nayak's density is √3/(3π l²),
// less 0.8/l² of it on the grid (stats/hybrid/summits.hpp), known to a tenth of that: 0.1 % at l = 8. Four
// errors of the lattice.
TEST_CASE("the share of summits is a ninth of independent heights, and Nayak's density of smooth surfaces",
          "[prescription][slopes][exact]") {
  const LagField white = LagField::of({2, 2}, [](Index p, Index q) { return p == 0 && q == 0 ? 1 : 0; });
  const SummitShare ninth = summit_share(white), smooth = summit_share(gaussian_correlation(8));
  CHECK(ninth.error <= 2e-3 / 9);
  CHECK(std::abs(ninth.value - 1.0 / 9) <= 4 * ninth.error);
  const double nayak = std::numbers::sqrt3 / (3 * std::numbers::pi * 64);
  CHECK(std::abs(smooth.value - nayak * (1 - 0.8 / 64)) <= 4 * smooth.error + 0.001 * nayak);
  const LagField grooves = LagField::of({2, 2}, [](Index p, Index) { return p == 0 ? 1.0 : 0.0; });
  CHECK(summit_share(grooves).value == 0);
}

// 300 fields: a mean to four of its errors, a spread to four of its own, 1/√598; √φ to 1/√398 besides, and the
// number of sides and neighbourhoods to 5 %. The correlation at one step is 1 - 1/window.
TEST_CASE("mean and spread of Sdq and of the density of summits are those expected",
          "[prescription][slopes][statistics]") {
  for (const Shape window : {Shape{3, 3}, Shape{7, 5}}) {
    const Grid g{{72, 64}, 1, 1.5, false};
    const LagField rho = triangular_correlation(window);
    PrescribedSlopes expected(rho, g);
    expected.set_summits(rho, g);
    expected.draw_summits(rho, g, 1, 1);
    Eigen::ArrayXd squares(300), shares(300);
    GridSlopes one;
    for (unsigned m = 0; m < 300; ++m) {
      one = grid_slopes(moving_average(g.shape, window, m), g);
      squares(m) = one.square, shares(m) = one.share;
    }
    CAPTURE(window.nx, expected.dispersion, one.points, one.cells);
    CHECK(expected.square ==
          Approx(2 / static_cast<double>(window.nx) + 2 / (2.25 * static_cast<double>(window.ny)))
              .epsilon(1e-12));
    auto as_expected = [](const Eigen::ArrayXd& values, double mean, double error, double spread,
                          double margin) {
      const double found = std::sqrt((values - values.mean()).square().sum() / 299);
      CHECK(std::abs(values.mean() - mean) <= 4 * std::hypot(found / std::sqrt(300.0), error));
      CHECK(std::abs(found / spread - 1) <= margin);
    };
    const double share = expected.summits.value;
    as_expected(squares, expected.square, 0, std::sqrt(expected.variance / one.cells),
                4 / std::sqrt(598.0) + 0.05);
    as_expected(shares, share, expected.summits.error, std::sqrt(expected.dispersion * share / one.points),
                4 * std::sqrt(1 / 598.0 + 1 / 398.0) + 0.05);
  }
}

// The fault of a biased estimate of the ACF, a triangle times ρ: 3e-3 of the variance is new at each step. That
// is a fifth of the mean square difference, 1/16, and makes three times the summits.
TEST_CASE("a cusp at lag zero is seen in the summits, and not in heights, ACF and lengths",
          "[prescription][slopes][statistics]") {
  const Grid g = grid(128, 128, true);
  const SpecificationTest fresh({.correlation = gaussian_correlation(8), .sq = 1}, g);
  for (unsigned seed = 0; seed < 5; ++seed) {
    SpecificationTest test = fresh;
    test.add(std::sqrt(0.997) * gaussian_acf_field(g.shape, 8, seed) +
                 std::sqrt(0.003) * white_noise(g.shape, 100 + seed),
             g);
    for (const TestResult& row : test.results()) {
      CAPTURE(seed, row.quantity, row.z);
      if (row.quantity == "summit_density") CHECK((row.p <= 1e-6 && row.mean > 2 * row.prescribed));
      if (row.quantity != "Sdq" && row.quantity != "summit_density") CHECK(row.p > 0.01 / 7);
    }
  }
}

TEST_CASE(
    "without the lags that slopes rest on, or without a cell or a neighbourhood, these rows are left out",
    "[prescription][slopes][contract]") {
  auto slopes_of = [](Shape window, const Field& z) {
    const Grid g = grid(z.rows(), z.cols());
    SpecificationTest test({.correlation = triangular_correlation(window), .sq = 1}, g);
    test.add(z, g);
    std::string out;
    for (const TestResult& row : test.results())
      if (row.quantity == "Sdq" || row.quantity == "summit_density") out += row.quantity + " ";
    return out;
  };
  const Field z = moving_average({48, 48}, {3, 3}, 3);
  CHECK(slopes_of({3, 3}, z) == "Sdq summit_density ");
  CHECK(slopes_of({2, 2}, z) == "Sdq ");
  CHECK(slopes_of({1, 1}, white_noise({48, 48}, 1)).empty());
  CHECK(slopes_of({3, 1}, moving_average({400, 1}, {3, 1}, 3)).empty());
  Field strips = z, chequered = z;
  for (Index i = 0; i < 48; ++i) {
    if (i % 3 == 2) strips.row(i).setConstant(none);
    for (Index j = i % 2; j < 48; j += 2) chequered(i, j) = none;
  }
  CHECK(slopes_of({3, 3}, strips) == "Sdq ");
  CHECK(slopes_of({3, 3}, chequered).empty());
}
