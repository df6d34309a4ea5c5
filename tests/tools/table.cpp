#include "tools/cli/table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <nlohmann/json.hpp>

#include "support.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

using namespace asperity::cli;
using namespace asperity::test;

namespace {

const Table table{{{"lag", "m"}, {"acf", "1"}, {"word", ""}},
                  {{1e-6, 1.0 / 3.0, "a"}, {0.1 + 0.2, -0.5, "bc"}}};

std::size_t widest_line(const std::string& text) {
  std::size_t out = 0, at = 0;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) ++at;
    if (c == '\n') at = 0;
    out = std::max(out, at);
  }
  return out;
}

}  // namespace

TEST_CASE("a number in a table reads back as the same double", "[table][exact]") {
  for (double x : {1.0 / 3.0, 0.1 + 0.2, 5e-324, 1.7976931348623157e308, -0.0})
    CHECK(std::strtod(shortest(x).c_str(), nullptr) == x);
}

TEST_CASE("a table in a pipe is one head line with units and tabs between", "[table][exact]") {
  CHECK(table.tsv() ==
        "# lag [m]\tacf [1]\tword\n1e-06\t0.3333333333333333\ta\n0.30000000000000004\t-0.5\tbc\n");
}

TEST_CASE("the columns of a table on a terminal stand one below the other", "[table][law]") {
  const std::string text = aligned(table, 80);
  const auto end = text.find('\n');
  CHECK(text.substr(0, end).find("word") == text.substr(end + 1).find("a"));
}

TEST_CASE("a table as JSON keeps values, units and order", "[table][exact]") {
  const auto json = nlohmann::ordered_json::parse(table.json());
  CHECK(json["lag"]["unit"] == "m");
  CHECK(json["acf"]["values"][0].get<double>() == 1.0 / 3.0);
  CHECK(json.begin().key() == "lag");
}

// A p-value that no simulated surface reached is below the least that 8192 of them tell.
TEST_CASE("a value that a quantity is below is no value: \"<\" in a table, a bound in JSON",
          "[table][contract]") {
  asperity::Parameters q{{"KS_p", 0.0001220703125, "1", std::nan(""), "p-value"}};
  q[0].is_bound = true;
  CHECK_THAT(table_of(q).tsv(), ContainsSubstring("KS_p\t<0.0001220703125\t"));
  CHECK_THAT(aligned(q, 80), ContainsSubstring("< 122.1e-6"));
  CHECK(nlohmann::json::parse(json_of(q))["KS_p"]["bound"] == true);
  Table bounded = table;
  bounded.bounds.insert({1, 1});
  CHECK_THAT(bounded.tsv(), ContainsSubstring("\t<-0.5\t"));
  CHECK_THAT(aligned(bounded, 80), ContainsSubstring("< -0.5"));
  CHECK(nlohmann::json::parse(bounded.json())["acf"]["bounds"] == std::vector<bool>{false, true});
  CHECK_FALSE(nlohmann::json::parse(table.json())["acf"].contains("bounds"));
}

TEST_CASE("what is not finite is null in JSON, for JSON has no word for it", "[table][contract]") {
  const asperity::Parameters q{{"Rq", std::nan(""), "m", std::nan(""), "rms height"}};
  const auto json = nlohmann::json::parse(json_of(q));
  CHECK(json["Rq"]["value"].is_null());
  CHECK_FALSE(json["Rq"].contains("standard_error"));
}

TEST_CASE(
    "on a terminal neighbouring columns of a unit share a prefix, and numbers have the digits that count",
    "[table][exact]") {
  const Table one{{{"lag", "m"}, {"acf", "1"}, {"se", "1", Holds::unknown}, {"psd", "m4"}, {"err", "m4"}},
                  {{0.0, 1.0, std::nan(""), 3.64e-21, 1e-22}, {23.4375e-6, -0.680239, 0.012545, 1e-30, 0.0}}};
  CHECK(aligned(one, 80) ==
        "lag [µm]      acf       se   psd [µm⁴]  err [µm⁴]\n"
        "       0   1.0000        -      3640.0      100.0\n"
        "   23.44  -0.6802  0.01255  1.0000e-06          0\n");
}

