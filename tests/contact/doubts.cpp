#include "contact/doubts.hpp"

#include "contact/ratios.hpp"
#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

std::string told(const Grid& grid, const Bodies& bodies, ContactParameters parameters,
                 const Field& heights = {}) {
  Field gap = undeformed_gap(grid, bodies);
  if (heights.size() > 0) gap -= heights;
  std::string out;
  for (const Doubt& doubt :
       doubts(grid, bodies, solve_contact(grid, gap, bodies.composite_modulus(), parameters)))
    out += doubt.words + "\n";
  return out;
}

}  // namespace

TEST_CASE("a contact within its domain, of many cells and small strains, is not in doubt",
          "[doubts][contract]") {
  CHECK(told(square(32), spheres, {.load = load}).empty());
  CHECK(doubts(square(32), spheres).empty());
}

TEST_CASE("a contact of few cells is told how many they are", "[doubts][contract]") {
  CHECK_THAT(told(square(32), spheres, {.load = 1}), ContainsSubstring("cells, fewer than 50"));
}

// 20 kN/m on R = 50 mm: b = √(4 q R/πE*) = 105.6 um, 54 cells across of 256, 10 of 48, 4 or 6 of 24.
TEST_CASE("of a line contact on cells that repeat, 8 across are not few", "[doubts][contract]") {
  const Bodies cylinder{.radius = {Radii(50e-3, infinity), Radii()}};
  auto strip = [&](Index nx, Index ny) {
    Grid line{{nx, ny}, 1e-3 / static_cast<double>(nx), 1e-5};
    line.periodic = {false, true};
    return told(line, cylinder, {.load = 20e3 * line.size_y()});
  };
  CHECK(strip(256, 1).empty());
  CHECK(strip(48, 1).empty());
  CHECK_THAT(strip(24, 1), ContainsSubstring("cells, fewer than 8: refine the grid"));
  CHECK_THAT(strip(24, 4), ContainsSubstring("cells, fewer than 32: refine the grid"));
  CHECK_THAT(strip(24, 7), ContainsSubstring("cells, fewer than 50: refine the grid"));
}

// 50 kN: a = 2.017 mm, so that 4.03 mm are touched and 6.05 mm wanted.
TEST_CASE("a contact at the domain's edge is told the size that Hertz's needs", "[doubts][contract]") {
  CHECK_THAT(told(square(32), spheres, {.load = 50000}),
             ContainsSubstring(
                 "domain, 0.003 x 0.003 m: smooth bodies touch on 0.00403 x 0.00403 m; make it 0.00605 x "
                 "0.00605 m or more"));
  // It fits in 6.05 mm; at a limit of 1 GPa the same load takes √(Q/πp) = 3.989 mm for a.
  CHECK(told(square(32, 6.05e-3), spheres, {.load = 50000}).empty());
  CHECK_THAT(told(square(32, 7.2e-3), spheres, {.load = 50000, .limit_pressure = 1e9}),
             ContainsSubstring("make it 0.012 x 0.012 m"));
  // A rough contact at the edge of a domain that Hertz would not fill: half as much again.
  Field peak = Field::Zero(32, 32);
  peak(0, 16) = 100e-6;
  CHECK_THAT(told(square(32), spheres, {.load = 100}, peak), ContainsSubstring("make it 0.0045 x 0.003 m"));
}

TEST_CASE("flats and cylinders at the edge are told what they lack", "[doubts][contract]") {
  CHECK_THAT(told(square(32), {}, {.load = 10}), ContainsSubstring("make them periodic, or give a radius"));
  const Bodies cylinder{.radius = {Radii(50e-3, infinity), Radii()}};
  CHECK_THAT(told(square(32), cylinder, {.load = 1000}),
             ContainsSubstring("make it periodic along y, or give a radius along y too\n"));
  // b = √(4 q R/πE*) = 1.72 mm.
  CHECK_THAT(told(square(32), cylinder, {.load = 16000}),
             ContainsSubstring("give a radius along y too, and a domain of 0.00517 m across"));
  CHECK(told(periodic(square(32)), {}, {.load = 10}).empty());
  // Along an axis that repeats there is no edge; across, 3b = 5.2 mm.
  Grid line = square(32);
  line.periodic = {false, true};
  CHECK(told(line, cylinder, {.load = 1000}).empty());
  CHECK_THAT(told(line, cylinder, {.load = 16000}),
             ContainsSubstring("touch on a width of 0.00345 m; make it 0.00517 m or more along x"));
  CHECK_THAT(told(line, {}, {.load = 10}), ContainsSubstring("make them periodic, or give a radius"));
}

