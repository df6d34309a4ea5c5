// The façade: what a surface has is what the rooms compute of it, group by group.
#include "stats/measure.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "fields.hpp"
#include "holes.hpp"
#include "named.hpp"
#include "stats/measure/pooled_maps.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

Surface surface_of(const Field& z) { return {.grid = grid(z.rows(), z.cols()), .heights = z}; }

}  // namespace

TEST_CASE("measure() has the moments of the field and their errors, points missing or not",
          "[measure][exact]") {
  for (const bool holes : {false, true}) {
    const Field drawn = moving_average({64, 60}, {3, 2}, 401),
                z = holes ? with_holes(drawn, 0.1, 402) : drawn;
    Surface surface = surface_of(z);
    surface.correlation = triangular_correlation({3, 2});
    const Parameters all = measure(surface);
    const Moments m = moments(remove_form(z));
    const ErrorBasis basis = error_basis(prepared(surface, {}));
    CHECK(named(all, "Sq").value == m.sq);
    CHECK(named(all, "Sku").value == m.sku);
    CHECK(named(all, "Sq").standard_error == standard_errors(m, basis.size()).sq);
    CHECK(named(all, "Sq").unit == "m");
    CHECK(named(all, "mean").value == mean(z));
    CHECK(std::ranges::count(all, "N_missing", &Parameter::name) == (holes ? 1 : 0));
  }
}

TEST_CASE("measure() computes the groups that are asked for, in one order, and no others",
          "[measure][contract]") {
  const Surface surface = surface_of(moving_average({40, 44}, {3, 2}, 403));
  const Parameters one = measure(surface, {.groups = {Group::material}}),
                   both = measure(surface, {.groups = {Group::hybrid, Group::material}});
  CHECK(one.front().name == "Sk");
  CHECK(one.back().name == "Vvv");
  CHECK(both.front().name == "Sk");
  CHECK(named(both, "Sdq").value > 0);
  CHECK(both.size() > one.size());
}

TEST_CASE("of a field that is no length hybrid parameters have no value, and say why",
          "[measure][contract]") {
  Surface surface = surface_of(moving_average({40, 44}, {3, 2}, 404));
  surface.units = "Pa";
  CHECK(missing(measure(surface, {.groups = {Group::hybrid}})).find("heights in m") != std::string::npos);
  CHECK(missing(measure(surface)).empty());
  CHECK(named(measure(surface), "Sa").unit == "Pa");
}

TEST_CASE("a surface without roughness has no parameters", "[measure][contract]") {
  CHECK_THROWS_AS(measure(surface_of(Field::Ones(9, 9))), DataError);
}

// m0 = Sq²: one is within its interval where the other is. The products round to 2 ε.
TEST_CASE("m0 has the error and the interval of Sq", "[measure][law]") {
  const Surface surface{grid(64, 48), 1e-6 * moving_average({64, 48}, {4, 3}, 31)};
  MeasureOptions options;
  options.groups = {Group::height, Group::hybrid};
  Parameter sq, m0;
  for (const Parameter& p : measure(surface, options))
    if (p.name == "Sq")
      sq = p;
    else if (p.name == "m0")
      m0 = p;
  const Interval of_sq = sq.interval_95(), of_m0 = m0.interval_95();
  REQUIRE(of_sq.known());
  CHECK(relative_error(m0.value, sq.value * sq.value) <= 100 * epsilon);
  CHECK(relative_error(m0.standard_error, 2 * sq.value * sq.standard_error) <= 4 * epsilon);
  CHECK(relative_error(of_m0.low, of_sq.low * of_sq.low) <= 4 * epsilon);
  CHECK(relative_error(of_m0.high, of_sq.high * of_sq.high) <= 4 * epsilon);
}

