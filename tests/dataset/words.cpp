// Numbers, counts and other people's text in lines that are read.
#include "core/words.hpp"

#include <cmath>
#include <limits>
#include <tuple>

#include "dataset/units.hpp"
#include "support.hpp"

using namespace asperity;

TEST_CASE("one thing is singular, none and several are plural", "[words][contract]") {
  CHECK(counted(1, "surface") == "1 surface");
  CHECK(counted(0, "surface") == "0 surfaces");
  CHECK(counted(20, "Newton step") == "20 Newton steps");
}

// from_chars leaves the number as it was where it is too large or too small, and does not say which.
TEST_CASE("a word is a number as a whole or not at all, and what lies beyond the range is told",
          "[words][exact]") {
  CHECK(to_number<double>("1.5e-6") == 1.5e-6);
  CHECK(to_number<std::int64_t>("-12") == -12);
  for (const char* none : {"", "1 ", " 1", "+1", "1,5", "0x1", "1e", "m"}) {
    CAPTURE(none);
    CHECK(!to_number<double>(none));
    CHECK(!to_number<int>(none));
  }
  CHECK(!to_number<double>("1e400"));
  for (const auto& [text, length, number] : {std::tuple{"5.x", 2, 5.0},
                                             {".5", 2, 0.5},
                                             {"-.5e1", 5, -5.0},
                                             {"1e+", 1, 1.0},
                                             {"1.2.3", 3, 1.2},
                                             {"0x1p3", 1, 0.0},
                                             {"0e999", 5, 0.0},
                                             {"4.9e-324", 8, 4.9e-324},
                                             {"inf", 3, HUGE_VAL},
                                             {"-Infinity", 9, -HUGE_VAL},
                                             {"inform", 3, HUGE_VAL}}) {
    CAPTURE(text);
    const auto read = leading_number<double>(text);
    CHECK((read.in_range && read.number == number &&
           read.rest == std::string_view(text).substr(std::size_t(length))));
  }
  for (const char* none : {"-", ".", "e5", "--1", "\t1", "i", "-+1", ""})
    CHECK(!leading_number<double>(none).found);
  CHECK(std::isnan(leading_number<double>("NaN").number));
  CHECK(!to_number<std::uint64_t>("-1"));
  const auto large = leading_number<double>("-1e400 m"), small = leading_number<double>("1e-400m");
  CHECK((large.found && !large.in_range && large.number == -HUGE_VAL && large.rest == " m"));
  CHECK((small.found && !small.in_range && small.number == 0 && small.rest == "m"));
  CHECK(leading_number<int>("-99999999999x").number == std::numeric_limits<int>::min());
  CHECK(!leading_number<int>("x").found);
}

// std::to_string(1e300) has 301 digits, of 1e-9 none but zeros.
TEST_CASE("a number has as many digits as it takes to read it back", "[words][exact]") {
  CHECK(shortest(1e300) == "1e+300");
  CHECK(shortest(1e-9) == "1e-09");
  CHECK(shortest(-std::nan("")) == "nan");
  CHECK(shortest(-std::numeric_limits<double>::infinity()) == "-inf");
}

TEST_CASE("UTF-8 stays as it is, and bytes that are none become the characters of Latin-1",
          "[words][contract]") {
  for (const char* text : {"", "plain", "µm", "17×4", "😀", "a\tb\x1b"}) CHECK(utf8_of(text) == text);
  CHECK(utf8_of("\xb5m") == "µm");
  CHECK(utf8_of("\xc5ngstr\xf6m") == "Ångström");
  CHECK(utf8_of("µm or \xb5m") == "µm or µm");
  for (const char* broken : {"\xc3", "a\xff", "\xed\xa0\x80", "\xf5\x80\x80\x80", "\xc0\xaf", "\xe2\x82"}) {
    CHECK_FALSE(is_utf8(broken));
    CHECK(is_utf8(utf8_of(broken)));
  }
}

TEST_CASE("a line ends nowhere, says nothing to a terminal and keeps its direction", "[words][contract]") {
  CHECK(one_line("a\nb\rc\td") == "a b c d");
  CHECK(one_line("\x1b[31mred\x07\x7f") == " [31mred  ");
  CHECK(one_line("\xc2\x9b"
                 "31m") == " 31m");  // the control sequence introducer as one character
  CHECK(one_line("\x9b"
                 "31m") == " 31m");  // and as the byte of it
  CHECK(one_line(std::string("a\0b", 3)) == "a b");
  CHECK(one_line("a\u2028b\u202ec\u2066d\u200fe\ufefff\uffff") == "a b c d e f ");
  CHECK(one_line("a\u00adb\u2060c\u200bd") == "a b c d");
  CHECK(one_line("µm, σ × 17 … – 高さ 😀") == "µm, σ × 17 … – 高さ 😀");
}

TEST_CASE("a line has a bounded length, and keeps its beginning and its end", "[words][contract]") {
  const std::string exact(longest_line, 'x');
  CHECK(one_line(exact) == exact);
  for (const std::string& filling :
       {std::string("x"), std::string("µ"), std::string("\xb5"), std::string("😀")}) {
    std::string text = "asperity-stats: ";
    for (int k = 0; k < 100000; ++k) text += filling;
    const std::string line = one_line(text + ": take another", 90);
    CHECK(is_utf8(line));
    CHECK(line.starts_with("asperity-stats: "));
    CHECK(line.ends_with(": take another"));
    CHECK(std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }) == 90);
  }
  CHECK(one_line("abcdefgh", 5) == "abc…h");
}

// Many instruments under Windows write Latin-1.
TEST_CASE("a unit in Latin-1 is understood as in UTF-8", "[units][contract]") {
  CHECK(unit_factor("\xb5m", "m") == unit_factor("µm", "m"));
  CHECK(unit_factor("\xc5", "m") == unit_factor("Å", "m"));
  CHECK_THROWS_AS(unit_factor("\xff\xfe", "m"), std::invalid_argument);
  try {
    unit_factor(std::string(100000, 'a') + "\x1b[31m", "m");
    FAIL("it is no unit");
  } catch (const std::invalid_argument& error) {
    CHECK(std::string(error.what()).size() <= 200);
  }
}
