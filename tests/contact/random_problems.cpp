#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

struct Draw {
  std::mt19937_64 generator;
  double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(generator); }
  double decade(double a, double b) { return std::pow(10, uniform(a, b)); }
};

}  // namespace

// Cells of aspect 0.02 to 50, roughness of 10 nm to 10 µm on spheres or flats, loads of 0.01 N to 50 kN, half
// of them with a limit pressure from just above the mean to ten times it, every sixth periodic.
TEST_CASE("forty random problems end at a residual of 1e-8 within their bounds and loads", "[contact][law]") {
  Draw draw{std::mt19937_64(11)};
  for (unsigned k = 0; k < 40; ++k) {
    const Shape shape{k % 3 == 2 ? 64 : 32, k % 5 == 0 ? 32 : k % 7 == 0 ? 45 : 64};
    const double dx = 3e-3 / static_cast<double>(shape.nx), aspect = k % 4 == 1 ? draw.decade(-1.7, 1.7) : 1;
    const Grid grid{shape, dx, dx * aspect, k % 6 == 5};
    const double curvature = grid.periodic || k % 5 == 1 ? 0 : 1 / draw.decade(-2.5, 0),
                 rms = draw.decade(-8, -5);
    const Field round = sample(grid, [&](double x, double y) { return curvature / 2 * (x * x + y * y); });
    const Field gap = round - rms * random_waves(shape, 100 + k);
    ContactParameters parameters{.load = draw.decade(-2, 4.7), .tolerance = 1e-8};
    if (draw.uniform(0, 1) < 0.6)
      parameters.limit_pressure =
          parameters.load / (grid.size_x() * grid.size_y()) * (1 + draw.decade(-3, 1));
    const Contact contact = solve_contact(grid, gap, modulus, parameters);
    CAPTURE(k, shape.nx, shape.ny, aspect, grid.periodic, rms, curvature, parameters.load,
            parameters.limit_pressure, contact.convolutions, contact.reason, contact.residual);
    CHECK(contact.residual <= 1e-8);
    CHECK(contact.load_error <= 1e-12);
    CHECK(contact.pressure.minCoeff() >= 0);
    CHECK(contact.pressure.maxCoeff() <= parameters.limit_pressure);
    CHECK(contact.convolutions <= 400);
  }
}
