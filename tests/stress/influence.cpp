#include "stress/influence.hpp"

#include <numbers>

#include "reference.hpp"
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

double difference(const Tensor& s, const LongTensor& t) {
  long double top = 0;
  for (auto c : stress::components) top = std::max(top, std::abs(s[c] - t[c]));
  return static_cast<double>(top);
}

}  // namespace

// Four corners of terms up to 2 asinh(2·50), each rounded a few times: 4 · 10 · 2ε / 2π = 1.4e-15 at the
// worst.
TEST_CASE("the stress below a rectangle is the integral of point loads, from squares to strips of 50 to 1",
          "[influence][exact]") {
  const Field points = random_field({60, 5}, 11);
  for (Index k = 0; k < points.rows(); ++k) {
    const double a = std::pow(50.0, 0.5 * points(k, 0)), b = 1 / a;
    const double x = 2 * a * points(k, 1), y = 2 * b * points(k, 2), z = std::pow(4.0, points(k, 3));
    const double nu = 0.25 * (1 + points(k, 4));
    for (auto load : stress::tractions) {
      CAPTURE(x, y, z, a, b, nu, load);
      CHECK(difference(rectangle_stress(x, y, z, a, b, nu, load),
                       integrated_rectangle(x, y, z, a, b, nu, load)) <= 1e-15);
    }
  }
}

// Each term to a few ε; the terms of a component are at most 3 times its largest value.
TEST_CASE("point loads are Boussinesq's and Cerruti's as Johnson writes them", "[influence][exact]") {
  const Field points = random_field({60, 4}, 12);
  for (Index k = 0; k < points.rows(); ++k) {
    const double x = points(k, 0), y = points(k, 1), z = 1.01 + points(k, 2), nu = 0.25 * (1 + points(k, 3));
    for (auto load : stress::tractions) {
      const Tensor s = point_load_stress(x, y, z, nu, load);
      CAPTURE(x, y, z, nu, load);
      CHECK(difference(s, johnson(x, y, z, nu, load)) <= 32 * epsilon * largest(s));
    }
  }
}

