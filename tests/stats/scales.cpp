#include "stats/measure/scales.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "fields.hpp"
#include "holes.hpp"
#include "stats/hybrid/spectral_moments.hpp"
#include "stats/spatial/acf.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr DataWindows whole{DataWindow::none, DataWindow::none}, by_hann{DataWindow::hann, DataWindow::hann};

std::vector<ScalePoint> scales_of(const Field& z, const Grid& g) {
  return by_scale(Sample({.grid = g, .heights = z}), g.periodic.both() ? whole : by_hann);
}

ScalePoint at(const std::vector<ScalePoint>& all, const std::string& quantity, Axis1D axis, double scale) {
  return *std::ranges::find_if(all, [&](const ScalePoint& p) {
    return p.quantity == quantity && p.axis == axis && relative_error(p.scale, scale) <= 1e-9;
  });
}
double value_at(const std::vector<ScalePoint>& all, const std::string& quantity, Axis1D axis, double scale) {
  return at(all, quantity, axis, scale).estimate.value;
}

}  // namespace

// Round-off of a difference, ε A, over one of A sin²(π/64) = 0.0024 A.
TEST_CASE("a sine has its height, slope and curvature in one band, and over a distance those of its chords",
          "[scales][exact]") {
  const double A = 3;
  const Grid g{{64, 4}, 0.5, 0.25, true};
  for (int periods : {1, 3, 8}) {
    const double q = 2 * std::numbers::pi * periods / g.size_x();
    const auto all = scales_of(sine(g.shape, A, periods), g);
    for (double scale = 1; scale <= 32; scale *= 2) {
      const double wavelength = g.size_x() / periods;
      const bool own = scale <= wavelength && wavelength < 2 * scale;
      CAPTURE(periods, scale);
      double power = A / std::numbers::sqrt2;
      for (const char* quantity : {"band_height", "band_slope", "band_curvature"}) {
        CHECK(std::abs(value_at(all, quantity, Axis1D::x, scale) - own * power) <= 1e-12 * power);
        power *= q;
      }
    }
    for (double l = 1; l <= 16; l *= 2) {
      const double chord = A * std::numbers::sqrt2 * std::abs(std::sin(q * l / 2)) / l,
                   half = std::sin(q * l / 4), bend = 8 * std::numbers::sqrt2 * A * half * half / (l * l);
      CAPTURE(periods, l);
      CHECK(std::abs(value_at(all, "distance_slope", Axis1D::x, l) - chord) <= 1e-12 * A);
      CHECK(std::abs(value_at(all, "distance_curvature", Axis1D::x, l) - bend) <= 1e-12 * A);
    }
    CHECK(at(all, "distance_slope", Axis1D::y, 0.25).no_error == NoError::flat);
  }
}

// Of sums of 1000 squares.
TEST_CASE("over the shortest distances slope and curvature are the roots of m2 and m4, with holes too",
          "[scales][law]") {
  for (const bool periodic : {true, false}) {
    const Grid g{{40, 31}, 2e-6, 3e-6, periodic};
    for (const Field& z : {random_field(g.shape, 3), with_holes(random_field(g.shape, 4), 0.1, 5)}) {
      const auto all = scales_of(z, g);
      const SpectralMoments m = spectral_moments(z, g);
      CHECK(relative_error(value_at(all, "distance_slope", Axis1D::x, g.dx), std::sqrt(m.m20)) <= 1e-12);
      CHECK(relative_error(value_at(all, "distance_slope", Axis1D::y, g.dy), std::sqrt(m.m02)) <= 1e-12);
      CHECK(relative_error(value_at(all, "distance_curvature", Axis1D::x, 2 * g.dx), std::sqrt(m.m40)) <=
            1e-12);
      CHECK(relative_error(value_at(all, "distance_curvature", Axis1D::y, 2 * g.dy), std::sqrt(m.m04)) <=
            1e-12);
    }
  }
}

TEST_CASE("over a distance slope and curvature follow from the autocorrelation", "[scales][law]") {
  const Grid g{{32, 32}, 1, 1, true};
  const Field z = gaussian_acf_field(g.shape, 4, 7);
  const auto all = scales_of(z, g);
  const LagField R = estimate_autocorrelation(z, Pairs(g), {.max_lag = {16, 16}});
  for (const double l : {2, 4, 8, 16}) {
    const auto s = static_cast<Index>(l), h = s / 2;
    CAPTURE(l);
    CHECK(relative_error(value_at(all, "distance_slope", Axis1D::y, l),
                         std::sqrt(2 * (R(0, 0) - R(0, s))) / l) <= 1e-10);
    CHECK(relative_error(value_at(all, "distance_curvature", Axis1D::y, l),
                         std::sqrt(6 * R(0, 0) - 8 * R(0, h) + 2 * R(0, s)) / (l * l / 4)) <= 1e-10);
  }
}