TEST_CASE("rows with units of their own are rounded to their standard error", "[table][exact]") {
  const Table rows{{{"quantity", ""},
                    {"unit", ""},
                    {"mean", "SI", Holds::unknown},
                    {"standard_error", "SI", Holds::unknown},
                    {"p", "1"}},
                   {{"Sq", "m", 4.0128995e-7, 8.2539e-9, 0.85236},
                    {"Sdr", "1", 1.2034e-4, 1.6e-6, 1e-9},
                    {"all", "1", NAN, NAN, 0.5}}};
  CHECK(aligned(rows, 80) ==
        "quantity  unit      mean  standard_error           p\n"
        "Sq        nm       401.3             8.3     0.85236\n"
        "Sdr             120.3e-6          1.6e-6  1.0000e-09\n"
        "all                    -               -     0.50000\n");
}

TEST_CASE("a value with an error ends where the second digit of the error ends, and so does its interval",
          "[table][exact]") {
  const double unknown = std::nan("");
  const Table rows{{{"count", "1"},
                    {"standard_error", "1"},
                    {"area", "m2"},
                    {"area_error", "m2", Holds::unknown},
                    {"acf", "1"},
                    {"standard_error", "1", Holds::unknown},
                    {"low_95", "1", Holds::unknown},
                    {"high_95", "1", Holds::unknown},
                    {"target", "1"}},
                   {{2.0, 1.2345, 1.23456e-9, 2.345e-11, 0.123456, 0.0234, 0.0768, 0.2, 0.123456},
                    {100.0, 9.8765, 2.5e-9, unknown, 0.5, unknown, unknown, unknown, 0.25}}};
  CHECK(
      aligned(rows, 120) ==
      "count  standard_error  area [µm²]  area_error [µm²]     acf  standard_error  low_95  high_95  target\n"
      "    2             1.2        1235                23   0.123           0.023   0.077    0.200  0.1235\n"
      "  100             9.9        2500                 -  0.5000               -       -        -  "
      "0.2500\n");
}

TEST_CASE("parameters on a terminal are a value, its error and its interval in one unit", "[table][exact]") {
  using asperity::Interval;
  const double open = std::numeric_limits<double>::infinity();
  const asperity::Parameters q{
      {"Sq", 3.86749e-7, "m", 9.454e-9, "rms", Interval::of(3.86749e-7, 3.69902e-7, 4.07151e-7)},
      {"Ssk", -0.019974, "1", 0.057935, "skewness, 0 for a Gaussian"},
      {"Sal", 9e-5, "m", 7e-6, "length", Interval::of(9e-5, 8e-5, open)},
      {"Std", 0.5, "rad", NAN, "direction"}};
  CHECK(aligned(q, 80) ==
        "quantity   value ± error  95 % interval    unit  meaning\n"
        "Sq         386.7 ± 9.5     369.9 to 407.2  nm    rms\n"
        "Ssk       -0.020 ± 0.058  -0.134 to 0.094        skewness, 0 for a Gaussian\n"
        "Sal         90.0 ± 7.0    above 80.0       µm    length\n"
        "Std        28.65          -                °     direction\n");
  CHECK_THAT(aligned(q, 72), ContainsSubstring("skewness, 0 for a\n" + std::string(49, ' ') + "Gaussian\n"));
  CHECK_THAT(aligned(q, 50), ContainsSubstring("\n    skewness, 0 for a Gaussian\n"));
}

TEST_CASE("a table on a terminal is no wider than that, one elsewhere is unchanged",
          "[table][contract][slow]") {
  require(
      "asperity-generate --shape 64x48 --size 3mm --rq 0.4um --length 6px --seed 3 -o s.nc; asperity-contact "
      "--radius 50mm --young 208GPa --poisson 0.3 --load 5kN s.nc -o p.nc; printf '0um 0um 100um\\n' > "
      "points");
  const std::string command =
      GENERATE(as<std::string>(), "stats s.nc --parameters all", "stats s.nc p.nc", "validate s.nc",
               "pdf s.nc", "stress p.nc --points points --components all");
  const std::string whole = "asperity-" + command + " -q --progress never";
  const std::string former = shell(whole).out;
  CHECK_THAT(former, Catch::Matchers::StartsWith("# ") && ContainsSubstring("\t"));
  for (const std::size_t width : {40, 66, 80, 130}) {
    CAPTURE(command, width);
    const Outcome run = shell("script -qec 'stty cols " + std::to_string(width) + "; " + whole +
                              " 2>/dev/null' /dev/null | tr -d '\\r'");
    CHECK(run.out.find('\t') == std::string::npos);
    CHECK(widest_line(run.out) <= width);
    CHECK(widest_line(run.out) > width / 2);
  }
  CHECK_THAT(shell("script -qec '" + whole + " -o t.tsv' /dev/null; cat t.tsv").out,
             ContainsSubstring(former));
}
