#include "stress/influence.hpp"

#include <numbers>

#include "quadrature.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;
using stress::Tensor;

namespace {

double largest(const Tensor& s) {
  double top = 0;
  for (double component : s) top = std::max(top, std::abs(component));
  return top;
}

double difference(const Tensor& s, const Tensor& t) {
  double top = 0;
  for (auto c : stress::components) top = std::max(top, std::abs(s[c] - t[c]));
  return top;
}

// The point load integrated over the rectangle, 8 × 8 panels of 16 × 16 points.
Tensor integrated(double x, double y, double z, double a, double b, double nu) {
  static const auto rule = gauss_legendre(16);
  constexpr int panels = 8;
  Tensor sum{};
  for (int i = 0; i < panels; ++i)
    for (int j = 0; j < panels; ++j)
      for (auto [u, wu] : rule)
        for (auto [v, wv] : rule) {
          const double px = a * ((2 * i + 1 + u) / panels - 1), py = b * ((2 * j + 1 + v) / panels - 1);
          const Tensor s = point_load_stress(x - px, y - py, z, nu);
          for (auto c : stress::components) sum[c] += wu * wv * a * b / (panels * panels) * s[c];
        }
  return sum;
}

}  // namespace

// A panel's half side is at most 1/4 of the depth, so 16 points converge as (4 + √17)^-32 = 1e-29; what is
// left is the round-off of 16384 terms, 1e-14 of their sum of moduli, at most 4 (the in-plane shear of a unit
// load).
TEST_CASE("the stress below a rectangle is the integral of the point load over it", "[influence][exact]") {
  const Field points = random_field({24, 6}, 11);
  for (Index k = 0; k < points.rows(); ++k) {
    const double x = 3 * points(k, 0), y = 3 * points(k, 1), a = std::exp(points(k, 2)),
                 b = std::exp(points(k, 3));
    const double z = 0.5 * std::max(a, b) * std::exp(1 + points(k, 4)), nu = 0.25 * (1 + points(k, 5));
    CAPTURE(x, y, z, a, b, nu);
    CHECK(difference(rectangle_stress(x, y, z, a, b, nu), integrated(x, y, z, a, b, nu)) <= 4e-14);
  }
}

TEST_CASE(
    "at the surface the normal stress is the pressure: whole inside, a half on an edge, a quarter at a "
    "corner",
    "[influence][exact]") {
  const double a = 1.5, b = 0.5;
  for (double nu : {0.0, 0.3, 0.5}) {
    auto zz = [&](double x, double y) { return rectangle_stress(x, y, 0, a, b, nu)[stress::zz]; };
    CHECK(zz(0.3, -0.2) == Approx(-1).epsilon(4 * epsilon));
    CHECK(zz(a, 0.1) == Approx(-0.5).epsilon(4 * epsilon));
    CHECK(zz(0.7, -b) == Approx(-0.5).epsilon(4 * epsilon));
    CHECK(zz(a, b) == Approx(-0.25).epsilon(4 * epsilon));
    CHECK(std::abs(zz(1.6, 0.1)) <= 4 * epsilon);
    for (double x : {0.3, a, 1.6}) {
      const Tensor s = rectangle_stress(x, 0.2, 0, a, b, nu);
      CHECK(s[stress::xz] == 0);
      CHECK(s[stress::yz] == 0);
    }
  }
}

TEST_CASE("in the centre of a loaded square the surface stress is -(1/2 + nu) in the plane",
          "[influence][exact]") {
  for (double nu : {0.0, 0.3, 0.5}) {
    const Tensor s = rectangle_stress(0, 0, 0, 2, 2, nu);
    CHECK(s[stress::xx] == Approx(-(0.5 + nu)).epsilon(4 * epsilon));
    CHECK(s[stress::yy] == Approx(-(0.5 + nu)).epsilon(4 * epsilon));
  }
}

// The field's slope in z is at most about 1/(distance to the edge) = 5 per component: 5e-12 over 1e-12.
TEST_CASE("the stress goes over into its surface values", "[influence][law]") {
  for (double x : {0.0, 0.8, 1.2, 5.0})
    CHECK(difference(rectangle_stress(x, 0.3, 1e-12, 1, 1, 0.3), rectangle_stress(x, 0.3, 0, 1, 1, 0.3)) <=
          1e-11);
}

TEST_CASE("under a mirror of x or y the shear stresses across it change sign, the others stay",
          "[influence][law]") {
  const Tensor s = rectangle_stress(0.7, 0.4, 0.6, 1, 0.5, 0.3),
               in_x = rectangle_stress(-0.7, 0.4, 0.6, 1, 0.5, 0.3),
               in_y = rectangle_stress(0.7, -0.4, 0.6, 1, 0.5, 0.3);
  for (auto c : stress::components) {
    CAPTURE(stress::names[c]);
    CHECK(std::abs(in_x[c] - (odd_in_x(c) ? -1 : 1) * s[c]) <= 4 * epsilon);
    CHECK(std::abs(in_y[c] - (odd_in_y(c) ? -1 : 1) * s[c]) <= 4 * epsilon);
  }
}

// A(X,Y) + A(Y,X) = T is what makes this true of xx and yy, which are written differently.
TEST_CASE("exchanging x and y exchanges xx with yy and xz with yz", "[influence][law]") {
  const Tensor s = rectangle_stress(0.7, 0.4, 0.6, 1, 0.5, 0.2),
               t = rectangle_stress(0.4, 0.7, 0.6, 0.5, 1, 0.2);
  CHECK(difference(s, {t[stress::yy], t[stress::xx], t[stress::zz], t[stress::xy], t[stress::yz],
                       t[stress::xz]}) <= 8 * epsilon);
}

TEST_CASE("the trace is -(1+nu)/pi times the solid angle of the rectangle", "[influence][exact]") {
  const double x = 0.3, y = -0.9, z = 0.4, a = 1, b = 0.7;
  double solid_angle = 0;
  for (int sx : {-1, 1})
    for (int sy : {-1, 1}) {
      const double X = x + sx * a, Y = y + sy * b;
      solid_angle += sx * sy * std::atan(X * Y / (z * std::sqrt(X * X + Y * Y + z * z)));
    }
  for (double nu : {0.0, 0.3, 0.5}) {
    const Tensor s = rectangle_stress(x, y, z, a, b, nu);
    CHECK(s[stress::xx] + s[stress::yy] + s[stress::zz] ==
          Approx(-(1 + nu) / std::numbers::pi * solid_angle).epsilon(16 * epsilon));
  }
}

// The rectangle's second moments leave a relative error C (a/ρ)², C of the order of one.
TEST_CASE("far away a rectangle acts as a point load, at order 2 in the distance", "[influence][order]") {
  auto error = [](double distance) {
    const double x = 0.48 * distance, y = 0.6 * distance, z = 0.64 * distance;
    const Tensor point = point_load_stress(x, y, z, 0.3);
    Tensor load = point;
    for (double& s : load) s *= 2 * 1;
    return difference(rectangle_stress(x, y, z, 1, 0.5, 0.3), load) / largest(load);
  };
  CHECK(observed_order(error(10), error(20)) == Approx(2).margin(0.02));
  CHECK(observed_order(error(20), error(40)) == Approx(2).margin(0.02));
  CHECK(error(10) <= 0.02);
}

TEST_CASE("below a point load the normal stress is -3/(2 pi z^2)", "[influence][exact]") {
  for (double nu : {0.0, 0.5})
    CHECK(point_load_stress(0, 0, 3, nu)[stress::zz] ==
          Approx(-3 / (18 * std::numbers::pi)).epsilon(4 * epsilon));
}
