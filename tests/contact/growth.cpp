#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

// A surface that shows new asperities on every finer grid takes hardly more convolutions on it. Counts are those
// of ε = 1e-8, measured 18.6 and 19.8 at 256², 17.2 and 16.8 at 512²; bare conjugate gradients on each set,
// clipped, take 21.1 and 25.3, 34.0 and 49.7.
TEST_CASE("spheres of exponential roughness take no more than 21 convolutions at 256², and as many at 512²",
          "[contact][law]") {
  for (Index n : {256, 512})
    for (double cap : {infinity, limit}) {
      const Grid grid = square(n);
      const Field rough = 0.4e-6 * exponential_heights(grid.shape, static_cast<double>(n) / 20, 3);
      const Contact contact = press(grid, undeformed_gap(grid, spheres) - rough, {.limit_pressure = cap});
      CAPTURE(n, cap, contact.convolutions, contact.preconditionings);
      CHECK(contact.residual <= 1e-8);
      CHECK(contact.convolutions <= 21);
      CHECK(contact.preconditionings < contact.convolutions);
    }
}

// 2^18 cells are the fewest that threads share.
TEST_CASE("a ragged contact does not depend on the number of threads", "[contact][law][slow]") {
  const Grid grid = periodic({{576, 512}, 1e-6, 1e-6});
  const Field gap = -1e-6 * exponential_heights(grid.shape, 30, 4);
  const double q = 2e8 * grid.size_x() * grid.size_y();
  const Contact one = press(grid, gap, {.load = q, .threads = 1}),
                three = press(grid, gap, {.load = q, .threads = 3});
  CHECK((one.pressure == three.pressure).all());
  CHECK(one.convolutions == three.convolutions);
}

TEST_CASE("a ragged contact sunk by the approach of its load has that load", "[contact][law][slow]") {
  const Grid grid = square(256);
  const Field gap = undeformed_gap(grid, spheres) - 0.4e-6 * exponential_heights(grid.shape, 13, 5);
  for (double cap : {infinity, limit}) {
    const Contact loaded = press(grid, gap, {.limit_pressure = cap});
    const Contact sunk = solve_contact(
        grid, gap, modulus, {.approach = loaded.approach, .limit_pressure = cap, .tolerance = 1e-8});
    CHECK(sunk.converged);
    CHECK(relative_error(sunk.load, loaded.load) <= 1e-6);
    CHECK((sunk.pressure - loaded.pressure).abs().maxCoeff() <= 1e-5 * loaded.max_pressure);
  }
}