// A wave of 3 periods on 60 points, crests on points: differences are 2 sin(u/2) of the amplitude. Sums of 60
// terms, fourth powers of them.
TEST_CASE("a profile has the slope, the curvature and the peaks of its wave, along x as along y",
          "[measure][exact]") {
  const double h = 2e-6, a = 3e-7, u = 2 * std::numbers::pi / 20, slope = 2 * std::sin(u / 2) / h;
  Field z =
      Field::NullaryExpr(60, 1, [&](Index i, Index) { return a * std::cos(u * static_cast<double>(i)); });
  for (const std::string axis : {"x", "y"}) {
    const Parameters all = measure({{shape_of(z), h, h, true}, z}, {.groups = {Group::hybrid}});
    const double m2 = a * a / 2 * slope * slope;
    CHECK(relative_error(named(all, "m0").value, a * a / 2) <= 1e-13);
    CHECK(relative_error(named(all, "m2_" + axis).value, m2) <= 1e-12);
    CHECK(relative_error(named(all, "m4_" + axis).value, m2 * slope * slope) <= 1e-12);
    CHECK(relative_error(named(all, "alpha_" + axis).value, 1) <= 1e-12);
    CHECK(relative_error(named(all, "peak_density").value, 3 / (60 * h)) <= 1e-12);
    CHECK(relative_error(named(all, "peak_height").value, a) <= 1e-12);
    CHECK(relative_error(named(all, "peak_curvature").value, a * slope * slope) <= 1e-12);
    z.transposeInPlace();
  }
  Field steps(1, 9);
  steps << 0, 1, 1, 0, 2, NAN, 3, 1, 1;  // the point beside the missing one and the end are left out
  const Parameters some = measure({{shape_of(steps), h, h, false}, h * steps}, {.groups = {Group::hybrid}});
  CHECK(relative_error(named(some, "peak_density").value, 1 / (4 * h)) <= 1e-12);
  CHECK(relative_error(named(some, "peak_curvature").value, 2 / (h * (1 + 1.5))) <= 1e-12);
}

TEST_CASE("heights in steps leave no error of what the steps change, and say which step",
          "[measure][contract]") {
  const Field z = gaussian_acf_field({128, 128}, 8, 406);
  const Grid g = grid(128, 128, true);
  for (const double step : {0.0, 1e-4, 0.01, 0.1}) {
    const Surface surface{g, step > 0 ? Field((z / step).round() * step) : z};
    const Parameters all = measure(surface, {.groups = {Group::hybrid}});
    auto has_error = [&](const char* name) { return std::isfinite(named(all, name).standard_error); };
    CAPTURE(step);
    CHECK(has_error("m2_x") == (step < 0.1));
    CHECK(has_error("Sdq") == (step < 0.1));
    CHECK(has_error("nayak_radius") == (step < 0.01));
    CHECK(has_error("summit_density") == (step < 0.01));
    const std::string doubt = doubt_of_steps(Sample(prepared(surface, {})));
    CHECK(doubt.empty() == (step < 0.01));
    if (step == 0.1) CHECK(doubt.find("steps of 0.1 m") != std::string::npos);
    // A plane takes the ties, not the steps.
    const std::string tilted = doubt_of_steps(Sample(prepared(surface, {.form = {.degree = 1}})));
    CHECK((tilted.find("summit") == std::string::npos) == (step < 0.01));
    // An S-filter smooths them.
    CHECK(doubt_of_steps(Sample(prepared(surface, {.shorter = {6}}))).empty());
  }
}

// ---- reasons ----

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
TEST_CASE("behind an L-filter the mean is that of the map, and has no error", "[reasons][contract]") {
  const Field z = 3 + moving_average({64, 64}, {3, 3}, 16);
  const MeasureOptions asked{.preparation = {.longer = {12}}};
  const Sample sample(prepared({.grid = grid(64, 64), .heights = z}, asked.preparation));
  const Parameters all = measure(sample, Group::height, asked);
  CHECK(named(all, "mean").value == mean(z));
  check_reason(all, {"mean"}, "the L-filter has taken the long waves");
  CHECK(named(all, "Sq").standard_error > 0);
  CHECK(named(measured(z, Group::height, 2), "mean").standard_error > 0);
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
                     profile =
                         measure_flat(*flat->surface, Group::material, {.material_heights = {{1e-6, "c"}}});
    for (const char* name : {"Sa", "Sq", "Sp", "Sv", "Sz"}) CHECK(named(heights, name).value == 0);
    CHECK(std::abs(named(heights, "mean").value - 3e-7) <= 1e-20);
    CHECK(named(heights, "N").value == static_cast<double>(shape.cells() - 1));
    for (const char* name : {"Ssk", "Sku", "N_eff"}) {
      CHECK(std::isnan(named(heights, name).value));
      CHECK_THAT(named(heights, name).note(), ContainsSubstring("the surface is flat"));
    }
    CHECK(named(profile, "Sk").value == 0);
    for (const char* name : {"Smr1", "Smr_c"}) CHECK(std::isnan(named(profile, name).value));
    if (shape.ny == 1) continue;
    CHECK(named(measure_flat(*flat->surface, Group::hybrid, {}), "Sdq").value == 0);
    CHECK(std::isnan(named(measure_flat(*flat->surface, Group::spatial, {}), "Sal").value));
  }
}