TEST_CASE("the heights of all bands add up to Sq, whatever the shape", "[scales][law]") {
  for (const Shape shape : {Shape{16, 16}, Shape{15, 22}, Shape{9, 1}, Shape{48, 7}}) {
    const Grid g{shape, 2e-6, 3e-6, true};
    const Field noise = random_field(shape, 11), z = noise - noise.mean();
    double sum = 0;
    for (const ScalePoint& p : scales_of(z, g))
      if (std::string(p.quantity) == "band_height" && p.axis == Axis1D::x)
        sum += std::pow(p.estimate.value, 2);
    double across = 0;  // waves along y alone have none along x
    for (Index j = 0; j < shape.ny; ++j)
      across += std::pow(z.col(j).mean(), 2) / static_cast<double>(shape.ny);
    CHECK(relative_error(sum + across, z.square().mean()) <= 1e-12);
  }
}

TEST_CASE("patches do not feel a tilt, and hold white noise but for two in their points",
          "[scales][law][statistics]") {
  const Grid g = grid(128, 96);
  const Field noise = white_noise(g.shape, 21),
              tilted = noise + sample(g, [](double x, double y) { return 5 * x - 3 * y; });
  const auto flat = scales_of(noise - noise.mean(), g), steep = scales_of(tilted, g);
  for (const double s : {4, 8, 16, 32}) {
    const double value = value_at(flat, "patch_height", Axis1D::y, s);
    CHECK(relative_error(value_at(steep, "patch_height", Axis1D::y, s), value) <= 1e-10);
    // Sums of squares of 12288 (1 - 2/s) normal numbers: 4 errors of 1/√(2 · 12288 (1 - 2/s)).
    CHECK(relative_error(value, std::sqrt(1 - 2 / s)) <= 4 / std::sqrt(2 * 12288 * (1 - 2 / s)));
  }
}

TEST_CASE("a map that is turned has its scales along the other axis", "[scales][law]") {
  const Grid g{{48, 64}, 2, 3, false}, turned{{64, 48}, 3, 2, false};
  const Field z = moving_average(g.shape, {5, 3}, 2);
  const auto all = scales_of(z, g), others = scales_of(z.transpose(), turned);
  CHECK(all.size() == others.size());
  for (const ScalePoint& p : all) {
    const ScalePoint q = at(others, p.quantity, p.axis == Axis1D::x ? Axis1D::y : Axis1D::x, p.scale);
    CAPTURE(p.quantity, p.scale);
    CHECK(relative_error(q.estimate.value, p.estimate.value) <= 1e-9);
    CHECK(q.no_error == p.no_error);
    if (p.no_error == NoError::none)
      CHECK(relative_error(q.estimate.standard_error, p.estimate.standard_error) <= 1e-6);
  }
}

// Of 95 % of 100 fields 3 errors of √(0.95 · 0.05/100) may be missing. The spread of 100 is known to 7 %, and
// errors are 1.0 to 1.3 of it.
TEST_CASE("intervals by scale hold the slope of a triangular correlation", "[scales][statistics]") {
  const Grid g = grid(96, 96);
  std::array<int, 3> held{};
  Spread values, square_errors;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const auto all = scales_of(moving_average(g.shape, {8, 8}, 100 + seed), g);
    for (const int k : {0, 1, 2}) {
      const double l = std::array{1, 4, 8}.at(static_cast<std::size_t>(k)), truth = std::sqrt(2 * l / 8) / l;
      const Estimate found = at(all, "distance_slope", Axis1D::x, l).estimate;
      const Interval ends = *found.interval;
      if (l == 1) values.add(found.value), square_errors.add(std::pow(found.standard_error, 2));
      held.at(static_cast<std::size_t>(k)) += ends.low <= truth && truth <= ends.high;
    }
  }
  CHECK(*std::ranges::min_element(held) >= 88);
  const double stated = std::sqrt(square_errors.mean()) / values.deviation();
  CHECK(stated >= 0.8);
  CHECK(stated <= 1.5);
}

