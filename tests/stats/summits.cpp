#include "stats/hybrid/summits.hpp"

#include <array>
#include <map>

#include "core/error.hpp"
#include "fields.hpp"
#include "stats/hybrid/spectral_moments.hpp"
#include "stats/spatial/acf.hpp"

using namespace asperity;
using namespace asperity::test;

// cos(2πk i/n) cos(2πl j/m), with crests on points and of both signs: 2kl summits of height 1.
TEST_CASE("an egg crate of k x l periods has 2 k l summits of height 1 and the curvature of its differences",
          "[summits][exact]") {
  const Grid g{{48, 60}, 0.5, 0.2, true};
  const int k = 3, l = 5;
  const double u = 2 * std::numbers::pi * k / 48, v = 2 * std::numbers::pi * l / 60;
  const Field z = Field::NullaryExpr(48, 60, [&](Index i, Index j) {
    return std::cos(u * static_cast<double>(i)) * std::cos(v * static_cast<double>(j));
  });
  const CountedSummits summits = counted_summits(z, g);
  const double curvature = (1 - std::cos(u)) / 0.25 + (1 - std::cos(v)) / 0.04;
  CHECK(summits.count == 2 * k * l);
  CHECK(relative_error(summits.density, 2 * k * l / (24.0 * 12.0)) <= 4 * epsilon);
  CHECK(relative_error(summits.mean_height, 1) <= 100 * epsilon);
  CHECK(summits.height_deviation <= 1e-7);  // √(100 ε)
  CHECK(relative_error(summits.mean_curvature, curvature) <= 1000 * epsilon);
  CHECK(counted_summits(z, g, 0, 3).mean_curvature == summits.mean_curvature);

  const Grid open{g.shape, g.dx, g.dy, false};
  CHECK(counted_summits(z, open).count < summits.count);  // a row and a column of crests lie on the edge
  CHECK(counted_summits(sine({20, 20}, 1, 2), grid(20, 20)).count == 0);  // ridges are not summits
  CHECK_THROWS_AS(counted_summits(random_field({2, 9}, 1), grid(2, 9)), DataError);
}

namespace {

// Floods the plateau of a point on the plane of all periods, and counts it at its first point.
class Flood {
 public:
  Flood(const Field& z, bool periodic) : z_(z), periodic_(periodic) {}

  bool summit(Index i, Index j) {
    places_.clear();
    bool lower = false;
    std::vector<std::array<Index, 2>> open{{i, j}};
    places_[{i, j}] = {i, j};
    while (!open.empty()) {
      const auto [x, y] = open.back();
      open.pop_back();
      for (Index k = 0; k < 9; ++k) {
        const std::array<Index, 2> beside{x + k / 3 - 1, y + k % 3 - 1}, at = folded(beside);
        if (k == 4) continue;
        if (!periodic_ && at != beside) return false;
        const double other = z_(at[0], at[1]), own = z_(i, j);
        if (std::isnan(own) || !(other <= own)) return false;
        lower |= other < own;
        if (other < own) continue;
        const auto [place, fresh] = places_.try_emplace(at, beside);
        if (!fresh && place->second != beside) return false;  // a ridge meets itself
        if (fresh) open.push_back(beside);
      }
    }
    return lower && places_.begin()->first == std::array<Index, 2>{i, j};
  }

 private:
  std::array<Index, 2> folded(const std::array<Index, 2>& p) const {
    const Index nx = z_.rows(), ny = z_.cols();
    return {(p[0] % nx + nx) % nx, (p[1] % ny + ny) % ny};
  }
  const Field& z_;
  bool periodic_;
  std::map<std::array<Index, 2>, std::array<Index, 2>> places_ = {};
};

// In steps, some points missing, along one axis constant now and then.
Field stepped_field(Shape shape, unsigned seed) {
  std::mt19937_64 generator(seed);
  Field z =
      moving_average(shape, {1 + static_cast<Index>(seed % 3), 1 + static_cast<Index>(seed / 3 % 3)}, seed);
  z = (z * (1 + seed % 4)).round();
  if (seed % 5 == 0) z = z.col(0).replicate(1, shape.ny).eval();
  if (seed % 4 == 0)
    for (Index k = 0; k < z.size(); ++k)
      if (generator() % 12 == 0) z(k) = NAN;
  return z;
}

}  // namespace

TEST_CASE("summits of heights in steps are the plateaus above all around them", "[summits][exact]") {
  for (unsigned seed = 0; seed < 240; ++seed) {
    const Shape shape{1 + static_cast<Index>(seed * 7 % 19), 1 + static_cast<Index>(seed * 11 % 17)};
    const bool periodic = seed % 2 == 0;
    const Grid g{shape, 0.5, 0.7, periodic};
    if (!periodic && std::min(shape.nx, shape.ny) < 3) continue;
    const Field z = stepped_field(shape, seed);
    double expected = 0;
    Flood flood(z, periodic);
    for (Index i = 0; i < shape.nx; ++i)
      for (Index j = 0; j < shape.ny; ++j) expected += flood.summit(i, j);
    CAPTURE(seed, shape.nx, shape.ny, periodic);
    try {
      const double counted = counted_summits(z, g).count;
      CHECK(counted == expected);
    } catch (const DataError&) {  // no point has all its neighbours
      CHECK(expected == 0);
    }
  }
}

