#include "stats/hybrid/summits.hpp"

#include <array>
#include <map>

#include "core/error.hpp"
#include "fields.hpp"

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
