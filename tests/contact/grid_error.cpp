// The stated errors of the grid against the true ones: Hertz, and the same surface on finer cells.
#include "contact/grid_error.hpp"

#include "contact/energy.hpp"
#include "contact/outline.hpp"
#include "contact/scenes.hpp"
#include "core/halved.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

struct Judged {
  Contact contact;
  GridErrors errors;
  double corrected = 0, energy = 0;
};

Judged judged(const Grid& grid, const Field& gap, ContactParameters parameters, const Bodies& bodies) {
  const auto influence = make_influence(grid, bodies.composite_modulus());
  parameters.tolerance = 1e-8;
  Judged out{.contact = solve_contact(grid, gap, *influence, parameters), .errors = {}};
  const CoarserContacts coarser = coarser_contacts(grid, gap, *influence, out.contact, parameters, bodies);
  REQUIRE(coarser.unknown.empty());
  out.errors = grid_errors(grid, out.contact, coarser);
  out.energy = elastic_energy(grid, out.contact);
  out.corrected = corrected_area(grid, out.contact, outline(grid, out.contact));
  return out;
}

}  // namespace

TEST_CASE("Hertz's figures lie within the stated errors, which fall with the grid", "[contact][law]") {
  const Hertz exact = hertz(spheres, load);
  const double area = pi * exact.radius * exact.radius, stiffness = 1.5 * load / exact.approach;
  double before = infinity;
  for (Index n : {64, 96, 128, 192}) {
    CAPTURE(n);
    const Grid grid = square(n);
    const auto [c, e, corrected, energy] =
        judged(grid, undeformed_gap(grid, spheres), {.load = load, .stiffness = true}, spheres);
    CHECK(std::abs(energy - 0.4 * load * exact.approach) <= e.elastic_energy);  // Q ~ δ^{3/2}
    CHECK(e.elastic_energy <= 0.02 * energy);
    CHECK(e.plastic_work == 0);
    CHECK(std::abs(c.max_pressure - exact.pressure) <= e.max_pressure);
    CHECK(std::abs(c.approach - exact.approach) <= e.approach);
    CHECK(std::abs(c.area - area) <= e.area);
    CHECK(std::abs(corrected - area) <= e.area_corrected);
    CHECK(std::abs(c.stiffness - stiffness) <= e.stiffness);
    CHECK(e.plastic_area == 0);
    CHECK(std::isnan(e.load));
    // Of the second order, and of no more than thirty times the error of hertz.cpp's law.
    CHECK(e.approach < before);
    CHECK(e.approach <= 30 * 0.2 / std::pow(exact.radius / grid.dx, 2) * exact.approach);
    before = e.approach;
  }
}

TEST_CASE("under a prescribed approach the load has the error, and the datum of the means is taken off",
          "[contact][law]") {
  const Hertz exact = hertz(spheres, load);
  const Grid grid = square(96);
  const auto [c, e, corrected, energy] =
      judged(grid, undeformed_gap(grid, spheres), {.approach = exact.approach}, spheres);
  CHECK(std::abs(energy - 0.4 * load * exact.approach) <= e.elastic_energy);
  CHECK(std::abs(c.load - load) <= e.load);
  // Without the datum the coarser spheres lie (2 Δx)²/(8R)·… further off: dQ = S dδ of that would be stated.
  const double stiffness = 1.5 * load / exact.approach, datum = 2 * grid.dx * grid.dx / 25e-3 / 8;
  CHECK(e.load <= 0.7 * stiffness * datum);
  CHECK(std::isnan(e.approach));
}