// The same 764 summits with and without steps: of three fields the ratios of the numbers varied by 0.5 %, of
// the curvatures by 2 %, three times of which is the margin. Means of second differences alone have 1.29 and
// 1.65 times the curvature.
TEST_CASE("steps of 0.05 and 0.1 Sq at l = 8 points leave 92 and 87 % of the summits, and their curvature",
          "[summits][statistics]") {
  const Field z = gaussian_acf_field({512, 512}, 8, 1);
  const Grid g = grid(512, 512, true);
  const CountedSummits exact = counted_summits(z, g);
  for (const auto& [step, count, curvature] : {std::array{0.05, 0.92, 1.02}, std::array{0.1, 0.87, 1.12}}) {
    const CountedSummits s = counted_summits((z / step).round() * step, g);
    CHECK(s.count / exact.count == Approx(count).margin(0.02));
    CHECK(s.mean_curvature / exact.mean_curvature == Approx(curvature).margin(0.06));
  }
}

// One of nine equals is the highest; its height is the mean of the largest of nine normal numbers. 1e6
// points: the count of 1.1e5 has a spread below that of independent trials, 0.3 %, the mean height 0.6/√1.1e5
// = 0.2 %. Four.
TEST_CASE("of independent heights a ninth are summits, of mean height 1.485", "[summits][statistics]") {
  const Grid g{{1000, 1000}, 2e-6, 1e-6, true};
  const CountedSummits summits = counted_summits(white_noise(g.shape, 81), g);
  CHECK(summits.density * g.cell_area() == Approx(1.0 / 9).epsilon(0.012));
  CHECK(summits.mean_height == Approx(1.48501316).epsilon(0.008));
}

// Every second and every fourth point of the same surface: the loss is a difference of counts whose own
// chance is a tenth of them, some 0.4 % of 1500 summits; four of that. The first count's standard error is 2
// %, and its bias 0.3 %.
TEST_CASE("the summits of a Gaussian surface are as many as Nayak's, fewer by 0.8 (h/l)^2 on coarser grids",
          "[summits][order]") {
  const double l = 16;
  std::array<Spread, 3> density, curvature;
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Field z = gaussian_acf_field({512, 512}, l, seed);
    for (std::size_t level = 0; level < 3; ++level) {
      const Index step = Index{1} << level;
      const Field every = z(Eigen::seq(0, 511, step), Eigen::seq(0, 511, step));
      const double h = static_cast<double>(step);
      const CountedSummits s = counted_summits(every, {shape_of(every), h, h, true});
      const Summits exact = expected_summits({.m0 = 1, .m2 = 2 / (l * l), .m4 = 12 / (l * l * l * l)});
      density[level].add(s.density / exact.density);
      curvature[level].add(s.mean_curvature / exact.mean_curvature);
    }
  }
  CHECK(density[0].mean() == Approx(1).margin(0.08));
  CHECK(curvature[0].mean() == Approx(1).margin(0.08));
  for (std::size_t level : {1u, 2u}) {
    const double squares = (std::pow(4.0, static_cast<double>(level)) - 1) / (l * l);
    CHECK(1 - density[level].mean() / density[0].mean() == Approx(0.8 * squares).margin(0.016));
    CHECK(1 - curvature[level].mean() / curvature[0].mean() == Approx(squares).margin(0.016));
  }
}

// Nayak's integrals over t = κ/√(2 m4/3) with the density (t² - 1 + e^{-t²}) e^{-t²/2}, by the midpoint rule,
// and the regression z = m2 κ/(2 m4/3) + remainder of variance m0 (1 - 3/(2α)).
TEST_CASE("expected summits are the moments of Nayak's density", "[summits][exact]") {
  double norm = 0, first = 0, second = 0;
  const double step = 1e-3;
  for (double t = step / 2; t < 12; t += step) {
    const double weight = (t * t - 1 + std::exp(-t * t)) * std::exp(-t * t / 2) * step;
    norm += weight, first += weight * t, second += weight * t * t;
  }
  for (double alpha : {1.5, 3.0, 20.0}) {
    const ProfileSpectralMoments m{.m0 = 0.16, .m2 = 0.02, .m4 = alpha * 0.02 * 0.02 / 0.16};
    const double unit = std::sqrt(2 * m.m4 / 3), mean = unit * first / norm;
    const double deviation = second / norm - std::pow(first / norm, 2), slope = m.m2 / unit;
    const Summits s = expected_summits(m);
    CHECK(relative_error(s.mean_curvature, mean) <= 1e-6);
    CHECK(relative_error(s.radius(), 0.375 * std::sqrt(std::numbers::pi / m.m4)) <= 10 * epsilon);
    CHECK(relative_error(s.mean_height, slope * first / norm) <= 1e-6);
    CHECK(relative_error(std::pow(s.height_deviation, 2),
                         m.m0 * (1 - 1.5 / alpha) + slope * slope * deviation) <= 1e-6);
    CHECK(relative_error(s.density, m.m4 / (6 * std::numbers::pi * std::numbers::sqrt3 * m.m2)) <=
          10 * epsilon);
  }
}

// ---- spectral moments ----

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
