#include "stats/spectrum/spectrum.hpp"

#include <iterator>
#include <tuple>

#include <gsl/gsl_cdf.h>

#include "fields.hpp"
#include "stats/measure/spectra.hpp"
#include "stats/spatial/acf.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr DataWindows plain{DataWindow::none, DataWindow::none}, hann{DataWindow::hann, DataWindow::hann};

Grid metres(Index nx, Index ny, bool periodic = true) { return {{nx, ny}, 2e-6, 3e-6, periodic}; }

double sum_over_plane(const LagField& psd, const Grid& grid) {
  double sum = 0;
  for_each_lag(psd, metres(grid.shape.nx, grid.shape.ny),
               [&](Index p, Index q, double w) { sum += w * psd(p, q); });
  return sum;
}

double hann_at(Index i, Index n) {
  return 1 - std::cos(2 * std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(n));
}

Field wave(const Grid& g, int kx, int ky) {
  return sample(g, [&](double x, double y) {
    return std::cos(2 * std::numbers::pi * (kx * x / g.size_x() + ky * y / g.size_y()) + 0.3);
  });
}

}  // namespace

// Each sum of n points through a transform, ε log2(n).
TEST_CASE("the PSD adds up to the mean square of the windowed heights, odd or even, square or not",
          "[spectrum][exact]") {
  for (Shape shape : {Shape{16, 16}, Shape{9, 14}, Shape{12, 7}, Shape{15, 21}, Shape{1, 8}, Shape{8, 2}}) {
    const Grid g = metres(shape.nx, shape.ny);
    const Field z = random_field(shape, 91);
    CAPTURE(shape.nx, shape.ny);
    const double area = g.size_x() * g.size_y();
    CHECK(relative_error(sum_over_plane(power_spectrum(z, g, plain), g) / area, z.square().mean()) <=
          40 * epsilon);
    if (shape.nx < 3 || shape.ny < 3) continue;
    double windowed = 0;
    for (Index i = 0; i < shape.nx; ++i)
      for (Index j = 0; j < shape.ny; ++j)
        windowed += std::pow(hann_at(i, shape.nx) * hann_at(j, shape.ny) * z(i, j), 2);
    windowed /= 2.25 * static_cast<double>(shape.cells());  // W = 3/2 for each axis
    CHECK(relative_error(sum_over_plane(power_spectrum(z, g, hann), g) / area, windowed) <= 40 * epsilon);
  }
}

// Of the tables that users add up; with a full density at both signs the board alone gives four times Sq².
TEST_CASE("tables of wave numbers of both signs add up to Sq squared, of a chessboard too",
          "[spectrum][exact]") {
  for (Shape shape :
       {Shape{8, 8}, Shape{8, 7}, Shape{7, 8}, Shape{7, 9}, Shape{1, 8}, Shape{8, 1}, Shape{2, 6}}) {
    const Grid g = metres(shape.nx, shape.ny);
    const Field board = Field::NullaryExpr(shape.nx, shape.ny, [](Index i, Index j) { return (i + j) % 2; });
    for (const Field& heights : {board, random_field(shape, 96)}) {
      const Field z = heights - heights.mean(), half = over_both_signs(power_spectrum(z, g, plain), g);
      const double square = z.square().mean(),
                   sum = half.row(0).sum() + 2 * half.bottomRows(half.rows() - 1).sum();
      CAPTURE(shape.nx, shape.ny);
      CHECK(relative_error(sum / (g.size_x() * g.size_y()), square) <= 40 * epsilon);
      const Sample sample({.grid = g, .heights = z});
      for (const auto& [axis, length] :
           {std::pair{Axis1D::x, g.size_x()}, std::pair{Axis1D::y, g.size_y()}}) {
        const auto points = profile_spectrum(sample, axis, DataWindow::none);
        double total = -points.front().density;
        for (const SpectrumPoint& point : points) total += 2 * point.density;
        CHECK(relative_error(total / length, square) <= 40 * epsilon);
      }
    }
  }
}