// Of the field's own mean: (i - 31.5)/64 above c > 0 are half of the points less c of their range, and the curve
// from rank to rank is straight. Of two levels half the points lie above any c between them. Beyond all heights
// less than one patch tells of a share.
TEST_CASE("Smr(c) of a ramp is 1/2 - c/H, of two levels 1/2, turned over it is the rest, and a dash beyond",
          "[measure][exact]") {
  const auto smr = [](const Field& z, std::vector<MaterialHeight> heights) {
    return measure(surface_of(z), {.groups = {Group::material}, .material_heights = std::move(heights)});
  };
  const Field ramp = Field::NullaryExpr(64, 60, [](Index i, Index) { return static_cast<double>(i) / 63; });
  const Field noise = moving_average({64, 60}, {3, 2}, 403);
  const Parameters of_ramp = smr(ramp, {{0.1, "a"}, {-0.3, "b"}}),
                   up = smr(noise, {{0.5, "a"}, {0.5001, "b"}, {99, "c"}, {-99, "d"}}),
                   down = smr(-noise, {{-0.5, "a"}, {0.2, "b"}});
  CHECK(named(of_ramp, "Smr_a").value == Approx(0.4).margin(1.0 / 64));
  CHECK(named(of_ramp, "Smr_b").value == Approx(0.8).margin(1.0 / 64));
  const Field two = Field::NullaryExpr(64, 60, [](Index i, Index j) { return (i / 4 + j / 4) % 2; });
  for (const char* name : {"Smr_a", "Smr_b"})
    CHECK(std::abs(named(smr(two, {{0.1, "a"}, {-0.4, "b"}}), name).value - 0.5) <= 1 / 3839.0);
  const Parameter &above = named(up, "Smr_a"), &below = named(down, "Smr_a");
  CHECK(std::abs(above.value + below.value - 1) <= 1e-9);
  CHECK(above.standard_error > 0);
  CHECK(relative_error(above.standard_error, below.standard_error) <= 1e-6);
  CHECK(above.value >= named(up, "Smr_b").value);
  for (const auto& [name, share] : {std::pair{"Smr_c", 0}, {"Smr_d", 1}}) {
    CHECK(named(up, name).value == share);
    CHECK(std::isnan(named(up, name).standard_error));
    CHECK_THAT(named(up, name).why, ContainsSubstring("less than one independent height"));
  }
}

// What lies at u belongs to the core: nothing beyond it is no matter of equal heights.
TEST_CASE("figures of peaks and pits that no height makes say so, and p = q makes no difference",
          "[reasons][contract]") {
  const Field clipped = moving_average({96, 96}, {3, 3}, 404).min(0.5);
  const Parameters all =
      measure(surface_of(clipped), {.groups = {Group::material}, .material_ratios = {0.4, 0.4}});
  check_reason(all, {"Spk", "Spkx", "Sak1"}, "nothing lies beyond the core");
  check_reason(all, {"Sdc"}, "p and q are the same");
  for (const char* name : {"Spk", "Spkx", "Sak1", "Sdc"}) CHECK(named(all, name).value == 0);
}

// Two maps of one correlation exp(-(r/L)²), L = 8 h: of the spacings h and 1.5 h. The fourth derivative is 12/L⁴
// at most, cubics miss (9/16)/24 = 1/42.7 of it along either axis, times the share of the fine map's area.
TEST_CASE("correlations of two spacings are pooled at the lags of the coarser", "[ensemble][order]") {
  const double h = 1e-6, length = 8 * h;
  const auto acf_on = [&](const Grid& grid) {
    const LagField rho = LagField::of({40, 40}, [&](Index p, Index q) {
      const double x = static_cast<double>(p) * grid.dx, y = static_cast<double>(q) * grid.dy;
      return std::exp(-(x * x + y * y) / (length * length));
    });
    return AcfEstimate(rho, {rho, true, Pairs(grid)});
  };
  for (const double times : {1.5, 2.0}) {
    const Grid fine{{96, 96}, h, h}, coarse{{96, 96}, times * h, times * h};
    PooledMaps pool;
    for (const Grid& grid : {fine, coarse}) {
      MapSums sums({.sa = 0.8, .sq = 1, .sku = 3}, grid, 0);
      sums.set_acf(acf_on(grid), 0.2);
      pool.add(sums, grid.cell_area());
    }
    double error = 0;
    Grid found;
    const auto compare = [&](const LagField& rho, const Grid& grid) {
      found = grid;
      const LagField exact = acf_on(grid).rho.within({20, 20});
      error = std::max(error, (rho.within({20, 20}).half_plane() - exact.half_plane()).abs().maxCoeff());
      return Parameters{};
    };
    pool.all({.of_acf = compare});
    CHECK(found.dx == times * h);
    CHECK(!pool.one_spacing());
    const double bound = 2 * 12 / (std::pow(8, 4) * 42.7);
    CAPTURE(times, error, bound);
    CHECK(error <= (times == 2 ? 1e-14 : bound));
    if (times != 2) CHECK(error >= 0.1 * bound);
  }
}
