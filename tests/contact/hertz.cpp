// The closed forms of lib/contact/bodies.hpp against their textbook form, their limits, and solved contacts.
#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const Bodies barrel{.radius = {Radii(25e-3, 25e-3 / 6), Radii()}};

void check_same(const Hertz& one, const Hertz& other, double tolerance) {
  CHECK(relative_error(one.radius_x, other.radius_x) <= tolerance);
  CHECK(relative_error(one.radius_y, other.radius_y) <= tolerance);
  CHECK(relative_error(one.radius, other.radius) <= tolerance);
  CHECK(relative_error(one.pressure, other.pressure) <= tolerance);
  CHECK(relative_error(one.approach, other.approach) <= tolerance);
}

// K and E of the complementary modulus k by the arithmetic-geometric mean: K = π/2a, E = K (1 - Σ 2ⁱ⁻¹ cᵢ²).
std::pair<long double, long double> complete_elliptic_integrals(long double k) {
  long double a = 1, b = k, power = 0.5L, sum = power * (1 - k * k);
  for (int i = 0; i < 8; ++i) {
    const long double c = (a - b) / 2, mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
    power *= 2;
    sum += power * c * c;
  }
  const long double K = std::numbers::pi_v<long double> / (2 * a);
  return {K, K * (1 - sum)};
}

}  // namespace

TEST_CASE("Rx = 25 mm, Ry = 25/6 mm under 1 kN meet 3143.319 MPa, 0.7026656 x 0.2161744 mm and 15.48254 um",
          "[hertz][exact]") {
  const Hertz ellipse = hertz(barrel, 1000);
  CHECK(ellipse.radius_x == Approx(0.7026656e-3).epsilon(1e-7));
  CHECK(ellipse.radius_y == Approx(0.2161744e-3).epsilon(3e-7));
  CHECK(ellipse.pressure == Approx(3143.319e6).epsilon(2e-7));
  CHECK(ellipse.approach == Approx(15.48254e-6).epsilon(4e-7));
}

// In long double the textbook forms' cancellation, (ε/2048)/k² here, is below the ε that k itself leaves;
// each quantity varies with some power of k up to 2.
TEST_CASE("the semi-axes satisfy the equations with complete elliptic integrals", "[hertz][exact]") {
  for (const double ratio : {2.0, 6.0, 100.0, 1e4}) {
    const double A = 20, B = ratio * A, Q = 1000, bound = 20 * epsilon;
    const Hertz h = hertz({.radius = {Radii(1 / (2 * A), 1 / (2 * B)), Radii()}}, Q);
    const double a = h.radius_x, b = h.radius_y;
    const long double k = b / static_cast<long double>(a), m = 1 - k * k;
    const auto [K, E] = complete_elliptic_integrals(k);
    CAPTURE(ratio, k);
    CHECK(std::abs((E / (k * k) - K) / (K - E) / ratio - 1) <= bound);
    CHECK(std::abs(3 * Q * (K - E) / (2 * pi * modulus * m * A) / (a * a * a) - 1) <= bound);
    CHECK(relative_error(h.pressure, 3 * Q / (2 * pi * a * b)) <= bound);
    CHECK(std::abs(h.pressure * b * K / modulus / h.approach - 1) <= bound);
  }
}

TEST_CASE("the ellipse of equal radii is the sphere's circle to round-off", "[hertz][exact]") {
  const double R = 25e-3, a = std::cbrt(0.75 * load * R / modulus);
  const Hertz circle{a, 1.5 * load / (pi * a * a), a * a / R, a, a};
  check_same(hertz(spheres, load), circle, 10 * epsilon);
  check_same(hertz({.radius = {Radii(R), Radii()}}, load), circle, 10 * epsilon);
  check_same(hertz({.radius = {Radii(R, INFINITY), Radii(INFINITY, R)}}, load), circle, 10 * epsilon);
}

