#include "tools/cli/quantity.hpp"

#include <numbers>

#include "core/error.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::cli;
using namespace asperity::test;

// One product, and the factor itself is rounded once: two units in the last place.
TEST_CASE("a quantity is its number times its unit", "[quantity][exact]") {
  CHECK(relative_error(parse_quantity("rq", "0.4um", "m"), 0.4e-6) <= 2 * epsilon);
  CHECK(relative_error(parse_quantity("rq", "0.4 µm", "m"), 0.4e-6) <= 2 * epsilon);
  CHECK(relative_error(parse_quantity("young", "208GPa", "Pa"), 208e9) <= 2 * epsilon);
  CHECK(parse_quantity("load", "5000N", "N") == 5000);
  CHECK(parse_quantity("load", "-1e3N", "N") == -1000);
  CHECK(std::isinf(parse_quantity("radius", "inf", "m")));
}

TEST_CASE("a quantity without its unit, of another dimension, or without a number is refused",
          "[quantity][contract]") {
  for (const char* text : {"50", "50N", "mm", "", "50 mm mm", "1e999mm", "nan", "50px", "5,0mm"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_quantity("radius", text, "m"), ParameterError);
  }
}

// UDUNITS multiplies: 12 500 N were 6000 N, 2..3N were 0.6 N, and 2 08GPa were 16 GPa.
TEST_CASE("a quantity has one number: a second one is refused, not multiplied by", "[quantity][contract]") {
  for (const char* text : {"12 500 N",
                           "1 500N",
                           "1\u00a0500N",
                           "1'000N",
                           "1_000N",
                           "1 000",
                           "2..3N",
                           "2.3.4N",
                           "1e3.5N",
                           "0-1N",
                           "0x10N",
                           "3 -N",
                           "+-3N",
                           "- 3 N",
                           "+3N",
                           "10 2 N",
                           "3 N 2",
                           "3 N2",
                           "3N3",
                           "3N.2",
                           "3N*2",
                           "3N\u00b72",
                           "3N \xb7"
                           "2",
                           "3N/2",
                           "3 1/2N",
                           "3(2N)",
                           "3 (N)(2)",
                           "3N @ 2",
                           "3 lg(re 1 N)",
                           "5 10^3 N",
                           "3N from 2",
                           "nan N",
                           "\u00bdN",
                           "3N,",
                           "3N;",
                           "3N)",
                           "3N x",
                           "3 N N",
                           "3N\t",
                           "1,5N"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_quantity("load", text, "N"), ParameterError);
    CHECK_THROWS_AS(parse_length("length", std::string(text) + "px"), ParameterError);
  }
  CHECK_THROWS_AS(parse_length("length", "1 7px"), ParameterError);
  CHECK_THROWS_AS(parse_bytes("memory", "1 500MB"), ParameterError);
  CHECK_THROWS_AS(parse_angle("angle", "3 0deg"), ParameterError);
  CHECK_THROWS_AS(parse_quantities("poisson", "0.3 0.2", "1"), ParameterError);
  CHECK_THROWS_WITH(parse_quantity("load", "12 500 N", "N"),
                    ContainsSubstring("'12 500 N' has more than one"));
}

TEST_CASE("the numbers of a unit are its exponents and the 1 of a reciprocal", "[quantity][exact]") {
  for (const auto& [text, unit, value] : {std::tuple{"5 kN", "N", 5e3},
                                          {"2 N/m2", "Pa", 2.0},
                                          {"2 kg m-3", "kg m-3", 2.0},
                                          {"2 um^2", "m2", 2e-12},
                                          {"2m s-1", "m s-1", 2.0},
                                          {"2um**2", "m2", 2e-12},
                                          {"2 (m s)-1", "m-1 s-1", 2.0},
                                          {"2 1/um", "m-1", 2e6},
                                          {"2\u00b5m\u00b3", "m3", 2e-18},
                                          {"2 \u00c5^2", "m2", 2e-20},
                                          {"2 kg.m-1.s-2", "Pa", 2.0},
                                          {"2 N\u00b7m-2", "Pa", 2.0},
                                          {"2%", "1", 0.02},
                                          {"2'", "arcminute", 2.0}}) {
    CAPTURE(text);
    CHECK(relative_error(parse_quantity("of", text, unit), value) <= 4 * epsilon);
  }
}

TEST_CASE("a bare number is answered with the units that it may have meant", "[quantity][contract]") {
  CHECK_THROWS_WITH(parse_quantity("radius", "50", "m"), ContainsSubstring("mm"));
  CHECK_THROWS_WITH(parse_length("length", "17"), ContainsSubstring("px"));
}

TEST_CASE("one value stands for both, two for one each, three for nothing", "[quantity][contract]") {
  CHECK(parse_quantities("size", "3m", "m") == std::array<double, 2>{3, 3});
  CHECK(parse_quantities("size", "3m,2m", "m") == std::array<double, 2>{3, 2});
  CHECK_THROWS_AS(parse_quantities("size", "3m,2m,1m", "m"), ParameterError);
  CHECK_THROWS_AS(parse_quantities("size", "3m,", "m"), ParameterError);
}

TEST_CASE("a length in samples and in metres agree by the spacing", "[quantity][exact]") {
  const auto lengths = parse_lengths("length", "17px,0.5mm");
  CHECK(lengths[0].samples);
  CHECK(lengths[0].metres(2e-3) == 34e-3);
  CHECK_FALSE(lengths[1].samples);
  CHECK(relative_error(lengths[1].metres(1e-4), 5e-4) <= 2 * epsilon);
}

TEST_CASE("counts are two whole numbers within bounds", "[quantity][contract]") {
  CHECK(parse_counts("shape", "128x64", 1) == Shape{128, 64});
  for (const char* text : {"128", "0x5", "-3x5", "5x", "x5", "5x5x5", "1.5x2", "99999999x1", "5 x 5"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_counts("shape", text, 1), ParameterError);
  }
}

// 725deg was taken as 5deg's like: an angle that somebody mistyped, or gave in another unit.
TEST_CASE("an angle is a turn at most, either way", "[quantity][contract]") {
  CHECK(parse_angle("angle", "-360deg") == -2 * std::numbers::pi);
  CHECK(relative_error(parse_angle("angle", "6.28rad"), 6.28) <= epsilon);
  for (const char* text : {"30", "361deg", "-360.1deg", "6.3rad", "inf", "1e300"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_angle("angle", text), ParameterError);
  }
}

TEST_CASE("a quantity is shown with the prefix that suits it", "[quantity][exact]") {
  CHECK(format_quantity(0.003, "m") == "3mm");
  CHECK(format_quantity(208e9, "Pa") == "208GPa");
  CHECK(format_quantity(4e-7, "m") == "400nm");
  CHECK(format_quantity(-5000, "N") == "-5kN");
  CHECK(format_quantity(0, "m") == "0");
  CHECK(format_quantity(0.3, "1") == "0.3");
}

TEST_CASE("sizes of memory are read in powers of ten and of two", "[quantity][exact]") {
  CHECK(parse_bytes("memory", "512MB") == 512'000'000u);
  CHECK(parse_bytes("memory", "2GiB") == std::size_t{1} << 31);
  CHECK(parse_bytes("memory", "1.5 kB") == 1500u);
  CHECK(parse_bytes("memory", "8TiB") == std::size_t{1} << 43);
  CHECK(format_bytes(parse_bytes("memory", "1GiB")) == "1GiB");
  CHECK(format_bytes(27'000'001) == "28MB");
}
