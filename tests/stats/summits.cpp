#include "stats/hybrid/summits.hpp"

#include "core/error.hpp"
#include "fields.hpp"
#include "whole.hpp"

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
  CHECK(counted_summits(z, g, 3).mean_curvature == summits.mean_curvature);

  const Grid open{g.shape, g.dx, g.dy, false};
  CHECK(counted_summits(z, open).count < summits.count);  // a row and a column of crests lie on the edge
  CHECK(counted_summits(sine({20, 20}, 1, 2), grid(20, 20)).count == 0);  // ridges are not summits
  CHECK_THROWS_AS(counted_summits(random_field({2, 9}, 1), grid(2, 9)), DataError);
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