// Curvatures (1 ± t)/R leave √(ab), p₀ and δ as they are but for O(t²), and stretch the axes by ∓ ⅔ t:
// a ratio B/A = 1 + 2t has k = 1 - 4t/3. Textbook forms would leave ε/t ~ 1e-7 of them.
TEST_CASE("a nearly circular ellipse is the circle's first perturbation", "[hertz][law]") {
  const double t = 1e-9, R = 25e-3;
  const Hertz circle = hertz(spheres, load),
              ellipse = hertz({.radius = {Radii(R / (1 - t), R / (1 + t)), Radii()}}, load);
  CHECK(relative_error(ellipse.radius, circle.radius) <= 20 * epsilon);
  CHECK(relative_error(ellipse.pressure, circle.pressure) <= 20 * epsilon);
  CHECK(relative_error(ellipse.approach, circle.approach) <= 20 * epsilon);
  CHECK(ellipse.radius_x / circle.radius - 1 == Approx(2 * t / 3).epsilon(1e-6));
  CHECK(1 - ellipse.radius_y / circle.radius == Approx(2 * t / 3).epsilon(1e-6));
}

TEST_CASE("x and y change places with the radii", "[hertz][law]") {
  const Bodies turned{.radius = {Radii(barrel.radius[0].y, barrel.radius[0].x), Radii()}};
  Hertz there = hertz(turned, 1000);
  std::swap(there.radius_x, there.radius_y);
  check_same(hertz(barrel, 1000), there, 0);
}

// The middle cells' centres are half a cell off both axes: p falls by s/8, s = Δx²/a² + Δy²/b², of which
// collocation gives a part back. The approach errs by less, 0.014…0.022 s, as the cells happen to cut the
// edge.
TEST_CASE("a solved elliptic contact meets Hertz's pressure and approach at order 2 with their constants",
          "[hertz][order]") {
  const double Q = 1000;
  const Hertz exact = hertz(barrel, Q);
  double coarsest = 1;
  for (Index n : {32, 64, 128}) {
    const double cells = static_cast<double>(n);
    const Grid grid{{n, n}, 2.5 * exact.radius_x / cells, 2.5 * exact.radius_y / cells};
    const Contact contact = press(grid, undeformed_gap(grid, barrel), {.load = Q});
    const double pressure = 1 - contact.max_pressure / exact.pressure;
    const double approach = relative_error(contact.approach, exact.approach);
    const double s = std::pow(grid.dx / exact.radius_x, 2) + std::pow(grid.dy / exact.radius_y, 2);
    CAPTURE(n, s, pressure, approach);
    CHECK(pressure <= s / 8);
    CHECK(pressure >= 0.75 * s / 8);
    CHECK(approach <= 0.03 * s);
    if (n == 32) coarsest = approach;
    if (n == 128) CHECK(observed_order(coarsest, approach) / 2 == Approx(2).margin(0.15));
  }
}

// Cylinders side by side at a period L: between them cot(πx/L) = L/πx - πx/3L - … takes the place of 1/x,
// which is a curvature of 1/R (1 + π²b²/6L²) but for O((b/L)⁴) = 2e-5. The middle cells are half a cell off
// the axis, where p has fallen by ⅛ (Δx/b)²; the edges, which lie anywhere in a cell, add or take away some
// half of that.
TEST_CASE("cylinders of a period of ten contact widths meet Hertz's line contact, at order 2",
          "[hertz][order]") {
  const double length = 1e-3, R = 10e-3, b = length / 20, q = pi * modulus * b * b / (4 * R);
  CHECK(hertz_line(modulus, 1 / R, q).half_width == Approx(b).epsilon(1e-14));
  const HertzLine exact = hertz_line(modulus, (1 + std::pow(pi * b / length, 2) / 6) / R, q);
  for (Index n : {128, 256, 512}) {
    const double cell = length / static_cast<double>(n);
    const Grid grid{{n, 4}, cell, cell, true};
    const Contact contact = press(grid, undeformed_gap(grid, {.radius = {Radii(R, INFINITY), Radii()}}),
                                  {.load = q * grid.size_y()});
    const double error = relative_error(contact.max_pressure, exact.pressure);
    CAPTURE(n, error);
    CHECK(error <= 0.2 * std::pow(cell / b, 2));
    CHECK(error >= 0.05 * std::pow(cell / b, 2));
  }
}

