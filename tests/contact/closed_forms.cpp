#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

TEST_CASE("two steel spheres under 5000 N meet Hertz's 2724.3224 MPa, 0.9361090 mm and 35.052006 um",
          "[hertz][exact]") {
  const Hertz smooth = hertz(spheres, load);
  CHECK(smooth.pressure == Approx(2724.3224e6).epsilon(2e-8));
  CHECK(smooth.radius == Approx(0.9361090e-3).epsilon(1e-7));
  CHECK(smooth.approach == Approx(35.052006e-6).epsilon(2e-8));
}

// The four middle cells have their centres Δx/√2 off the axis, where Hertz's ellipse has fallen by Δx²/4a².
// Collocation gives back between 0 and a quarter of that (it tends to 0.17). The approach converges as
// 0.045…0.056 (Δx/a)².
TEST_CASE("Hertz's maximum pressure and approach converge at order 2 with their constants",
          "[hertz][order]") {
  const Hertz exact = hertz(spheres, load);
  double coarse = 1;
  for (Index n : {32, 64, 128}) {
    const Grid grid = square(n);
    const Contact contact = press(grid, undeformed_gap(grid, spheres));
    const double cell = std::pow(grid.dx / exact.radius, 2);
    const double error = 1 - contact.max_pressure / exact.pressure;
    CAPTURE(n, error, coarse, contact.approach);
    CHECK(error <= cell / 4);
    CHECK(error >= 0.75 * cell / 4);
    if (n > 32) CHECK(observed_order(coarse, error) == Approx(2).margin(0.15));
    CHECK(relative_error(contact.approach, exact.approach) <= 0.06 * cell);
    CHECK(contact.residual <= 1e-8);
    CHECK(contact.load_residual <= 1e-12);
    coarse = error;
  }
}

TEST_CASE("at 128 x 128 Hertz's pressure is met to 1.4e-4, the approach to 3.3e-5 and the radius to 3e-4",
          "[hertz][order]") {
  const Grid grid = square(128);
  const Contact contact = press(grid, undeformed_gap(grid, spheres));
  const Hertz exact = hertz(spheres, load);
  CHECK(relative_error(contact.max_pressure, exact.pressure) <= 1.4e-4);
  CHECK(relative_error(contact.approach, exact.approach) <= 3.3e-5);
  // Hertz's ellipsoid has ⟨r²⟩ = 2a²/5 under the pressure.
  const Field r2 = sample(grid, [](double x, double y) { return x * x + y * y; });
  const double radius = std::sqrt(2.5 * (r2 * contact.pressure).sum() / contact.pressure.sum());
  CHECK(relative_error(radius, exact.radius) <= 3e-4);
  // The area counts cells on a circle: they scatter by the cells that its edge cuts, about 8a/Δx, to the
  // power ½.
  const double area = pi * exact.radius * exact.radius, cut = 8 * exact.radius / grid.dx;
  CHECK(std::abs(contact.area - area) <= 2 * std::sqrt(cut) * grid.cell_area());
}

// Cells make a staircase of the circle; the radius of equal area is off by a part of Δx, relative Δx/a =
// 0.03.
TEST_CASE("a rigid flat punch sinks in by Q/(2aE*) as far as cells make a circle", "[punch][exact]") {
  const Grid grid = square(128);
  const double a = 0.8e-3;
  const Contact contact =
      press(grid, sample(grid, [&](double x, double y) { return std::hypot(x, y) <= a ? 0 : 1e-3; }));
  CHECK(relative_error(contact.approach, load / (2 * a * modulus)) <= 0.2 * grid.dx / a);
}

// A uniform displacement of a square is the potential of a charged square plate, whose capacity is 0.36678962
// s (side s, Gaussian units): δ = Q/(π 0.36678962 s E*). The edges are singular: order 1 in the number of
// cells a side.
TEST_CASE("flats that touch on the whole domain form a square punch, at order 1", "[punch][order]") {
  double coarse = 1;
  for (Index n : {32, 64}) {
    const Grid grid = square(n);
    const Contact contact = press(grid, Field::Zero(n, n));
    const double exact = load / (pi * 0.36678962 * grid.size_x() * modulus);
    const double error = relative_error(contact.approach, exact);
    CAPTURE(n, error, coarse);
    CHECK(contact.displacement.maxCoeff() - contact.displacement.minCoeff() <= 1e-8 * contact.approach);
    CHECK(error <= 0.4 / static_cast<double>(n));
    if (n > 32) CHECK(observed_order(coarse, error) == Approx(1).margin(0.1));
    coarse = error;
  }
}

namespace {

// Westergaard's wavy surface h = D (1 - cos 2πx/L), p* = π E* D/L, on n × 4 cells of one period.
struct Westergaard {
  explicit Westergaard(Index n)
      : grid{{n, 4}, length / static_cast<double>(n), length / static_cast<double>(n), true} {}
  static constexpr double length = 1e-3, depth = 1e-6;
  const double full = pi * modulus * depth / length;
  Grid grid;

  Contact press_to(double mean) const {
    const Field gap =
        sample(grid, [](double x, double) { return depth * (1 - std::cos(2 * pi * x / length)); });
    return press(grid, gap, {.load = mean * grid.size_x() * grid.size_y(), .tolerance = 1e-12});
  }
};

}  // namespace

// Where everything touches the problem is linear and solved by the preconditioner.
TEST_CASE("a wavy surface in full contact carries the mean pressure plus p* cos(2 pi x/L)",
          "[westergaard][exact]") {
  const Westergaard wave(64);
  const double mean = 1.5 * wave.full;
  const Contact contact = wave.press_to(mean);
  const Field exact = sample(wave.grid, [&](double x, double) {
    return mean + wave.full * std::cos(2 * pi * x / Westergaard::length);
  });
  CHECK((contact.pressure - exact).abs().maxCoeff() <= 1e-13 * mean);
  CHECK(contact.area == Approx(wave.grid.size_x() * wave.grid.size_y()));
}

// p = 2p* cos(πx/L) √(sin²(πa/L) - sin²(πx/L)), mean p* sin²(πa/L). The pressure has a root at the edge: its
// error in the mean is of order 1, at most 0.12 Δx/a, and less by where in its cell the edge lies.
TEST_CASE("a wavy surface in partial contact meets Westergaard's pressure, at order 1 in the mean",
          "[westergaard][order]") {
  const double share = 0.3, sine2 = share,
               half_width = std::asin(std::sqrt(sine2)) / pi * Westergaard::length;
  for (Index n : {64, 90, 128, 180, 256}) {
    const Westergaard wave(n);
    const Contact contact = wave.press_to(share * wave.full);
    const Field exact = sample(wave.grid, [&](double x, double) {
      const double s = std::sin(pi * x / Westergaard::length);
      return 2 * wave.full * std::cos(pi * x / Westergaard::length) * std::sqrt(std::max(0.0, sine2 - s * s));
    });
    const double error = std::sqrt((contact.pressure - exact).square().mean() / exact.square().mean());
    CAPTURE(n, error * half_width / wave.grid.dx);
    CHECK(error <= 0.12 * wave.grid.dx / half_width);
    CHECK(std::abs(contact.area / wave.grid.size_y() - 2 * half_width) <= 2 * wave.grid.dx);
  }
}