// Holes of a checkerboard leave no two neighbours; half a map of n points is more than n/8 long.
TEST_CASE("what has no error by scale says why", "[scales][contract]") {
  const Grid g = grid(64, 64);
  const Field z = moving_average(g.shape, {6, 6}, 4),
              board = Field::NullaryExpr(64, 64, [](Index i, Index j) { return (i + j) % 2 ? none : 0.0; });
  const auto why = [](const Surface& surface, const char* quantity, double l) {
    return at(by_scale(Sample(surface), by_hann), quantity, Axis1D::x, l).no_error;
  };
  CHECK(why({.grid = g, .heights = z}, "distance_slope", 1) == NoError::none);
  CHECK(why({.grid = g, .heights = z}, "distance_slope", 16) == NoError::size);
  CHECK(why({.grid = g, .heights = z, .degree = 2}, "distance_slope", 16) == NoError::size);
  CHECK(why({.grid = g, .heights = z, .degree = 2}, "distance_slope", 32) == NoError::form);
  CHECK(why({.grid = g, .heights = z, .degree = 2}, "band_height", 64) == NoError::form);
  CHECK(why({.grid = g, .heights = z, .step = 0.5}, "distance_slope", 1) == NoError::steps);
  CHECK(why({.grid = g, .heights = z, .step = 0.5}, "patch_height", 4) == NoError::steps);
  CHECK(why({.grid = g, .heights = z, .step = 0.5}, "band_curvature", 2) == NoError::steps);
  CHECK(why({.grid = g, .heights = z + board}, "distance_slope", 1) == NoError::holes);
  CHECK(std::isnan(value_at(scales_of(z + board, g), "distance_slope", Axis1D::x, 1)));
  CHECK(why({.grid = g, .heights = z + board}, "distance_slope", 2) == NoError::none);
}

// ---- a tip ----

// The summit of A sin(qx) lies on a point; 4A sin²(qs/2)/s² falls with s.
TEST_CASE("a tip is too blunt for a sine up to the distance at which its summits are half as sharp",
          "[scales][exact]") {
  const double A = 1;
  const Grid g{{256, 3}, 1, 1, true};
  const double q = 2 * std::numbers::pi * 4 / 256;
  const Field z =
      Field::NullaryExpr(256, 3, [&](Index i, Index) { return A * std::cos(q * static_cast<double>(i)); });
  for (const double R : {55.0, 100.0, 200.0}) {
    double s = 1;
    while (4 * A * std::pow(std::sin(q * s / 2) / s, 2) > 1 / (2 * R)) ++s;
    CAPTURE(R, s);
    CHECK(first_reliable_scale({.grid = g, .heights = z}, R) == (s > 1 ? 2 * s : 0));
  }
  CHECK(first_reliable_scale({.grid = g, .heights = z}, 50) == 0);  // 1/(A q²) = 104 > 2 · 50
}

// A random walk under a sphere. Of simulated maps the header tells 0.77 to 0.93, and 0.15 to 0.62 at one point.
TEST_CASE("a scan keeps most of its curvature from its first reliable scale on, and little at the shortest",
          "[scales][statistics]") {
  const Index n = 4096, R = 20;
  const Grid g{{n, 1}, 1, 1, false};
  Field rough = 0.3 * white_noise(g.shape, 5), scan = Field::Constant(n, 1, -1e9);
  for (Index i = 1; i < n; ++i) rough(i) += rough(i - 1);
  for (Index i = 0; i < n; ++i)
    for (Index d = std::max(-R, -i); d <= std::min(R, n - 1 - i); ++d)
      scan(i) = std::max(scan(i), rough(i + d) - R + std::sqrt(static_cast<double>(R * R - d * d)));
  const double l = first_reliable_scale({.grid = g, .heights = scan}, R);
  auto kept = [&](Index s) {
    auto curvature = [&](const Field& z) {
      return (z.topRows(n - 2 * s) - 2 * z.middleRows(s, n - 2 * s) + z.bottomRows(n - 2 * s)).square().sum();
    };
    return std::sqrt(curvature(scan) / curvature(rough));
  };
  CAPTURE(l, kept(1), kept(std::lround(l / 2)));
  CHECK(l >= 8);
  CHECK(kept(std::lround(l / 2)) >= 0.77);
  CHECK(kept(1) <= 0.62);
}
