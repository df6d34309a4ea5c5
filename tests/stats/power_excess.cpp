// What heights that are not Gaussian add to the errors of spectra.
#include "stats/spectrum/power_excess.hpp"

#include <gsl/gsl_cdf.h>

#include "fields.hpp"
#include "stats/sample/quantiles.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr FieldExtent of_field{700, 1};

// Heights whose local amplitude strays: the exponential of a Gaussian field.
Field skewed(Shape shape, unsigned seed) {
  const Field z = (0.7 * moving_average(shape, {4, 4}, seed)).exp();
  return z - z.mean();
}

void check_equal(const PowerExcess& a, const PowerExcess& b, double bound) {
  CHECK(relative_error(a.of_heights, b.of_heights) <= bound);
  CHECK(relative_error(a.of_slopes, b.of_slopes) <= bound);
  CHECK(relative_error(a.rms_wave_number, b.rms_wave_number) <= bound);
}

}  // namespace

// Student's quantile of 1e9 degrees is the normal one to 1e-9.
TEST_CASE("an excess adds to relative variances, and to what the degrees of freedom stand for",
          "[power-excess][exact]") {
  std::vector<SpectrumPoint> points{{.wave_number = 1, .density = 2, .standard_error = 0.6, .degrees = 20},
                                    {.wave_number = 3, .density = 5, .standard_error = 1, .degrees = 50}};
  add_excess(points, {.of_heights = 0.16, .of_slopes = 0.01, .rms_wave_number = 2, .degrees = 3});
  const double wider = std::pow(student_quantile(0.025, 3) / gsl_cdf_ugaussian_Qinv(0.025), 2);
  CHECK(relative_error(points[0].standard_error, std::sqrt(0.36 + 0.75 * 0.16 * 4)) <= 4 * epsilon);
  CHECK(relative_error(points[0].degrees, 1 / (0.05 + 0.75 * 0.08 * wider)) <= 1e-8);
  CHECK(relative_error(points[1].standard_error, std::sqrt(1 + 0.01 * 25)) <= 4 * epsilon);
  CHECK(relative_error(points[1].degrees, 1 / (0.02 + 0.005 * wider)) <= 1e-8);
}

// The sums are the same ones, in another order; a forward difference along a periodic axis reaches around it.
TEST_CASE("an excess does not depend on units, nor on the names of the axes", "[power-excess][law]") {
  const Grid g{{48, 40}, 2e-6, 3e-6, {true, false}}, turned{{40, 48}, 3e-6, 2e-6, {false, true}};
  Field z = skewed(g.shape, 5);
  for (const bool holes : {false, true}) {
    if (holes) z.block(20, 10, 9, 7).setConstant(NAN);
    for (const DataWindow window : {DataWindow::none, DataWindow::hann}) {
      const PowerExcess x = profile_excess(z, g, Axis1D::x, window, {700, 1.2});
      const PowerExcess rings = radial_excess(z, g, {window, DataWindow::hann}, {700, 1.2});
      CHECK((x.of_heights > 0 && x.of_slopes > 0 && rings.of_slopes > 0));
      check_equal(x, profile_excess(z.transpose(), turned, Axis1D::y, window, {700, 1 / 1.2}), 1e-9);
      check_equal(x, profile_excess(1e-6 * z, g, Axis1D::x, window, {700, 1.2}), 1e-9);
      check_equal(rings, radial_excess(z.transpose(), turned, {DataWindow::hann, window}, {700, 1 / 1.2}),
                  1e-9);
    }
  }
  // A single wave: q of sin(qx) by differences is 2 sin(qΔ/2)/Δ.
  const Field wave = sine({64, 32}, 1, 5);
  CHECK(profile_excess(wave, grid(64, 32, true), Axis1D::x, DataWindow::none, of_field).rms_wave_number ==
        Approx(2 * std::sin(std::numbers::pi * 5 / 64)).epsilon(1e-12));
}

// (1) by hand, of z² on a grid that is periodic, where the point of every difference is there.
TEST_CASE("an excess is what long waves say beyond Gaussian heights of the same power",
          "[power-excess][exact]") {
  const Grid g = grid(48, 40, true);
  const Field z = skewed(g.shape, 7);
  LocalSums squares(g, 1);
  squares.add_rows(48, 1, [&](Index i, LocalSums::Values& values) {
    values.col(1) = z.row(i).square().transpose().matrix();
  });
  const LocalMeans means = squares.means(of_field);
  auto itself = [](const Eigen::VectorXd& m) { return m(0); };
  const double own = std::pow(means.error(itself).error / means(itself), 2);
  for (const auto& [window, overlap] : {std::pair{DataWindow::none, 1.0}, {DataWindow::hann, 35.0 / 18}}) {
    const DataWindows windows{window, DataWindow::none};
    const MeanPower all = shared_power(z, windows)
                              .means(power_spectrum(z, g, windows), 1, [](Index, Index) { return 0; })
                              .front();
    const double excess = own * overlap - all.variance / (all.mean * all.mean);
    REQUIRE(excess > 0);
    CHECK(relative_error(profile_excess(z, g, Axis1D::x, window, of_field).of_heights, excess) <= 1e-9);
  }
}

// Chance leaves max(0, x) of a difference x of mean 0 with the relative spread √(2/7) of 7 waves: 0.21 of the
// Gaussian variance of the mean itself, which is far below that of a ring.
TEST_CASE("Gaussian heights have next to no excess", "[power-excess][statistics]") {
  const Grid g = grid(80, 80);
  Spread slopes, heights;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Field z = moving_average(g.shape, {4, 4}, seed);
    const PowerExcess e = radial_excess(z - z.mean(), g, {}, {400, 1});
    slopes.add(e.of_slopes), heights.add(e.of_heights);
  }
  // Var/mean² = 2 S_2/N of squares, with S_2 = (2.75)² of a window of 4, times 3.78 of Hann's.
  const double gaussian = 2 * 2.75 * 2.75 / 6400 * 3.78;
  CHECK(heights.mean() <= 0.5 * gaussian);
  CHECK(slopes.mean() <= 0.5 * gaussian);
}
