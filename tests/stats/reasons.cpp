// Where a figure or its error would rest on next to nothing, there is none, and the reason is true.
#include <algorithm>

#include "fields.hpp"
#include "holes.hpp"
#include "named.hpp"
#include "stats/measure.hpp"
#include "stats/twins/twin_errors.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

Parameters measured(const Field& z, Group group, int degree = 0) {
  return measure({.grid = grid(z.rows(), z.cols()), .heights = z},
                 {.groups = {group}, .preparation = {.form = {.degree = degree}}});
}

void check_reason(const Parameters& parameters, std::initializer_list<const char*> names,
                  const std::string& reason) {
  for (const char* name : names) {
    CAPTURE(name);
    CHECK(std::isnan(named(parameters, name).standard_error));
    CHECK_THAT(named(parameters, name).note(), ContainsSubstring(reason));
  }
}

}  // namespace

// Every third row and column is missing but in one 3 × 3 block: slopes need a neighbour in either
// direction, curvatures all eight.
TEST_CASE("curvatures of one point have no error, and the reason is not that they are the same",
          "[reasons][exact]") {
  Field z = moving_average({60, 60}, {3, 3}, 11);
  for (Index i = 0; i < 60; ++i)
    for (Index j = 0; j < 60; ++j)
      if ((i % 3 == 2 || j % 3 == 2) && !(i >= 30 && i < 33 && j >= 30 && j < 33)) z(i, j) = none;
  const Parameters all = measured(z, Group::hybrid);
  check_reason(all, {"m4_x", "m4_y", "alpha_x", "summit_density", "nayak_density", "nayak_curvature"},
               "1 point has all eight neighbours, and an error needs more than ");
  CHECK(named(all, "m2_x").standard_error > 0);
  CHECK(named(measured(moving_average({60, 60}, {3, 3}, 11), Group::hybrid), "m4_x").standard_error > 0);
}

TEST_CASE("slopes that are round-off of the form are zero, as those along grooves", "[reasons][exact]") {
  const Field profile = moving_average({1, 64}, {1, 4}, 12);
  const Field tilted = profile.replicate(64, 1) + Field::NullaryExpr(64, 64, [](Index i, Index) {
                         return 0.3 * static_cast<double>(i);
                       });
  const Parameters all = measured(tilted, Group::hybrid, 1);
  for (const char* name : {"m2_x", "m4_x", "summit_density"}) CHECK(named(all, name).value == 0);
  for (const char* name : {"alpha_x", "nayak_density", "summit_height"}) {
    CAPTURE(name);
    CHECK((std::isnan(named(all, name).value) && !named(all, name).why.empty()));
  }
  CHECK(named(all, "m2_y").value > 0);
}

TEST_CASE("a form that leaves next to nothing to tell what it took leaves no errors",
          "[reasons][statistics]") {
  const Field z = gaussian_acf_field({128, 128}, 4, 13).topLeftCorner(64, 64);
  check_reason(measured(z, Group::height, 20), {"mean", "Sa", "Sq", "Sp", "N_eff"}, "231 modes");
  CHECK(named(measured(z, Group::height, 6), "Sq").standard_error > 0);
}

// The mean of the map as read had the error of what the filter left: its interval held the truth in 10 %.
TEST_CASE("behind an L-filter the mean is that of the map, and has no error, nor by twins",
          "[reasons][contract]") {
  const Field z = 3 + moving_average({64, 64}, {3, 3}, 16);
  const MeasureOptions asked{.preparation = {.longer = {12}}};
  const Sample sample(prepared({.grid = grid(64, 64), .heights = z}, asked.preparation));
  Parameters all = measure(sample, Group::height, asked);
  errors_by_twins(sample, asked, TwinUse::everywhere, {.twins = 10}, all);
  CHECK(named(all, "mean").value == mean(z));
  check_reason(all, {"mean"}, "the L-filter has taken the long waves");
  CHECK(named(all, "Sq").source == "10 twins");
  CHECK(named(measured(z, Group::height, 2), "mean").standard_error > 0);
}

TEST_CASE("extremes of heights that are not Gaussian say why they have no error", "[reasons][contract]") {
  const Sample sample(
      prepared({.grid = grid(64, 64), .heights = moving_average({64, 64}, {3, 3}, 14).exp()}, {}));
  const MeasureOptions asked{.groups = {Group::height}};
  Parameters all = measure(sample, Group::height, asked);
  check_reason(all, {"Sp", "Sv", "Sz"}, "tails");
  errors_by_twins(sample, asked, TwinUse::everywhere, {.twins = 10}, all);
  check_reason(all, {"Sp", "Sv", "Sz"}, "tails");
}

TEST_CASE("below the least N_eff every row says so, and m0 needs no second derivatives",
          "[reasons][contract]") {
  const Field few = moving_average({40, 40}, {20, 20}, 15);
  check_reason(measured(few, Group::height), {"Sq", "Sp", "Sv", "Sz"}, "is below 10");
  check_reason(measured(few, Group::material), {"Sk", "Spk", "Vmp", "Vvv", "Smc_p"}, "is below 10");
  check_reason(measured(few, Group::spatial), {"Sal", "Sal_direction"}, "is below 10");
  CHECK(named(measured(few, Group::height), "N").why.empty());
  const Field four{{1.0, 2.0}, {4.0, 3.0}};
  const Parameters of_four = measured(four, Group::hybrid);
  CHECK(relative_error(named(of_four, "m0").value, 1.25) <= 4 * epsilon);
  CHECK_THAT(named(of_four, "m2_x").why, ContainsSubstring("3 x 3"));
}

// Sa … Sz were refused, though they are 0; a profile and a field with holes too.
TEST_CASE(
    "parameters of a flat surface are 0 where they grow with the heights, else they say why they are not",
    "[reasons][exact]") {
  for (const Shape shape : {Shape{24, 20}, Shape{40, 1}}) {
    Field z = Field::Constant(shape.nx, shape.ny, 3e-7);
    z(3, 0) = none;
    z(5, 0) += 1e-22;  // round-off
    std::optional<FlatSurface> flat;
    try {
      prepared({.grid = grid(shape.nx, shape.ny), .heights = z}, {});
    } catch (const FlatSurface& e) {
      flat = e;
    }
    REQUIRE(flat);
    const Parameters heights = measure_flat(*flat->surface, Group::height, {}),
                     profile = measure_flat(*flat->surface, Group::material, {});
    for (const char* name : {"Sa", "Sq", "Sp", "Sv", "Sz"}) CHECK(named(heights, name).value == 0);
    CHECK(std::abs(named(heights, "mean").value - 3e-7) <= 1e-20);
    CHECK(named(heights, "N").value == static_cast<double>(shape.cells() - 1));
    for (const char* name : {"Ssk", "Sku", "N_eff"}) {
      CHECK(std::isnan(named(heights, name).value));
      CHECK_THAT(named(heights, name).note(), ContainsSubstring("the surface is flat"));
    }
    CHECK(named(profile, "Sk").value == 0);
    CHECK(std::isnan(named(profile, "Smr1").value));
    if (shape.ny == 1) continue;
    CHECK(named(measure_flat(*flat->surface, Group::hybrid, {}), "Sdq").value == 0);
    CHECK(std::isnan(named(measure_flat(*flat->surface, Group::spatial, {}), "Sal").value));
  }
}
