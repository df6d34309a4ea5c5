// The stated errors of a largest stress against closed forms: Hertz, and Hertz sliding.
#include "stress/maximum_error.hpp"

#include "contact/bodies.hpp"
#include "contact/grid_error.hpp"
#include "contact/hertz.hpp"
#include "contact/influence.hpp"
#include "core/calibration.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const Bodies spheres{.radius = {50e-3, 50e-3}};
constexpr double load = 5000;

struct Judged {
  StressMaximum value, error;
};

Judged judged(Index n, double friction) {
  const double step = 3e-3 / static_cast<double>(n);
  const Grid grid{{n, n}, step, step};
  const Field gap = undeformed_gap(grid, spheres);
  const auto influence = make_influence(grid, spheres.composite_modulus());
  const ContactParameters parameters{.load = load, .tolerance = 1e-8};
  const Contact contact = solve_contact(grid, gap, *influence, parameters);
  const CoarserContacts coarser = coarser_contacts(grid, gap, *influence, contact, parameters, spheres);
  REQUIRE(coarser.unknown.empty());
  auto body = [friction](const Grid& cells, const Contact& c) {
    return LoadedBody{cells, c.pressure, 0.3, {friction, 0}};
  };
  auto top = [&](const Grid& cells, const Contact& c) {
    return maximum_stress(StressSolver(body(cells, c)));
  };
  const StressMaximum here = top(grid, contact);
  return {here, maximum_error(body(grid, contact),
                              {here, top(coarser.grid[0], coarser.contact[0]),
                               top(coarser.grid[1], coarser.contact[1])},
                              {}, false)};
}

}  // namespace

// On the axis the stress is that of Johnson (1985), (3.45): von Mises is |σz - σr|.
TEST_CASE("below Hertz the largest von Mises stress and its depth lie within their errors", "[stress][law]") {
  const Hertz exact = hertz(spheres, load);
  double top = 0, deep = 0;
  for (double z = 0.3; z < 0.7; z += 1e-5) {
    const double value = 1.5 / (1 + z * z) - 1.3 * (1 - z * std::atan(1 / z));
    if (value > top) top = value, deep = z;
  }
  for (Index n : {64, 96, 128}) {
    CAPTURE(n);
    const auto [value, error] = judged(n, 0);
    CHECK(std::abs(value.value - top * exact.pressure) <= error.value);
    CHECK(std::abs(value.depth - deep * exact.radius) <= error.depth);
    // 0.95/n² of the value with n cells across (tests/stress/hertz.cpp), and no more than thirty times that.
    const double across = 2 * exact.radius / (3e-3 / static_cast<double>(n));
    CHECK(error.value <= 30 * 0.95 / (across * across) * value.value);
  }
}

// Below the surface; depths of the closed field (Hamilton 1983) to four digits, as in maximum.cpp.
TEST_CASE("the depth of a sliding contact's largest stress lies within its error", "[stress][law]") {
  const Hertz exact = hertz(spheres, load);
  for (const auto& [friction, depth] : {std::pair{0.1, 0.4749}, std::pair{0.2, 0.4571}})
    for (Index n : {64, 96, 128}) {
      CAPTURE(friction, n);
      const auto [value, error] = judged(n, friction);
      CHECK(std::abs(value.depth - depth * exact.radius) <= error.depth);
      CHECK(error.depth <= 0.02 * value.depth);
    }
}

// Hamilton (1983), √J2 = 0.4646 p0 and 0.5523 p0 at the trailing edge for μ = 0.4 and 0.5, ν = 0.3; von Mises is
// √3 of it.
// Coarse cells find a maximum in the depth instead (stress/edge.hpp).
TEST_CASE("a sliding contact's largest stress at the edge lies within its error", "[stress][law]") {
  const Hertz exact = hertz(spheres, load);
  const std::pair<double, double> published[] = {{0.4, 0.4646}, {0.5, 0.5523}};
  for (const auto& [friction, root_of_j2] : published)
    for (Index n : {64, 96, 128}) {
      CAPTURE(friction, n);
      const auto [value, error] = judged(n, friction);
      CHECK(std::abs(value.value - std::sqrt(3.0) * root_of_j2 * exact.pressure) <= error.value);
      CHECK(error.value <= 0.5 * value.value);
    }
}

TEST_CASE("near the surface of a contact at its limit pressure the error says so", "[stress][exact]") {
  const LoadedBody body{{{64, 64}, 1e-6, 2e-6, true}, Field::Ones(64, 64), 0.3, {}};
  const StressMaximum fine{1e9, 0, 0, 1.5e-6, 0}, half{1.1e9, 0, 0, 2e-6, 0}, far{1e9, 0, 0, 9e-6, 0};
  const StressMaximum plain = maximum_error(body, {fine, half, half}, {}, false),
                      capped = maximum_error(body, {fine, half, half}, {}, true);
  CHECK(plain.value == Approx(0.28 * 0.1e9));
  CHECK(plain.depth == Approx(0.275 * std::sqrt(1.5) * 0.5e-6));
  CHECK(maximum_error(body, {fine, half, far}, {}, false).depth ==
        Approx(0.275 * std::sqrt(1.5) * 0.1 * 7e-6));
  CHECK(capped.value == Approx(plain.value + 0.1e9));
  CHECK(capped.depth == Approx(0.41 * std::sqrt(1.5) * 0.5e-6 + 1.5e-6));
  // A maximum in the depth that all grids tell alike has the error of the search.
  const StressMaximum deep{1e9, 0, 0, 1e-3, 0};
  CHECK(maximum_error(body, {deep, deep, deep}, {}, false).value == Approx(2e-5 * 1e9));
  CHECK(maximum_error(body, {deep, deep, deep}, {}, false).depth == Approx(5e-4 * 1e-3));
  // Between the surface and the first layer, a quarter of a cell deep, nothing is looked at.
  const StressMaximum top{1e9, 0, 0, 0, 0};
  CHECK(maximum_error(body, {top, top, top}, {.below = 1e-9}, false).depth == Approx(0.25e-6));
  // Level maxima still have the error of single cells.
  CHECK(maximum_error(body, {fine, fine, fine}, {}, false).value == Approx(0.03 * 1e9 / (1.5 * 1.5)));
}