// 13.5 TPa came without a word from a rough surface of 0.08 mm x 0.2 mm under 5 kN.
TEST_CASE("a pressure above the composite modulus is told with both", "[doubts][contract]") {
  const Field waves = 20e-6 * random_waves({32, 32}, 3);
  const Grid grid = periodic(square(32, 1e-4));
  const std::string much = told(grid, {}, {.load = 5000}, waves);
  CHECK_THAT(much, ContainsSubstring("is above the composite modulus, 1.14e+11 Pa"));
  CHECK(told(grid, {}, {.load = 5, .limit_pressure = 3.6e9}, waves).find("modulus") == std::string::npos);
}

TEST_CASE("a domain beyond a body's radius is told with both", "[doubts][contract]") {
  const Grid grid{{32, 64}, 1e-4, 1e-4};  // 3.2 mm x 6.4 mm
  const std::vector<Doubt> found = doubts(grid, {.radius = {Radii(50e-3), Radii(-3e-3, -3.1e-3)}});
  REQUIRE(found.size() == 1);
  CHECK_THAT(found[0].words, ContainsSubstring("y = 0.0032 m, beyond a body's radius of 0.0031 m"));
  CHECK(doubts(grid, {.radius = {Radii(1e-3), Radii(1e-3)}}).size() == 1);
}

namespace {

constexpr GapRoughness rough{.rms_height = 2e-6,
                             .rms_slope = 0.1,
                             .nayak_alpha = 5,
                             .summit_deviation = 1e-6,
                             .summit_curvature = 4e4};

}  // namespace

TEST_CASE("the ratios of flats are those of their areas, pressures, slopes and gaps", "[ratios][exact]") {
  const Bodies flats{.young = {200e9, infinity}, .poisson = {0, 0}};
  const Grid grid{{10, 20}, 1e-4, 1e-4};  // 2 mm²
  Contact contact;
  contact.load = 4000;
  contact.mean_gap = 3e-6;
  const ContactRatios r = contact_ratios(grid, flats, rough, 1e9, contact, 0.3e-6);
  CHECK(r.area_share == Approx(0.15));
  CHECK(r.reduced_pressure == Approx(2e9 / (200e9 * 0.1)));
  CHECK(r.kappa == Approx(0.15 / 0.1));
  CHECK(r.reduced_gap == Approx(1.5));
  CHECK(r.plasticity_index == Approx(200 * std::sqrt(0.04)));
  CHECK(std::isnan(r.sphere_roughness));
  CHECK(std::isnan(contact_ratios(grid, flats, rough, infinity, contact, 1e-6).plasticity_index));
  const ContactRatios smooth = contact_ratios(grid, flats, {}, 1e9, contact, 1e-6);
  CHECK(smooth.area_share == Approx(0.5));
  for (const double unknown :
       {smooth.reduced_pressure, smooth.kappa, smooth.reduced_gap, smooth.plasticity_index})
    CHECK(std::isnan(unknown));
}

TEST_CASE("errors of the ratios are the relative errors of area, load, slope and gap, added",
          "[ratios][exact]") {
  GapRoughness gap = rough;
  gap.rms_slope_error = 0.002;  // 2 %
  Contact contact;
  contact.load = 4000;
  const GridErrors errors{.area_corrected = 0.03e-6, .mean_gap = 0.1e-6};
  const ContactRatios ratios{.area_share = 0.15, .reduced_pressure = 0.1, .kappa = 1.5};
  const ContactRatios e = ratio_errors(ratios, gap, contact, 0.3e-6, errors, 200);  // 10 %, 5 %
  CHECK(e.area_share == Approx(0.015));
  CHECK(e.reduced_pressure == Approx(0.007));
  CHECK(e.kappa == Approx(1.5 * 0.17));
  CHECK(e.reduced_gap == Approx(0.05));
  CHECK(std::isnan(ratio_errors(ratios, rough, contact, 0.3e-6, errors, 0).kappa));
}

// a0² = R δ of Hertz.
TEST_CASE("the roughness of a sphere is its rms height over the smooth approach, and has no nominal pressure",
          "[ratios][exact]") {
  Contact contact;
  contact.load = load;
  const ContactRatios r = contact_ratios(square(8), spheres, rough, infinity, contact, 1e-6);
  CHECK(relative_error(r.sphere_roughness, 2e-6 / hertz(spheres, load).approach) <= 1e-12);
  for (const double none : {r.area_share, r.reduced_pressure, r.kappa, r.reduced_gap})
    CHECK(std::isnan(none));
  const Bodies barrel{.radius = {Radii{50e-3, 70e-3}, {}}};
  CHECK(std::isnan(contact_ratios(square(8), barrel, rough, infinity, contact, 1e-6).sphere_roughness));
}