// One free cell of four sides is carried into itself by eight symmetries: √(N m) = √32.
TEST_CASE("where all grids tell the same load and stiffness, gap and outline still make errors",
          "[contact][exact]") {
  const Grid grid{{4, 4}, 1, 1};
  Contact fine;
  fine.pressure = fine.displacement = Field::Zero(4, 4);
  fine.state.assign(16, Contact::open);
  fine.pressure(1, 1) = 1, fine.state[5] = Contact::elastic;
  fine.load = 50, fine.area = 1, fine.stiffness = 3, fine.mean_gap = 2;
  CoarserContacts coarser;
  coarser.contact = {fine, fine}, coarser.grid = {grid, grid};
  coarser.under_approach = true;
  coarser.contact[0].mean_gap = coarser.contact[1].mean_gap = 2.5;
  CHECK(grid_errors(grid, fine, coarser).load == Approx(0.4 * 0.5 * 3));
  CHECK(grid_errors(grid, fine, coarser).stiffness == Approx(0.3 * std::sqrt(32) * 3));
  CHECK(grid_errors(grid, fine, coarser).elastic_energy == Approx(0.1 * 50 * 0.5));
  coarser.contact[0].stiffness = infinity;
  CHECK(grid_errors(grid, fine, coarser).load == 0);
  // Beside it a cell at the limit pressure: the punch is the same, and so is its error.
  coarser.contact = {fine, fine};
  fine.state[6] = Contact::plastic, fine.area = 2, fine.plastic_area = 1;
  CHECK(grid_errors(grid, fine, coarser).stiffness == Approx(0.3 * std::sqrt(32) * 3));
  // Without a free cell there is no stiffness.
  fine.state[5] = Contact::plastic, fine.plastic_area = 2, fine.stiffness = 0;
  coarser.contact = {fine, fine};
  CHECK(grid_errors(grid, fine, coarser).stiffness == 0);
}

TEST_CASE("a wavy periodic surface keeps within its stated errors on a grid four times finer",
          "[contact][law]") {
  auto pressed = [](Index n) {
    const Grid grid = periodic(square(n, 1e-3));
    const Field gap = sample(grid, [](double x, double y) {
      const double k = 2 * pi / 1e-3;
      return 1e-6 * (std::cos(k * x) * std::cos(2 * k * y) + 0.3 * std::cos(3 * k * x + k * y + 1));
    });
    return judged(grid, gap, {.load = 300}, Bodies{});
  };
  const Judged coarse = pressed(64), fine = pressed(256);
  CHECK(std::abs(coarse.contact.max_pressure - fine.contact.max_pressure) <= coarse.errors.max_pressure);
  CHECK(std::abs(coarse.contact.approach - fine.contact.approach) <= coarse.errors.approach);
  CHECK(std::abs(coarse.contact.mean_gap - fine.contact.mean_gap) <= coarse.errors.mean_gap);
  CHECK(std::abs(coarse.energy - fine.energy) <= coarse.errors.elastic_energy);
  CHECK(std::abs(coarse.corrected - fine.corrected) <=
        coarse.errors.area_corrected + fine.errors.area_corrected);
}

TEST_CASE("a grid without coarser ones, or bodies that do not touch there, are told in words",
          "[contact][contract]") {
  CHECK(has_coarser_contacts({48, 52}));
  CHECK(!has_coarser_contacts({44, 64}));
  CHECK(!has_coarser_contacts({64, 66}));
  const Grid odd = square(50);
  const Field gap = undeformed_gap(odd, spheres);
  const auto influence = make_influence(odd, modulus);
  const ContactParameters parameters{.load = load};
  const Contact contact = solve_contact(odd, gap, *influence, parameters);
  const CoarserContacts none = coarser_contacts(odd, gap, *influence, contact, parameters, spheres);
  CHECK(none.unknown == "50x50 cells: both sides must be multiples of 4, of 48 cells at least");
  CHECK(std::isnan(grid_errors(odd, contact, none).max_pressure));
  // Single cells stand out; the mean of one with three others does not reach the other body.
  const Grid grid = square(64);
  const auto body = make_influence(grid, modulus);
  const ContactParameters sunk{.approach = 1e-6};
  auto unknown_of = [&](Index spikes) {
    Field gaps = Field::Constant(64, 64, 10e-6);
    for (Index k = 0; k < spikes; ++k) gaps(20, 6 * k) = 0;
    const Contact touching = solve_contact(grid, gaps, *body, sunk);
    return coarser_contacts(grid, gaps, *body, touching, sunk, Bodies{}).unknown;
  };
  CHECK(unknown_of(7) == "7 cells in contact, and errors need 8: refine the grid");
  CHECK(unknown_of(8).starts_with("on 32x32 cells, "));
}

TEST_CASE("halved fields are means of four, an odd line left out", "[contact][exact]") {
  const Grid grid{{5, 4}, 1, 2};
  const Field z = sample(grid, [](double x, double y) { return x + 10 * y; });
  const Field half = halved(z);
  REQUIRE(shape_of(half) == Shape{2, 2});
  CHECK(half(0, 0) == Approx((z(0, 0) + z(1, 1)) / 2));
  CHECK(half(1, 1) == Approx((z(2, 2) + z(3, 3)) / 2));
  const Grid coarse = halved(Grid{{6, 4}, 1, 2});
  CHECK(coarse.size_x() == 6);
  CHECK(coarse.dy == 4);
}
