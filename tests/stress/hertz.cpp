#include <numbers>

#include "reference.hpp"
#include "reference/hertz_stress.hpp"
#include "stress/equivalent.hpp"
#include "stress/influence.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;
using stress::Tensor;

namespace {

// The point load integrated over the Hertz pressure: r = sin t, 64 Gauss points by 128 around.
Tensor integrated(double x, double y, double z, double nu, stress::Traction traction) {
  constexpr double half = std::numbers::pi / 4;
  constexpr int around = 128;
  Tensor sum{};
  for (auto [u, weight] : gauss_legendre(64)) {
    const double t = half * (1 + u), r = std::sin(t), load = weight * half * std::cos(t) * std::cos(t) * r;
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * std::numbers::pi * k / around;
      const Tensor s = point_load_stress(x - r * std::cos(angle), y - r * std::sin(angle), z, nu, traction);
      for (auto c : stress::components) sum[c] += load * 2 * std::numbers::pi / around * s[c];
    }
  }
  return sum;
}

}  // namespace

// Around the circle the integrand is analytic in a strip of half-width ln(ρ+√(ρ²-1)) ≥ asinh(z) = 0.39 at z =
// 0.4: 128 points leave exp(-128 · 0.39) = 2e-22. What is left is round-off of 8192 terms.
TEST_CASE("Huber's field and the sliding contact's are point loads integrated over the Hertz pressure",
          "[hertz][exact]") {
  for (double nu : {-0.9, 0.0, 0.3, 0.5})
    for (auto [x, y, z] : {std::array{0.0, 0.0, 0.5}, std::array{0.3, -0.2, 0.4}, std::array{0.9, 0.5, 0.6},
                           std::array{-1.5, 2.0, 1.0}, std::array{0.1, 0.0, 4.0}}) {
      for (auto load : stress::tractions) {
        const Tensor closed = hertz_stress(x, y, z, nu, load), sum = integrated(x, y, z, nu, load);
        CAPTURE(x, y, z, nu, load);
        for (auto c : stress::components) CHECK(std::abs(closed[c] - sum[c]) <= 1e-13);
      }
    }
}

TEST_CASE("on the surface Huber's field is the pressure, hydrostatic-like inside and pure shear outside",
          "[hertz][exact]") {
  const double nu = 0.3;
  const Tensor centre = hertz_stress(0, 0, 0, nu), edge = hertz_stress(1, 0, 0, nu),
               outside = hertz_stress(2, 0, 0, nu);
  CHECK(centre[stress::zz] == Approx(-1).epsilon(4 * epsilon));
  CHECK(centre[stress::xx] == Approx(-(0.5 + nu)).epsilon(4 * epsilon));
  CHECK(edge[stress::xx] == Approx((1 - 2 * nu) / 3).epsilon(4 * epsilon));
  CHECK(edge[stress::yy] == Approx(-(1 - 2 * nu) / 3).epsilon(4 * epsilon));
  CHECK(outside[stress::xx] == Approx((1 - 2 * nu) / 3 / 4).epsilon(4 * epsilon));
  CHECK(outside[stress::zz] == 0);
  for (double r : {0.2, 0.6, 0.99})
    CHECK(hertz_stress(0, r, 0, nu)[stress::zz] == Approx(-std::sqrt(1 - r * r)).epsilon(64 * epsilon));
}

// Cancellation of terms of the order of one, twice: 64 ε. At r = 1 itself, and at a depth of ε² of it, R
// loses half its digits.
TEST_CASE("on the surface of a sliding Hertz contact the stress is linear in x and y", "[hertz][exact]") {
  constexpr double pi = std::numbers::pi;
  for (double nu : {-0.9, 0.0, 0.3, 0.5})
    for (auto [x, y] :
         {std::array{0.0, 0.0}, std::array{0.5, -0.3}, std::array{-0.7, 0.6}, std::array{-0.1, 0.9}}) {
      const Tensor s = hertz_stress(x, y, 0, nu, stress::shear_x);
      CAPTURE(x, y, nu);
      CHECK(std::abs(s[stress::xx] + (4 + nu) * pi * x / 8) <= 64 * epsilon);
      CHECK(std::abs(s[stress::yy] + 3 * nu * pi * x / 8) <= 64 * epsilon);
      CHECK(std::abs(s[stress::xy] + (2 - nu) * pi * y / 8) <= 64 * epsilon);
      CHECK(std::abs(s[stress::xz] + std::sqrt(1 - x * x - y * y)) <= 64 * epsilon);
      CHECK(s[stress::zz] == 0);
      CHECK(s[stress::yz] == 0);
    }
}