TEST_CASE(
    "at the surface the normal stress is the pressure: whole inside, a half on an edge, a quarter at a "
    "corner",
    "[influence][exact]") {
  const double a = 1.5, b = 0.5;
  for (double nu : {-0.9, 0.0, 0.3, 0.5}) {
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

TEST_CASE("at the surface the shear stress is the traction with its sign reversed, and nothing presses",
          "[influence][exact]") {
  const double a = 1.5, b = 0.5;
  auto shear = [&](double x, double y, stress::Component c) {
    const Tensor s =
        rectangle_stress(x, y, 0, a, b, 0.3, c == stress::xz ? stress::shear_x : stress::shear_y);
    CHECK(s[stress::zz] == 0);
    return s[c];
  };
  for (auto c : {stress::xz, stress::yz}) {
    CHECK(shear(0.3, -0.2, c) == Approx(-1).epsilon(4 * epsilon));
    CHECK(shear(a, 0.1, c) == Approx(-0.5).epsilon(4 * epsilon));
    CHECK(shear(a, b, c) == Approx(-0.25).epsilon(4 * epsilon));
    CHECK(std::abs(shear(1.6, 0.1, c)) <= 4 * epsilon);
  }
}

// Two rectangles side by side are one twice as long, on whose middle line there is no step.
TEST_CASE("on a line between equally loaded rectangles what is infinite for each of them cancels",
          "[influence][exact]") {
  for (auto load : stress::tractions)
    for (double y : {0.0, 0.2, 0.5}) {
      const Tensor left = rectangle_stress(1, y, 0, 1, 0.5, 0.3, load),
                   right = rectangle_stress(-1, y, 0, 1, 0.5, 0.3, load),
                   whole = rectangle_stress(0, y, 0, 2, 0.5, 0.3, load);
      CAPTURE(load, y);
      for (auto c : stress::components)
        if (load != stress::shear_x || c != stress::xy || y != 0.5)
          CHECK(std::abs(left[c] + right[c] - whole[c]) <= 8 * epsilon);
    }
}

TEST_CASE("in the centre of a loaded square the surface stress is -(1/2 + nu) in the plane",
          "[influence][exact]") {
  for (double nu : {-0.9, 0.0, 0.3, 0.5}) {
    const Tensor s = rectangle_stress(0, 0, 0, 2, 2, nu);
    CHECK(s[stress::xx] == Approx(-(0.5 + nu)).epsilon(4 * epsilon));
    CHECK(s[stress::yy] == Approx(-(0.5 + nu)).epsilon(4 * epsilon));
  }
}

// The field's slope in z is at most about 1/(distance to the edge) = 5 per component: 5e-12 over 1e-12.
TEST_CASE("the stress goes over into its surface values", "[influence][law]") {
  for (auto load : stress::tractions)
    for (double x : {0.0, 0.8, 1.2, 5.0})
      CHECK(difference(rectangle_stress(x, 0.3, 1e-12, 1, 1, 0.3, load),
                       rectangle_stress(x, 0.3, 0, 1, 1, 0.3, load)) <= 1e-11);
}

TEST_CASE(
    "under a mirror of x or y the shear stresses across it change sign, under a traction across it the "
    "others",
    "[influence][law]") {
  for (auto load : stress::tractions) {
    const Tensor s = rectangle_stress(0.7, 0.4, 0.6, 1, 0.5, 0.3, load),
                 in_x = rectangle_stress(-0.7, 0.4, 0.6, 1, 0.5, 0.3, load),
                 in_y = rectangle_stress(0.7, -0.4, 0.6, 1, 0.5, 0.3, load);
    for (auto c : stress::components) {
      CAPTURE(load, stress::names[c]);
      CHECK(std::abs(in_x[c] - (odd_in_x(c, load) ? -1 : 1) * s[c]) <= 4 * epsilon);
      CHECK(std::abs(in_y[c] - (odd_in_y(c, load) ? -1 : 1) * s[c]) <= 4 * epsilon);
    }
  }
}

// A(X,Y) + A(Y,X) = T is what makes this true of xx and yy, which are written differently.
TEST_CASE("exchanging x and y exchanges xx with yy, xz with yz and the tractions", "[influence][law]") {
  for (auto [load, other] :
       {std::pair{stress::normal, stress::normal}, std::pair{stress::shear_x, stress::shear_y},
        std::pair{stress::shear_y, stress::shear_x}}) {
    const Tensor s = rectangle_stress(0.7, 0.4, 0.6, 1, 0.5, 0.2, load),
                 t = rectangle_stress(0.4, 0.7, 0.6, 0.5, 1, 0.2, other);
    for (auto c : stress::components) CHECK(std::abs(s[c] - t[stress::exchanged(c)]) <= 8 * epsilon);
  }
}

TEST_CASE("the trace is -(1+nu)/pi times the solid angle of the rectangle", "[influence][exact]") {
  const double x = 0.3, y = -0.9, z = 0.4, a = 1, b = 0.7;
  double solid_angle = 0;
  for (int sx : {-1, 1})
    for (int sy : {-1, 1}) {
      const double X = x + sx * a, Y = y + sy * b;
      solid_angle += sx * sy * std::atan(X * Y / (z * std::sqrt(X * X + Y * Y + z * z)));
    }
  for (double nu : {-0.9, 0.0, 0.3, 0.5}) {
    const Tensor s = rectangle_stress(x, y, z, a, b, nu);
    CHECK(s[stress::xx] + s[stress::yy] + s[stress::zz] ==
          Approx(-(1 + nu) / std::numbers::pi * solid_angle).epsilon(16 * epsilon));
  }
}

// The rectangle's second moments leave a relative error C (a/ρ)², C of the order of one.
TEST_CASE("far away a rectangle acts as a point load, at order 2 in the distance", "[influence][order]") {
  for (auto traction : stress::tractions) {
    auto error = [&](double distance) {
      const double x = 0.48 * distance, y = 0.6 * distance, z = 0.64 * distance;
      Tensor load = point_load_stress(x, y, z, 0.3, traction);
      for (double& s : load) s *= 2;  // the area
      return difference(rectangle_stress(x, y, z, 1, 0.5, 0.3, traction), load) / largest(load);
    };
    CAPTURE(traction, error(10));
    CHECK(observed_order(error(10), error(20)) == Approx(2).margin(0.04));
    CHECK(observed_order(error(20), error(40)) == Approx(2).margin(0.02));
    CHECK(error(10) <= 0.02);
  }
}

TEST_CASE("below a point load the normal stress is -3/(2 pi z^2)", "[influence][exact]") {
  for (double nu : {-0.9, 0.0, 0.5})
    CHECK(point_load_stress(0, 0, 3, nu)[stress::zz] ==
          Approx(-3 / (18 * std::numbers::pi)).epsilon(4 * epsilon));
}

// 16 × 16 points over the rectangle, of which a half side is at most a third of the distance: they converge
// as (3 + √8)^-32 = 1e-24. Nothing cancels; the sum of 256 terms leaves less than 1e-14.
TEST_CASE("at any distance the stress under a rectangle keeps twelve digits of its largest component",
          "[influence][exact]") {
  static const auto rule = gauss_legendre(16);
  const Field points = random_field({40, 5}, 17);
  for (stress::Traction load : {stress::normal, stress::shear_x, stress::shear_y})
    for (double distance : {3.0, 4.99, 5.0, 12.0, 49.0, 51.0, 1e3, 1e6}) {
      double error = 0;
      for (Index k = 0; k < points.rows(); ++k) {
        const double a = 1, b = std::exp(-1 + points(k, 0)), nu = 0.25 * (1 + points(k, 1));
        const double u = 0.5 * (1 + points(k, 2)), angle = std::numbers::pi * points(k, 3);
        const double beside = distance * std::sqrt(1 - u * u), z = distance * u;
        const double x = beside * std::cos(angle), y = beside * std::sin(angle);
        Tensor sum{};
        for (auto [v, weight_v] : rule)
          for (auto [w, weight_w] : rule) {
            const Tensor s = point_load_stress(x - a * v, y - b * w, z, nu, load);
            for (auto c : stress::components) sum[c] += weight_v * weight_w * a * b * s[c];
          }
        error = std::max(error, difference(uniform_load_stress(x, y, z, a, b, nu, load), sum) / largest(sum));
      }
      CAPTURE(load, distance);
      CHECK(error <= 1e-12);
    }
}