TEST_CASE("a wave of amplitude 1 has the PSD Lx Ly/4 at its wave number and none elsewhere",
          "[spectrum][exact]") {
  const Grid g = metres(20, 18);
  const LagField psd = power_spectrum(wave(g, 3, -5), g, plain);
  const double area = g.size_x() * g.size_y();
  for (Index p = 0; p <= 10; ++p)
    for (Index q = -9; q <= 9; ++q)
      CHECK(std::abs(psd(p, q) / area - (p == 3 && q == -5 ? 0.25 : 0)) <= 20 * epsilon);
}

TEST_CASE("the PSD of a periodic surface is the transform of its autocorrelation", "[spectrum][law]") {
  const Grid g = metres(12, 15);
  const Field z = random_field(g.shape, 92) + wave(g, 2, 1);
  const LagField psd = power_spectrum(z - z.mean(), g, plain),
                 R = estimate_autocorrelation(z, g, {.max_lag = {6, 7}});
  for (Index p : {0, 1, 4, 6})
    for (Index q : {-7, -2, 0, 3}) {
      double sum = 0;
      for_each_lag(psd, g, [&](Index k, Index l, double w) {
        sum += w * psd(k, l) *
               std::cos(2 * std::numbers::pi *
                        (static_cast<double>(k * p) / 12 + static_cast<double>(l * q) / 15));
      });
      CHECK(std::abs(sum / (g.size_x() * g.size_y()) - R(p, q)) <= 200 * epsilon);
    }
}

// The mean periodogram, point by point.
TEST_CASE("the profile PSD is the mean of the profiles' own and adds up to Sq squared", "[spectrum][exact]") {
  for (const Shape shape : {Shape{12, 9}, Shape{9, 12}}) {
    const Grid g = metres(shape.nx, shape.ny);
    const Field z = random_field(shape, 93);
    for (const DataWindow window : {DataWindow::none, DataWindow::hann}) {
      const auto psd = profile_spectrum(z, g, Axis1D::x, window);
      REQUIRE(psd.size() == static_cast<std::size_t>(shape.nx / 2 + 1));
      double total = 0;
      for (std::size_t k = 0; k < psd.size(); ++k) {
        double direct = 0;
        for (Index j = 0; j < shape.ny; ++j) {
          Complex sum = 0;
          for (Index i = 0; i < shape.nx; ++i)
            sum += z(i, j) * (window == DataWindow::hann ? hann_at(i, shape.nx) / std::sqrt(1.5) : 1) *
                   std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k) * static_cast<double>(i) /
                                       static_cast<double>(shape.nx));
          direct += std::norm(sum);
        }
        direct *= g.dx * g.dx / g.size_x() / static_cast<double>(shape.ny);
        CHECK(std::abs(psd[k].density - direct) <= 100 * epsilon * g.dx);
        CHECK(psd[k].wave_number == Approx(2 * std::numbers::pi * static_cast<double>(k) / g.size_x()));
        total += (k == 0 || 2 * static_cast<Index>(k) == shape.nx ? 1 : 2) * psd[k].density / g.size_x();
      }
      if (window == DataWindow::none) CHECK(relative_error(total, z.square().mean()) <= 40 * epsilon);
    }
    const Grid turned{{shape.ny, shape.nx}, g.dy, g.dx, true};
    // The same sums in another order: ε log2(108) of both transforms' amplitudes, twice in their squares.
    for (const DataWindow window : {DataWindow::none, DataWindow::hann}) {
      const auto along_y = profile_spectrum(z, g, Axis1D::y, window),
                 of_turned = profile_spectrum(z.transpose(), turned, Axis1D::x, window);
      REQUIRE(along_y.size() == of_turned.size());
      for (std::size_t k = 0; k < along_y.size(); ++k) {
        CHECK(relative_error(along_y[k].density, of_turned[k].density) <= 30 * epsilon);
        CHECK(relative_error(along_y[k].standard_error, of_turned[k].standard_error) <= 60 * epsilon);
        CHECK(along_y[k].wave_number == of_turned[k].wave_number);
        CHECK(along_y[k].count == of_turned[k].count);
      }
    }
  }
}

