// In what unit a variable is read, and which are refused.
#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const Grid grid{{3, 4}, 1e-6, 1e-6, false};

Dataset with(const std::string& name, const std::string& unit) {
  Dataset out;
  set_grid(out, grid);
  set_field(out, name, Field::Constant(3, 4, 2), {unit, "a field"});
  if (unit.empty()) out.find(name)->attributes.erase("units");
  if (name == "heights") out.find(name)->attributes.erase("unit");
  return out;
}

std::string refused(const std::string& name, const std::string& unit, const char* needed) {
  try {
    field_of(with(name, unit), name, needed);
  } catch (const DataError& e) {
    return e.name + ": " + e.what();
  }
  return "read";
}

}  // namespace

// Pressure in MPa, psi, m or none passed as Pa. One product of a factor that is known to ε.
TEST_CASE("a field comes in the unit that is asked for, converted", "[units][exact]") {
  CHECK(field_of(with("pressure", "Pa"), "pressure", "Pa")(0, 0) == 2);
  CHECK(relative_error(field_of(with("pressure", "MPa"), "pressure", "Pa")(0, 0), 2e6) <= 2 * epsilon);
  CHECK(relative_error(field_of(with("pressure", "N/mm2"), "pressure")(0, 0), 2e6) <= 4 * epsilon);
  // 0.45359237 kg x 9.80665 m/s2 / (0.0254 m)2; UDUNITS has the pound-force to 12 digits
  CHECK(relative_error(field_of(with("pressure", "psi"), "pressure")(0, 0), 2 * 6894.757293168361) <= 1e-9);
  CHECK(relative_error(field_of(with("share", "percent"), "share", "1")(0, 0), 0.02) <= 2 * epsilon);
  CHECK(field_of(with("share", ""), "share", "1")(0, 0) == 2);
}

TEST_CASE("a field without a unit, of another quantity or another zero is refused by name, with what to do",
          "[units][contract]") {
  CHECK_THAT(refused("pressure", "", "Pa"),
             ContainsSubstring("pressure: has no unit") && ContainsSubstring("add the attribute units"));
  CHECK_THAT(refused("pressure", "m", "Pa"), ContainsSubstring("'m' cannot be converted to 'Pa'"));
  CHECK_THAT(refused("pressure", "word", "Pa"), ContainsSubstring("'word' is not a known unit"));
  CHECK_THAT(refused("gap", "m @ 5", "m"), ContainsSubstring("their zeros differ"));
  CHECK_THAT(refused("gap", "m-1", "m"), ContainsSubstring("cannot be converted to 'm'"));
  CHECK_THAT(refused("gap", "-1 m", "m"), ContainsSubstring("is not a multiple of 'm'"));
  CHECK_THROWS_AS(unit_factor("degC", "K"), std::invalid_argument);
  // what tools know by its name is what its name says, whoever asks
  for (const char* name : {"pressure", "von_mises"})
    CHECK_THROWS_AS(field_of(with(name, "m"), name), DataError);
  for (const char* name : {"heights", "heights_residual", "gap", "displacement", "displacement_plastic"}) {
    CHECK_THROWS_AS(field_of(with(name, "Pa"), name), DataError);
    CHECK_THROWS_AS(field_of(with(name, ""), name), DataError);
  }
}

TEST_CASE("a field of a user's own is read in m or Pa where it measures that, else in its own unit",
          "[units][exact]") {
  const std::pair<const char*, const char*> cases[] = {{"um", "m"},      {"GPa", "Pa"},  {"degC", "degC"},
                                                       {"V", "V"},       {"m-1", "m-1"}, {"", "1"},
                                                       {"a.u.", "a.u."}, {"1", "1"}};
  for (const auto& [unit, read] : cases) {
    const Dataset data = with("own", unit);
    CAPTURE(unit);
    CHECK(si_unit_of(data.at("own")) == read);
    const double factor = std::string(unit) == "um" ? 1e-6 : std::string(unit) == "GPa" ? 1e9 : 1;
    CHECK(relative_error(field_of(data, "own")(1, 1), 2 * factor) <= 2 * epsilon);
  }
}

// Lags in mm counted samples, for they were not in m.
TEST_CASE("lags are lengths, or samples of one each", "[units][exact]") {
  Variable lags{"p", {"p"}, std::vector<double>{0, 1, 2}, {}};
  CHECK(!lags_of(lags));
  for (const char* unit : {"1", "px"}) {
    lags.attributes.set("units", unit);
    CHECK(!lags_of(lags));
  }
  lags.attributes.set("units", "mm");
  CHECK(relative_error(lags_of(lags)->at(2), 2e-3) <= 2 * epsilon);
  lags.attributes.set("units", "s");
  CHECK_THROWS_AS(lags_of(lags), DataError);
  lags.attributes.erase("units");
  lags.values = std::vector<double>{0, 1e-6, 2e-6};
  CHECK_THROWS_WITH(lags_of(lags), ContainsSubstring("without a unit"));
}
