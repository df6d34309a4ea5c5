#include "contact/ratios.hpp"

#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

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