// C = π l² exp(-q²l²/4) and C1 = √π l exp(-q²l²/4). Deviations in standard errors, the sum of whose squares
// has the mean 1 a ring; the errors are estimates too, so that few wave numbers give more: rings of 12 and
// more, and 8 fields together. Of n squares of normal deviations the mean has the spread √(2/n); four of them.
TEST_CASE("radial and profile PSD of a Gaussian field are those of its autocorrelation, within their errors",
          "[spectrum][statistics]") {
  const Grid g{{128, 128}, 1e-6, 1e-6, true};
  const double l = 5e-6;
  double rings = 0, squares = 0, rows = 0, row_squares = 0;
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Field z = gaussian_acf_field(g.shape, l / g.dx, seed);
    for (const SpectrumPoint& ring :
         radial_spectrum(power_spectrum(z, g, plain), g, shared_power(z, plain))) {
      const double q = ring.wave_number * l;
      if (ring.count < 12 || q > 6) continue;
      // Over the ring's width of 2π/L the curve bends by less than its error.
      squares +=
          std::pow((ring.density - std::numbers::pi * l * l * std::exp(-q * q / 4)) / ring.standard_error, 2);
      ++rings;
    }
    for (const SpectrumPoint& row : profile_spectrum(z, g, Axis1D::x, DataWindow::none)) {
      const double q = row.wave_number * l;
      if (q == 0 || q > 6) continue;
      const double exact = std::sqrt(std::numbers::pi) * l * std::exp(-q * q / 4);
      row_squares += std::pow((row.density - exact) / row.standard_error, 2);
      ++rows;
    }
  }
  CHECK(rings >= 100);
  CHECK(squares / rings == Approx(1).margin(4 * std::sqrt(2 / rings)));
  CHECK(row_squares / rows == Approx(1).margin(4 * std::sqrt(2 / rows)));
}

// White noise of variance 1: C = ΔxΔy; chance of a mean over 128 × 100 wave numbers with I² = 3.8: 2.4 %, and
// for the rings' errors: their mean square deviation over 49 rings, spread √(2/49) = 20 %, with neighbours
// that share power half as much again. Four of each.
TEST_CASE("white noise has the PSD dx dy with either window, and rings stray from it by one standard error",
          "[spectrum][statistics]") {
  const Grid g = metres(128, 100, false);
  const double flat = g.cell_area();
  for (const DataWindows windows : {plain, hann}) {
    const LagField psd = power_spectrum(white_noise(g.shape, 95), g, windows);
    CHECK(sum_over_plane(psd, g) / static_cast<double>(g.shape.cells()) == Approx(flat).epsilon(0.1));
    double squares = 0, rings = 0;
    for (const SpectrumPoint& ring : radial_spectrum(psd, g, shared_power(Field::Zero(128, 100), windows))) {
      if (ring.count < 30) continue;
      squares += std::pow((ring.density - flat) / ring.standard_error, 2);
      ++rings;
    }
    CHECK(squares / rings == Approx(1).margin(1.0));
  }
}

TEST_CASE("the PSD does not depend on the number of threads, and only open fields are windowed",
          "[spectrum][law]") {
  const Field z = random_field({40, 90}, 96);
  const Grid g = metres(40, 90);
  CHECK((power_spectrum(z, g, hann).half_plane() == power_spectrum(z, g, hann, 3).half_plane()).all());
  CHECK(default_windows(g).x == DataWindow::none);
  CHECK(default_windows(metres(4, 4, false)).y == DataWindow::hann);
}