TEST_CASE("a ball in a groove has the difference of their curvatures, and none in a narrower one",
          "[hertz][contract]") {
  const Bodies groove{.radius = {Radii(5e-3), Radii(INFINITY, -6e-3)}};
  groove.check();
  CHECK(groove.curvature_x() == 1 / 5e-3);
  CHECK(groove.curvature_y() == Approx(1 / 5e-3 - 1 / 6e-3).epsilon(4 * epsilon));
  auto refused = [](const Bodies& bodies) { return refusal([&] { bodies.check(); }); };
  CHECK(refused({.radius = {Radii(5e-3), Radii(INFINITY, -4e-3)}}).starts_with("radius-y: "));
  CHECK(refused({.radius = {Radii(5e-3), Radii(-4e-3)}}).starts_with("radius: "));
  CHECK(refused({.radius = {Radii(0, 1), Radii()}}).starts_with("radius-x: "));
  CHECK(refused({.radius = {Radii(1, NAN), Radii()}}).starts_with("radius-y: "));
}

// GSL's handler stands in these tests as in a user's program: outside the domain of R_D, or where a bracket
// has lost its sign, it aborts the process. A cylinder did.
TEST_CASE("bodies without a contact in a point are refused in one line and nothing is aborted",
          "[hertz][contract]") {
  auto refused = [](const Bodies& bodies, double q) { return refusal([&] { hertz(bodies, q); }); };
  const Radii none[] = {
      {50e-3, infinity}, {infinity, 50e-3}, {infinity, infinity}, {1e-160, 1e160}, {1e-310, 1}};
  for (const Radii& radii : none) {
    CAPTURE(radii.x, radii.y);
    CHECK_FALSE(has_point_contact({.radius = {radii, Radii()}}));
    CHECK(refused({.radius = {radii, Radii()}}, 1000).starts_with("radius: "));
  }
  CHECK(refused({.radius = {Radii(50e-3), Radii(-50e-3)}}, 1000).starts_with("radius: "));
  CHECK(refused({.radius = {Radii(0, 1), Radii()}}, 1000).starts_with("radius-x: "));
  for (double q : {0.0, -1.0, infinity, std::nan("")}) CHECK(refused(spheres, q).starts_with("load: "));
}

// For k → 0 (1) is B/A = 1/(k² (ln 4/k - 1)) but for k² ln k.
TEST_CASE("ratios of radii over 24 decades have the narrow ellipse's axes", "[hertz][exact]") {
  for (double ratio : {1e8, 1e12, 1e24, 1e99}) {
    const Hertz h = hertz({.radius = {Radii(1e12, 1e12 / ratio), Radii()}}, 1);
    const double k = h.radius_y / h.radius_x, narrow = 1 / (k * k * (std::log(4 / k) - 1));
    CAPTURE(ratio, k);
    CHECK(relative_error(narrow, ratio) <= k * k * std::log(4 / k) * 3 + 1e3 * epsilon);
    const Hertz turned = hertz({.radius = {Radii(1e12 / ratio, 1e12), Radii()}}, 1);
    CHECK(turned.radius_x == h.radius_y);
    CHECK(turned.approach == h.approach);
  }
}

// Curvatures that are equal but for round-off: the mismatch has no sign left to bracket.
TEST_CASE("radii that differ by round-off are a sphere's", "[hertz][exact]") {
  const Hertz sphere = hertz(spheres, 1000);
  for (int i = -20; i <= 20; ++i) {
    const Radii radii(25e-3, 25e-3 * (1 + i * epsilon));
    check_same(hertz({.radius = {radii, Radii()}}, 1000), sphere, 40 * epsilon);
  }
}
