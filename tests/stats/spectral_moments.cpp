#include "stats/hybrid/spectral_moments.hpp"

#include "core/error.hpp"
#include "fields.hpp"
#include "stats/spatial/acf.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// cos(k·x) with whole numbers of waves on a periodic grid.
struct Wave {
  Grid grid;
  double qx, qy;

  Wave(const Grid& g, int kx, int ky)
      : grid(g), qx(2 * std::numbers::pi * kx / g.size_x()), qy(2 * std::numbers::pi * ky / g.size_y()) {}
  Field field() const {
    return sample(grid, [&](double x, double y) { return std::cos(qx * x + qy * y + 0.7); });
  }
};

double sinc(double t) { return t == 0 ? 1 : std::sin(t) / t; }

}  // namespace

// A wave of amplitude 1 has the mean square 1/2. Second differences of heights known to ε are known to 4ε/Δ².
TEST_CASE("of a wave each spectral moment is the exact one times the factor of its differences",
          "[spectral-moments][exact]") {
  const Grid g{{24, 30}, 0.5, 0.4, true};
  for (const auto& [kx, ky] : {std::pair{1, 0}, {0, 2}, {3, 2}, {2, -5}}) {
    const Wave wave(g, kx, ky);
    const double u = wave.qx * g.dx / 2, v = wave.qy * g.dy / 2, x = wave.qx * sinc(u), y = wave.qy * sinc(v);
    const double mixed = std::cos(u) * std::cos(v);
    const SpectralMoments m = spectral_moments(wave.field(), g);
    const double bound = 1000 * epsilon;
    CAPTURE(kx, ky);
    CHECK(std::abs(m.m00 - 0.5) <= bound);
    CHECK(std::abs(m.m20 - 0.5 * x * x) <= bound);
    CHECK(std::abs(m.m11 - 0.5 * x * y * mixed) <= bound);
    CHECK(std::abs(m.m02 - 0.5 * y * y) <= bound);
    CHECK(std::abs(m.m40 - 0.5 * x * x * x * x) <= 10 * bound);
    CHECK(std::abs(m.m31 - 0.5 * x * x * x * y * mixed) <= 10 * bound);
    CHECK(std::abs(m.m22 - 0.5 * x * x * y * y) <= 10 * bound);
    CHECK(std::abs(m.m13 - 0.5 * x * y * y * y * mixed) <= 10 * bound);
    CHECK(std::abs(m.m04 - 0.5 * y * y * y * y) <= 10 * bound);
  }
}

// Of a wave q at the angle φ, m2(θ) = q² cos²(θ-φ)/2 and m4 = q⁴ cos⁴(θ-φ)/2; the factors are 1 - O(h²),
// whose constants are at most qh²(1/12 + 1/8 + 1/8) in m2 and twice that in m4, of either direction.
TEST_CASE("the moments of a profile in any direction are those of the wave seen along it, at order 2",
          "[spectral-moments][order]") {
  for (Index n : {32, 64, 128, 256}) {
    const Grid g{{n, n}, 1 / static_cast<double>(n), 1 / static_cast<double>(n), true};
    const Wave wave(g, 2, 3);
    const double q = std::hypot(wave.qx, wave.qy), phi = std::atan2(wave.qy, wave.qx),
                 h2 = std::pow(q * g.dx, 2);
    const SpectralMoments m = spectral_moments(wave.field(), g);
    for (double theta = -1.5; theta < 1.6; theta += 0.3) {
      const double c = std::cos(theta - phi);
      CAPTURE(n, theta);
      CHECK(std::abs(m.along(theta).m2 / (q * q / 2) - c * c) <= h2 / 3);
      CHECK(std::abs(m.along(theta).m4 / (q * q * q * q / 2) - c * c * c * c) <= 2 * h2 / 3);
    }
    CHECK(m.along(phi).bandwidth() == Approx(1).epsilon(h2));
  }
}