// The kernel's half width is 2° and the wave fills one wave number: the top is at its angle to half a sector,
// 1/8°.
TEST_CASE("the texture direction of a wave is the direction that it runs in", "[texture-direction][exact]") {
  const Grid g = metres(200, 160);
  for (const auto& [kx, ky] : {std::pair{20, 0}, {0, 17}, {12, 9}, {25, -31}, {7, -8}}) {
    const TextureDirection found = texture_direction(power_spectrum(wave(g, kx, ky), g, plain), g);
    const double exact = std::atan2(ky / g.size_y(), kx / g.size_x());
    CAPTURE(kx, ky);
    CHECK(std::abs(std::remainder(found.angle - exact, std::numbers::pi)) <= 0.5 * std::numbers::pi / 180);
    CHECK(found.contrast >= 10);
  }
}

// A map in nm is in metres what it is in mm but for a rounding of its spacing: the largest wave numbers,
// which lie on the bound of those that count, counted or did not, and the direction turned by 65°.
TEST_CASE("the texture direction does not turn by a rounding of the spacing", "[texture-direction][law]") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Grid g = grid(16, 20);
    const Field z = moving_average(g.shape, {2, 2}, seed);
    const TextureDirection first = texture_direction(power_spectrum(z, g, hann), g);
    for (const double sign : {-1.0, 1.0}) {
      Grid rounded = g;
      rounded.dx *= 1 + sign * epsilon;
      const TextureDirection found = texture_direction(power_spectrum(z, rounded, hann), rounded);
      CAPTURE(seed, sign);
      CHECK(std::abs(found.angle - first.angle) <= 1e-9);
      CHECK(relative_error(found.contrast, first.contrast) <= 1e-9);
    }
  }
}

// F of white noise is even but for chance: 2° hold 290 wave numbers, worth a quarter of that under the
// windows, a spread of 12 %, and 2.5 of it the largest of 90 such sectors; of ridges that stretch along y the
// waves run along x.
TEST_CASE("white noise has hardly a texture, ridges have theirs across them", "[texture-direction][law]") {
  const Grid g = grid(256, 256);
  CHECK(texture_direction(power_spectrum(white_noise(g.shape, 97), g, hann), g).contrast <= 1.5);
  const Field ridges = moving_average(g.shape, {2, 24}, 98);
  const TextureDirection found = texture_direction(power_spectrum(ridges, g, hann), g);
  CHECK(std::abs(found.angle) <= 4 * std::numbers::pi / 180);
  CHECK(found.contrast >= 3);
}

// ---- spectrum errors ----

namespace {

Grid free_metres(Index nx, Index ny) { return {{nx, ny}, 2e-6, 3e-6, false}; }

}  // namespace

// Σ (1 - cos)² exp(...) by hand: 3/2, -1, 1/4.
TEST_CASE("Hann's window lets neighbouring wave numbers share 4/9 and 1/36, none nothing",
          "[spectrum][exact]") {
  for (const Shape shape : {Shape{16, 9}, Shape{11, 12}}) {
    const Field d = random_field(shape, 98);
    const SharedPower none = shared_power(d, plain), both = shared_power(d, hann);
    const double along[] = {1, 4.0 / 9, 1.0 / 36, 0};
    for (Index p = 0; p <= 3; ++p)
      for (Index q = -3; q <= 3; ++q) {
        CHECK(std::abs(none(p, q) - (p == 0 && q == 0)) <= 100 * epsilon);
        CHECK(std::abs(both(p, q) - along[p] * along[std::abs(q)]) <= 100 * epsilon);
        CHECK(std::abs(both(p - shape.nx, q + shape.ny) - along[p] * along[std::abs(q)]) <= 100 * epsilon);
      }
  }
}

// E[C²] is 2 E[C]² of a wave number and 3 E[C]² of one that is its own mirror image, as (3) has it.
TEST_CASE("a single wave number has two degrees of freedom, its own mirror image one", "[spectrum][exact]") {
  const Shape shape{8, 6};
  const Grid g = free_metres(shape.nx, shape.ny);
  const Field z = random_field(shape, 101);
  const LagField psd = power_spectrum(z, g, hann);
  for (const auto& [p, q, own] : {std::tuple{0, 0, true}, {4, 3, true}, {4, 0, true}, {2, 1, false}}) {
    const auto only = [p = p, q = q](Index k, Index l) {
      return k == p && std::abs(l) == q && (q != 1 || l == q) ? 0 : -1;
    };
    const MeanPower mean = shared_power(z, hann).means(psd, 1, only).front();
    CAPTURE(p, q);
    CHECK(mean.count == (own ? 1 : 2));
    CHECK(relative_error(mean.variance, psd(p, q) * psd(p, q) * (own ? 2.0 / 3 : 0.5)) <= 100 * epsilon);
    CHECK(relative_error(mean.degrees, own ? 1 : 2) <= 100 * epsilon);
  }
}

