// Degrees of freedom of a spectrum's points, from their neighbours.
#include "stats/spectrum/pooled_degrees.hpp"

#include "fields.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// C, and √u C as its error.
SpectrumPoint point(double density, double relative_variance) {
  return {.density = density, .standard_error = density * std::sqrt(relative_variance), .degrees = 1e3};
}

double pooled(double relative_variance) {
  const double from_mean = 2 / relative_variance - 2;
  return from_mean * from_mean / (from_mean + 1.5);
}

}  // namespace

// Arithmetic of a few operations.
TEST_CASE("points of a profile share their relative variance with neighbours, those of a ring as 1/k",
          "[pooled-degrees][exact]") {
  std::vector<SpectrumPoint> profile, rings;
  for (const double u : {0.3, 0.02, 0.05, 0.08, 0.02, 0.02, 0.02, 0.02, 0.02, 0.11})
    profile.push_back(point(1 + 10 * u, u));
  for (int k = 1; k <= 12; ++k) rings.push_back(point(k, 0.5 / k));
  pool_degrees(profile, PointKind::profile);
  pool_degrees(rings, PointKind::ring);
  CHECK(relative_error(profile[0].degrees, pooled(0.3)) <= 100 * epsilon);    // alone
  CHECK(relative_error(profile[1].degrees, pooled(0.035)) <= 100 * epsilon);  // not with the first
  CHECK(relative_error(profile[2].degrees, pooled(0.05)) <= 100 * epsilon);
  CHECK(relative_error(profile[8].degrees, pooled((3 * 0.02 + 0.11) / 4)) <= 100 * epsilon);
  for (const SpectrumPoint& p : profile)
    CHECK(relative_error(p.standard_error, p.density * std::sqrt(2 / (p.degrees + 2))) <= 100 * epsilon);
  for (int k = 2; k <= 12; ++k)
    CHECK(relative_error(rings[static_cast<std::size_t>(k - 1)].degrees, pooled(0.5 / k)) <= 100 * epsilon);
}

TEST_CASE("a single wave number keeps its two degrees of freedom, its own mirror image one",
          "[pooled-degrees][exact]") {
  std::vector<SpectrumPoint> single{point(1, 2.0 / 3), point(2, 0.5), point(3, 0.5), point(4, 0.5)};
  pool_degrees(single, PointKind::profile);
  CHECK(relative_error(single[0].degrees, 1) <= 100 * epsilon);
  for (const std::size_t k : {1, 2, 3}) CHECK(relative_error(single[k].degrees, 2) <= 100 * epsilon);
}

TEST_CASE("points beside a density of zero keep the errors that they have", "[pooled-degrees][law]") {
  std::vector<SpectrumPoint> points(12, point(1, 0.1));
  points[5].density = points[5].standard_error = 0;
  pool_degrees(points, PointKind::profile);
  for (const std::size_t k : {4, 5, 6}) CHECK(points[k].degrees == 1e3);
  CHECK(points[9].degrees < 1e3);
}