// The ACF adds ε log2(N) of R(0,0) to each of up to 16 terms.
TEST_CASE("on a periodic surface the moments are differences of the autocorrelation",
          "[spectral-moments][law]") {
  const Field z = random_field({30, 26}, 71);
  const Grid g{{30, 26}, 1.0, 1.0, true};
  const LagField R = estimate_autocorrelation(z, g, {.max_lag = {3, 3}});
  const SpectralMoments m = spectral_moments(z, g);
  const double bound = 200 * epsilon;
  CHECK(std::abs(m.m00 - R(0, 0)) <= bound);
  CHECK(std::abs(m.m20 - 2 * (R(0, 0) - R(1, 0))) <= bound);
  CHECK(std::abs(m.m02 - 2 * (R(0, 0) - R(0, 1))) <= bound);
  CHECK(std::abs(m.m11 - (R(1, -1) - R(1, 1)) / 2) <= bound);
  CHECK(std::abs(m.m40 - (6 * R(0, 0) - 8 * R(1, 0) + 2 * R(2, 0))) <= bound);
  CHECK(std::abs(m.m04 - (6 * R(0, 0) - 8 * R(0, 1) + 2 * R(0, 2))) <= bound);
  CHECK(std::abs(m.m22 - (4 * R(0, 0) - 4 * R(1, 0) - 4 * R(0, 1) + 2 * R(1, 1) + 2 * R(1, -1))) <= bound);
  CHECK(std::abs(m.m31 - (R(2, 1) - R(2, -1) - 2 * R(1, 1) + 2 * R(1, -1)) / 2) <= bound);
  CHECK(std::abs(m.m13 - (R(1, 2) - R(1, -2) - 2 * R(1, 1) + 2 * R(1, -1)) / 2) <= bound);
}

TEST_CASE("on a field with edges each mean is over the points that have the neighbours",
          "[spectral-moments][exact]") {
  const Field z = random_field({12, 9}, 72);
  const Grid g{{12, 9}, 0.5, 2.0, false};
  const SpectralMoments m = spectral_moments(z, g);
  const Field zx = (z.bottomRows(11) - z.topRows(11)) / 0.5, zy = (z.rightCols(8) - z.leftCols(8)) / 2.0;
  const Field zxx = (z.topRows(10) - 2 * z.middleRows(1, 10) + z.bottomRows(10)) / 0.25;
  const Field zyy = (z.leftCols(7) - 2 * z.middleCols(1, 7) + z.rightCols(7)) / 4.0;
  CHECK(relative_error(m.m20, zx.square().mean()) <= 100 * epsilon);
  CHECK(relative_error(m.m02, zy.square().mean()) <= 100 * epsilon);
  CHECK(relative_error(m.m40, zxx.square().mean()) <= 100 * epsilon);
  CHECK(relative_error(m.m04, zyy.square().mean()) <= 100 * epsilon);
  CHECK(std::abs(m.m22 - (zxx.middleCols(1, 7) * zyy.middleRows(1, 10)).mean()) <= 1000 * epsilon);
  CHECK(std::abs(m.m11 -
                 0.25 * ((zx.leftCols(8) + zx.rightCols(8)) * (zy.topRows(11) + zy.bottomRows(11))).mean()) <=
        1000 * epsilon);
  CHECK(spectral_moments(z, g, 3).m31 == m.m31);
  CHECK_THROWS_AS(spectral_moments(random_field({2, 9}, 1), grid(2, 9)), DataError);
}

// α of the Gaussian correlation exp(-r²/l²): m2 = 2/l², m4 = 12/l⁴. m2 is low by m4/(12 m2) = 1/(2l²) and m4
// by m6/(6 m4) = 120/(72 l²): α by 2/(3l²) in all, 1 % for l = 8. The relative standard errors of m2 and m4
// over 8 fields with 256²/(π l²) = 326 patches each: some √(2 · 2/2600) = 4 %; four of them.
TEST_CASE(
    "a Gaussian field with a Gaussian autocorrelation of length l has m2 = 2/l^2, m4 = 12/l^4, bandwidth 3",
    "[spectral-moments][statistics]") {
  const double l = 8;
  const Grid g = grid(256, 256, true);
  Spread m2, m4, alpha;
  for (unsigned seed = 0; seed < 8; ++seed) {
    const SpectralMoments m = spectral_moments(gaussian_acf_field(g.shape, l, seed), g);
    for (double angle : {0.0, 0.5, 1.5708}) {
      m2.add(m.along(angle).m2 * l * l / 2);
      m4.add(m.along(angle).m4 * l * l * l * l / 12);
      alpha.add(m.along(angle).bandwidth() / 3);
    }
  }
  CHECK(m2.mean() == Approx(1 - 0.5 / (l * l)).epsilon(0.16));
  CHECK(m4.mean() == Approx(1 - 5 / (3 * l * l)).epsilon(0.16));
  CHECK(alpha.mean() == Approx(1 - 2 / (3 * l * l)).epsilon(0.16));
}
