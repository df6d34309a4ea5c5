#include <algorithm>
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

// Per area, on a spacing of 1, a ninth of independent heights are summits (Greenwood 1984). Of exp(-r²/l²) Nayak's
// density is √3/(3π l²), less 0.8/l² of it on the grid (stats/hybrid/summits.hpp), known to a tenth of that. The
// standard error is that of one surface; four of those of the 200 that are drawn. Sdq² is 2 (2 - ρ(1,0) - ρ(0,1)).
TEST_CASE("a ninth of independent heights are expected to be summits, and Nayak's density of smooth surfaces",
          "[prescription][slopes][statistics]") {
  const LagField white = LagField::of({2, 2}, [](Index p, Index q) { return p == 0 && q == 0 ? 1 : 0; });
  const double nayak = std::numbers::sqrt3 / (3 * std::numbers::pi * 64) * (1 - 0.8 / 64);
  for (const auto& [rho, density] : {std::pair{white, 1.0 / 9}, {gaussian_correlation(8), nayak}}) {
    const Grid g = grid(128, 128, true);
    SpecificationTest test({.correlation = rho, .sq = 1}, g);
    test.add(white_noise(g.shape, 1), g);
    const auto rows = test.results();
    const auto summits = std::ranges::find(rows, "summit_density", &TestResult::quantity);
    REQUIRE(summits != rows.end());
    CHECK(std::abs(summits->prescribed - density) <=
          4 * summits->standard_error / std::sqrt(200) + 1e-3 * density);
    CHECK((summits - 1)->prescribed == Approx(std::sqrt(4 * (1 - rho(1, 0)))).epsilon(1e-12));
  }
  const LagField grooves = LagField::of({2, 2}, [](Index p, Index) { return p == 0 ? 1.0 : 0.0; });
  SpecificationTest test({.correlation = grooves, .sq = 1}, grid(400, 4));
  test.add(white_noise({400, 4}, 1), grid(400, 4));
  const auto rows = test.results();
  CHECK(std::ranges::find(rows, "summit_density", &TestResult::quantity) == rows.end());
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
