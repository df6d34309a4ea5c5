// The façade: what a surface has is what the rooms compute of it, group by group.
#include "stats/measure.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "holes.hpp"
#include "named.hpp"

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
