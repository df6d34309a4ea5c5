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