// White noise, where the variance is exact. Of 1500 fields, a mean of χ² with ν ≥ 3 degrees has a standard
// deviation known to √((2 + 12/ν)/1500)/2 = 3.2 % at most, and the stated variance, of a relative spread of 1
// or so, to 2 %: four of both. Covered: ring by ring 5 % known to 0.6 %, and as much again for an estimated ν.
TEST_CASE("errors of profiles and rings of the PSD are their spread, at mirror images and edges too",
          "[spectrum][statistics]") {
  for (const Shape shape : {Shape{16, 12}, Shape{13, 16}, Shape{24, 9}})
    for (const DataWindows windows : {plain, hann}) {
      const Grid g = free_metres(shape.nx, shape.ny);
      std::vector<Spread> value, square_error;
      std::vector<double> covered;
      for (unsigned seed = 0; seed < 1500; ++seed) {
        const Field z = white_noise(shape, 3000 + seed);
        auto all = profile_spectrum(z, g, Axis1D::x, windows.x);
        std::ranges::copy(radial_spectrum(power_spectrum(z, g, windows), g, shared_power(z, windows)),
                          std::back_inserter(all));
        value.resize(all.size()), square_error.resize(all.size()), covered.resize(all.size());
        for (std::size_t k = 0; k < all.size(); ++k) {
          const double truth = k <= static_cast<std::size_t>(shape.nx / 2) ? g.dx : g.cell_area();
          const Interval ends = all[k].interval();
          value[k].add(all[k].density), square_error[k].add(std::pow(all[k].standard_error, 2));
          covered[k] += ends.low <= truth && truth <= ends.high ? 1.0 / 1500 : 0;
        }
      }
      for (std::size_t k = 0; k < value.size(); ++k) {
        CAPTURE(shape.nx, shape.ny, k, covered[k]);
        CHECK(std::sqrt(square_error[k].mean()) / value[k].deviation() == Approx(1).margin(0.16));
        CHECK(std::abs(covered[k] - 0.95) <= 0.04);
      }
    }
}

// p² + 4q² against the odd squares (2r ± 1)² for a field twice as long as it is wide, by whole numbers: waves
// along x at odd p lie midway.
TEST_CASE("a wave number midway between two rings counts in the outer one, however the spacing is rounded",
          "[spectrum][exact]") {
  for (const Index ny : {12, 13})
    for (const double spacing : {1e-6, 0.1, 1.0 / 3, 0.7e-3})
      for (const double rounded : {1 - epsilon, 1.0, 1 + epsilon}) {
        const Grid g{{2 * ny, ny}, spacing * rounded, spacing, false};
        std::vector<double> count(static_cast<std::size_t>(ny / 2));
        for (Index p = 1 - ny; p <= ny; ++p)
          for (Index q = -((ny - 1) / 2); q <= ny / 2; ++q)
            for (Index r = 1; r <= ny / 2; ++r) {
              const Index twice = p * p + 4 * q * q;
              count[static_cast<std::size_t>(r - 1)] +=
                  (2 * r - 1) * (2 * r - 1) <= twice && twice < (2 * r + 1) * (2 * r + 1);
            }
        const Field z = random_field(g.shape, 99);
        const auto rings = radial_spectrum(power_spectrum(z, g, hann), g, shared_power(z, hann));
        REQUIRE(rings.size() == count.size());
        for (std::size_t r = 0; r < count.size(); ++r) {
          CAPTURE(ny, spacing, rounded, r);
          CHECK(rings[r].count == count[r]);
        }
      }
}
