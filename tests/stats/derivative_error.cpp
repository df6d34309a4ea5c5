#include "stats/hybrid/derivative_error.hpp"

#include "core/error.hpp"
#include "fields.hpp"
#include "stats/hybrid/slopes.hpp"
#include "stats/hybrid/spectral_moments.hpp"
#include "stats/spatial/acf.hpp"
#include "whole.hpp"

using namespace asperity;
using namespace asperity::test;

// First differences of white noise: R' = 2, -1, so S_2 = 1 + 2/4. Second ones: 6, -4, 1, so S_2 = 1 + 2(16 +
// 1)/36. D = 1 at the four lags around the middle of a cell: Var[Sdq²] = 2/N [2 (4 + 2) + 2 · 4], and Sdq² =
// 4.
TEST_CASE("white noise has S_2 = 3/2 for slopes and 35/18 for second differences",
          "[derivative-error][exact]") {
  const Grid g = grid(50, 40, true);
  const DerivativeErrors e = derivative_errors(triangular_correlation({1, 1}), g);
  CHECK(relative_error(e.m20, std::sqrt(2 * 1.5 / 2000)) <= 1e-13);
  CHECK(relative_error(e.m02, std::sqrt(2 * 1.5 / 2000)) <= 1e-13);
  CHECK(relative_error(e.m40, std::sqrt(2 * 35.0 / 18 / 2000)) <= 1e-13);
  CHECK(relative_error(e.m04, std::sqrt(2 * 35.0 / 18 / 2000)) <= 1e-13);
  CHECK(relative_error(e.square_slope, std::sqrt(2 * 20.0 / 2000) / 4) <= 1e-13);
}

// 1000 fields: a spread of a spread is 2.2 %; four of them, and 3 % for the points that edges have less of.
TEST_CASE("errors of slopes and second derivatives are their spread over an ensemble",
          "[derivative-error][statistics]") {
  const Shape window{3, 5};
  const Grid g{{64, 48}, 1.0, 0.5, false};
  const DerivativeErrors e = derivative_errors(triangular_correlation(window), g);
  Spread m20, m02, m40, m04, slope, area;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    const Field z = 1e-3 * moving_average(g.shape, window, seed);
    const SpectralMoments m = spectral_moments(z, g);
    const SlopeParameters s = slope_parameters(z, g);
    m20.add(m.m20), m02.add(m.m02), m40.add(m.m40), m04.add(m.m04), slope.add(s.sdq * s.sdq), area.add(s.sdr);
  }
  CHECK(m20.deviation() / m20.mean() == Approx(e.m20).epsilon(0.12));
  CHECK(m02.deviation() / m02.mean() == Approx(e.m02).epsilon(0.12));
  CHECK(m40.deviation() / m40.mean() == Approx(e.m40).epsilon(0.12));
  CHECK(m04.deviation() / m04.mean() == Approx(e.m04).epsilon(0.12));
  CHECK(slope.deviation() / slope.mean() == Approx(e.square_slope).epsilon(0.12));
  // Of four triangles rather than sides: the same but for what neighbouring sides average out.
  CHECK(area.deviation() / area.mean() == Approx(e.square_slope).epsilon(0.25));
}

TEST_CASE("errors from the estimated ACF are on average those from the known one",
          "[derivative-error][statistics]") {
  const Shape window{5, 4};
  const Grid g = grid(96, 80);
  const DerivativeErrors known = derivative_errors(triangular_correlation(window), g);
  Spread m20, m04, slope;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const LagField acf =
        estimate_autocorrelation(moving_average(g.shape, window, seed), g, {.max_lag = default_max_lag(g)});
    const DerivativeErrors e = derivative_errors(acf, g, true);
    m20.add(e.m20 / known.m20), m04.add(e.m04 / known.m04), slope.add(e.square_slope / known.square_slope);
  }
  CHECK(m20.mean() == Approx(1).margin(0.1));
  CHECK(m04.mean() == Approx(1).margin(0.1));
  CHECK(slope.mean() == Approx(1).margin(0.1));
  CHECK_THROWS_AS(derivative_errors(LagField(Field::Ones(1, 1)), g, true), DataError);
}