TEST_CASE("on the surface outside a sliding contact nothing acts", "[hertz][exact]") {
  for (auto [x, y] : {std::array{1.2, 0.4}, std::array{-3.0, 1.0}}) {
    const Tensor s = hertz_stress(x, y, 0, 0.3, stress::shear_x);
    for (auto c : {stress::zz, stress::xz, stress::yz}) CHECK(std::abs(s[c]) <= 16 * epsilon);
  }
}

// σ_vM is flat at its maximum: places are given to 5e-5, of which it keeps (5e-5)² times its curvature, about
// 2.
TEST_CASE("friction raises the largest von Mises stress of a Hertz contact and moves it forward and up",
          "[hertz][exact]") {
  struct Row {
    double mu, value, x, z;
  };
  for (const Row& row : {Row{0, 0.620041, 0, 0.480864}, Row{0.1, 0.62444, 0.1116, 0.4749},
                         Row{0.2, 0.63766, 0.2192, 0.4571}, Row{0.25, 0.64759, 0.2703, 0.4440},
                         Row{0.3, 0.65976, 0.3188, 0.4282}, Row{0.4, 0.69094, 0.4052, 0.3883}}) {
    auto at = [&](double dx, double dz) {
      return von_mises(hertz_stress(row.x + dx, 0, row.z + dz, 0.3, Friction{row.mu, 0}));
    };
    CAPTURE(row.mu, at(0, 0));
    CHECK(std::abs(at(0, 0) - row.value) <= 6e-6);
    for (auto [dx, dz] :
         {std::array{1e-3, 0.0}, std::array{-1e-3, 0.0}, std::array{0.0, 1e-3}, std::array{0.0, -1e-3}})
      CHECK(at(dx, dz) < at(0, 0));
  }
}

// A mean is a difference of four loads, each to ε; divided by the area of the cell and summed with it they
// cancel.
TEST_CASE("the mean pressures of the cells carry the load of the Hertz contact", "[hertz][exact]") {
  for (Shape shape : {Shape{16, 16}, Shape{31, 20}, Shape{128, 128}}) {
    const Grid grid{shape, 3.0 / static_cast<double>(shape.nx), 2.5 / static_cast<double>(shape.ny)};
    CAPTURE(shape.nx, shape.ny);
    const double bound = 4 * epsilon * static_cast<double>(shape.cells());
    CHECK(std::abs(hertz_pressure(grid).sum() * grid.cell_area() - 2 * std::numbers::pi / 3) <= bound);
  }
}

// A cell's mean is the value at its centre plus h²/24 ∇²p; where r < 0.8, |∇²p| ≤ (2-r²)/(1-r²)^1.5 ≤ 6.3.
TEST_CASE("inside the contact the mean of a cell is the pressure, at order 2", "[hertz][order]") {
  auto error = [](Index n) {
    const Grid grid{{n, n}, 3.0 / static_cast<double>(n), 3.0 / static_cast<double>(n)};
    const Field exact =
        sample(grid, [](double x, double y) { return std::sqrt(std::max(0.0, 1 - x * x - y * y)); });
    const Field inside = sample(grid, [](double x, double y) { return std::hypot(x, y) < 0.8 ? 1.0 : 0.0; });
    return ((hertz_pressure(grid) - exact).abs() * inside).maxCoeff() / (grid.dx * grid.dx / 24);
  };
  CHECK(error(64) <= 6.5);
  CHECK(error(128) / error(64) == Approx(1).margin(0.1));
}
