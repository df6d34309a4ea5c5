#include "tools/cli/readable.hpp"

#include <cmath>
#include <limits>

#include "support.hpp"

using namespace asperity;
using namespace asperity::cli;

namespace {

std::string text(const Measurement& m) {
  return m.value + "|" + m.error + "|" + m.low + "|" + m.high + "|" + m.unit;
}

// Of an unscaled power, "m⁻⁴" for "m-4".
std::string power_name(const std::string& unit) {
  return unit.size() > 1 && unit.find_first_of("/ r") == unit.npos
             ? "m" + superscript(std::stoi(unit.substr(1)))
         : unit == "rad m-1" ? "rad/m"
                             : unit;
}

}  // namespace

TEST_CASE("a value ends where the second digit of its error ends", "[readable][exact]") {
  CHECK(text(readable({"Sq", 3.86749e-7, "m", 9.454e-9, "",
                       Interval::of(3.86749e-7, 3.69902e-7, 4.07151e-7)})) == "386.7|9.5|369.9|407.2|nm");
  CHECK(text(readable({"Ssk", -0.019974, "1", 0.057935, "", Interval::of(-0.019974, -0.1318, 0.0918)})) ==
        "−0.020|0.058|−0.132|0.092|");
  CHECK(text(readable({"s", 12345, "Pa-1", 678, "", Interval::of(12345, 11000, 14000)})) ==
        "12350|680|11000|14000|Pa-1");
}

TEST_CASE("what has no error has four digits, and a whole number all of its own", "[readable][exact]") {
  CHECK(text(readable({"Sp", 1.4075520e-6, "m", unknown, ""})) == "1.408||||µm");
  CHECK(text(readable({"N", 1048576, "1", unknown, ""})) == "1048576||||");
  CHECK(readable(9007199254740992.0, "1") == "9007199254740992");
}

TEST_CASE("areas and curvatures take the prefix of their length", "[readable][exact]") {
  CHECK(readable(1.454e-6, "m2") == "1.454\u00A0mm²");
  CHECK(readable(1.211e-8, "m2") == "0.01211\u00A0mm²");
  CHECK(readable(0, "m2") == "0\u00A0m²");
  CHECK(readable(1112, "m-1") == "1.112\u00A0mm⁻¹");
  CHECK(readable(1.28e8, "m-2") == "128\u00A0mm⁻²");
  CHECK(readable(2.466e-3, "s") == "2.466\u00A0ms");
  CHECK(readable(1e-10, "1") == "1\u00A0×\u00A010⁻¹⁰");
  CHECK(readable(std::acos(-1.0) / 2, "rad") == "90°");
  CHECK(readable(-0.0, "m") == "0\u00A0m");
  CHECK(readable(std::numeric_limits<double>::infinity(), "Pa") == "∞");
}

TEST_CASE("a prefix of a power is raised to it, and what cannot be scaled safely stays SI",
          "[readable][exact]") {
  struct {
    double value;
    const char *unit, *expected;
  } const cases[] = {{2.5e-21, "m4", "2500\u00A0µm⁴"},  {4e-11, "m3", "0.04\u00A0mm³"},
                     {3e-14, "m3", "3e+04\u00A0µm³"},   {1.572e8, "N/m", "157.2\u00A0MN/m"},
                     {2.1e9, "Pa/m", "2.1\u00A0GPa/m"}, {3e-5, "m/m", "30\u00A0µm/m"},
                     {8e6, "Pa m-1", "8\u00A0MPa m-1"}, {2527, "rad m-1", "2.527\u00A0rad/mm"},
                     {1e-6, "Pa-1", "1e-06\u00A0Pa-1"}, {1e12, "Pa2 m2", "1000000000000\u00A0Pa2 m2"},
                     {0.02, "1/m", "0.02\u00A01/m"},    {-0.7853981633974483, "rad", "−45°"}};
  for (const auto& [value, unit, expected] : cases) CHECK(readable(value, unit) == expected);
  for (const char* unit : {"m", "m2", "m-1", "m4", "m-4", "N/m", "Pa/m", "m/m", "rad m-1", "rad"})
    for (double x = 1e-30; x < 1e30; x *= 7) {
      const Unit scaled = unit_for(x, unit);
      CHECK(scaled.factor > 0);
      CHECK((scaled.factor == 1) == (scaled.name == unit || power_name(unit) == scaled.name));
    }
}

TEST_CASE("values and errors of any size are shown together", "[readable][exact]") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(text(readable({"a", 0, "m", 0.4e-9, ""})) == "0.00|0.40|−0.78|0.78|nm");
  CHECK(text(readable({"a", 0, "m", unknown, ""})) == "0||||m");
  CHECK(text(readable({"a", unknown, "m", unknown, ""})) == "–||||m");
  CHECK(text(readable({"a", 8e-9, "m", 23e-6, ""})) == "0|23|−45|45|µm");
  CHECK(text(readable({"a", 1, "m", 0.0996, ""})) == "1.00|0.10|0.80|1.20|m");
  CHECK(text(readable({"a", 1e20, "Pa", 3e18, ""})) == "100.0|3.0|94.1|105.9|×\u00A010⁹\u00A0GPa");
  CHECK(text(readable({"a", 2e-20, "1", 3e-21, ""})) == "20.0|3.0|14.1|25.9|×\u00A010⁻²¹");
  CHECK(text(readable({"a", 2e-20, "m", 3e-21, ""})) == "20.0|3.0|14.1|25.9|×\u00A010⁻¹²\u00A0nm");
  CHECK(text(readable({"a", 5e-324, "1", unknown, ""})).find("inf") == std::string::npos);
  CHECK(text(readable({"a", 0.5, "1", 1e-20, ""})) == "0.5||||");  // beyond the digits of a double
  CHECK(text(readable({"a", 0.5, "1", infinity, ""})) == "0.5||||");
  CHECK(text(readable({"a", 0.1, "rad", 0.01, ""})) == "5.73|0.57|4.61|6.85|°");
  CHECK(text(readable({"a", 2e-6, "m", 1e-7, "", Interval::of(2e-6, 1.8e-6, infinity)})) ==
        "2.00|0.10|1.80|∞|µm");
}
