#include "tools/report/readable.hpp"

#include <cmath>
#include <limits>

#include "support.hpp"
#include "tools/report/html.hpp"

using namespace asperity;
using namespace asperity::report;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::string text(const Measurement& m) {
  return m.value + "|" + m.error + "|" + m.low + "|" + m.high + "|" + m.unit;
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

// RFC 4648, section 10.
TEST_CASE("base64 is that of RFC 4648", "[html][exact]") {
  const char* pairs[][2] = {{"", ""},
                            {"f", "Zg=="},
                            {"fo", "Zm8="},
                            {"foo", "Zm9v"},
                            {"foob", "Zm9vYg=="},
                            {"fooba", "Zm9vYmE="},
                            {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, expected] : pairs) CHECK(base64(bytes) == expected);
}

TEST_CASE("escaped text holds no markup, and nothing that is not UTF-8", "[html][contract]") {
  CHECK(escaped("<a href=\"x\">&'µ") == "&lt;a href=&quot;x&quot;&gt;&amp;&#39;µ");
  CHECK(escaped(std::string("a\xff\x01z\xc3")) == "a\u00FF\uFFFDz\u00C3");
}
