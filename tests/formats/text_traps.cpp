// Texts that look like one thing and mean another: each of them was read, wrongly and without a word.
#include "texts.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// Points x z of `count` places from `first` in steps of `step`, all but those of `without`.
std::string profile(double first, double step, int count, const char* form,
                    const std::vector<int>& without = {}) {
  std::string out;
  for (int i = 0; i < count; ++i) {
    if (std::ranges::find(without, i) != without.end()) continue;
    char number[64];
    std::snprintf(number, sizeof number, form, first + i * step);
    out += std::string(number) + " " + std::to_string(i % 7) + "\n";
  }
  return out;
}

const Reading points = told_columns("1/mm,2/um");

}  // namespace

// 0.125 µm in mm with four decimals: 81 points became 101, 20 of them missing. Two lines within half a digit
// at both ends differ by at most two digits there, so that their steps differ by 2 u / (n - 1).
TEST_CASE("a spacing of 1.1 to 2.5 printed digits is read as it was before it was rounded",
          "[formats][text][exact]") {
  for (const double step : {1.1e-4, 1.25e-4, 1.37e-4, 1.5e-4, 1.8e-4, 1.93e-4, 2.2e-4, 2.5e-4})
    for (const double first : {0.0, 3.3e-5, -0.00721}) {
      CAPTURE(step, first);
      const int count = 101;
      const Map map = format::text.decode(profile(first, step, count, "%.4f"), points);
      REQUIRE(map.values.rows() == count);
      CHECK(!map.values.hasNaN());
      for (Index i = 0; i < count; ++i)
        CHECK(std::abs(map.values(i, 0) - 1e-6 * static_cast<double>(i % 7)) <= 1e-6 * 7 * epsilon);
      CHECK(std::abs(map.spacing[0] / 1e-3 - step) <= 2e-4 / (count - 1));
    }
}

// Whole numbers of one digit and 10 were taken for numbers with one significant digit, 10 for one off by 5.
TEST_CASE("a few whole numbers evenly apart before they were rounded are a grid", "[formats][text][exact]") {
  const Map map = format::text.decode(profile(-9.6, 2.07, 10, "%.0f"), points);
  CHECK(map.values.rows() == 10);
  CHECK(!map.values.hasNaN());
}

TEST_CASE("an even spacing that rounding explains as well as a few missing points is refused",
          "[formats][text][contract]") {
  for (const char* text : {"0 1\n1 2\n2 3\n4 4\n5 5\n6 6\n8 7\n", "0 1\n1 2\n3 3\n4 4\n"})
    CHECK_THAT(refusal(text, points), ContainsSubstring("too few digits"));
  // No even spacing rounds to two neighbours that are missing, nor to two missing points side by side.
  const Map holes = format::text.decode(profile(0, 1, 40, "%.0f", {3, 4, 20}), points);
  CHECK(holes.values.rows() == 40);
  CHECK(holes.values.isNaN().count() == 3);
  // One of forty changes the spacing by less than the twentieth that counts as even.
  CHECK(format::text.decode(profile(0, 1, 40, "%.0f", {17}), points).values.rows() == 40);
}

TEST_CASE("blanks between thousands beside tabs are refused as ambiguous, or read where nothing else fits",
          "[formats][text][contract]") {
  for (const char* text :
       {"1 234,5\t2 345,6\t5 555,1\n3 456,7\t4 567,8\t6 666,2\n",
        "1 234\t2 345\t5 555\n3 456\t4 567\t6 666\n", "1 234.5\t2 345.6\n3 456.7\t4 567.8\n"})
    CHECK_THAT(refusal(text), ContainsSubstring("the `separator`"));
  Reading tabs;
  tabs.separator = Separator::tab;
  tabs.decimal = DecimalMark::comma;
  const Field told = field({{1234.5, -2345.6}, {3456.7, 1000000}});
  CHECK(same(format::text.decode("1 234,5\t-2 345,6\n3 456,7\t1 000 000\n", tabs).values, told));
  const Field z = field({{1234.5, 999.5}, {456.7, 567.8}});
  CHECK(same(format::text.decode("1 234,5\t999,5\n456,7\t567,8\n", {}).values, z));
  CHECK_THAT(refusal("1 23,5\t999,5\n456,7\t567,8\n"), ContainsSubstring("the first line"));
  // Blanks and tabs, none of them between thousands.
  CHECK(shape_of(format::text.decode("1 2\t3 4\n5 6\t7 9\n", {}).values) == Shape{2, 4});
}

TEST_CASE("blocks of a matrix below comments like heads are refused, other comments may stand anywhere",
          "[formats][text][contract]") {
  for (const char* text :
       {"# block 1\n4 2\n3 4\n# block 2\n9 6\n7 8\n", "4 2\n3 4\n# Channel: phase\n9 6\n7 8\n",
        "% Height 1 of 2\n4 2\n3 4\n% Height 2 of 2\n9 6\n7 8\n",
        "# Map1\n# by A\n4 2\n3 4\n# Map2\n# by B\n9 6\n7 8\n", "#data\n4 2\n3 4\n9 6\n7 8\n#data\n4 2\n"}) {
    CAPTURE(text);
    CHECK_THAT(refusal(text), ContainsSubstring("a file holds one map"));
  }
  const Field rows = field({{4, 2}, {3, 4}, {9, 6}});
  for (const char* text :
       {"# run 1\n4 2\n3 4\n# paused\n9 6\n", "# line 1\n4 2\n# line 2\n3 4\n# line 3\n9 6\n",
        "# block 1\n4 2\n3 4\n9 6\n# block 2 follows elsewhere\n", "4 2\n# 7 7\n3 4\n# 8 8\n9 6\n",
        "# 1.5e-3 2\n4 2\n3 4\n# 1.7e-3 2\n9 6\n", "#\n4 2\n3 4\n#\n9 6\n",
        "# x[m] y[m] z[m]\n0 0 4\n0 1 2\n# x[m] y[m] z[m]\n1 0 3\n1 1 4\n# block 3\n2 0 9\n2 1 6\n"}) {
    CAPTURE(text);
    CHECK(same(format::text.decode(text, {}).values, rows));
  }
}

TEST_CASE("a line of positions above a matrix is refused as coordinates are", "[formats][text][contract]") {
  const std::string rows = "5 3 7 1\n2 9 1 2\n", more = rows + "4 1 4 9\n";
  for (const std::string& text :
       {"0.00 0.50 1.00 1.50\n" + more, "0.00 0.50 1.00 1.50\n" + rows, "1.5 1 0.5 0\n" + more,
        std::string(";0;1;2\n0;5;3;7\n2;9;1;2\n"), std::string("nan 0 1 2\n0 5 3 7\n2 9 1 2\n")}) {
    CAPTURE(text);
    CHECK_THAT(refusal(text), ContainsSubstring("the first line looks like coordinates"));
    CHECK(refusal(text, told_columns("none")) == "read");
  }
  // A plane, and a line that is not the first.
  for (const char* text : {"0 1 2 3\n1 2 3 4\n2 3 4 5\n", "5 3 7 1\n0 1 2 3\n2 9 1 2\n"})
    CHECK(refusal(text) == "read");
}

TEST_CASE("the values of points may have any unit, x and y have one of length", "[formats][text][exact]") {
  const std::string text = "0 0 3\n0 1 4\n1 0 5\n1 1 9\n";
  const Map map = format::text.decode(text, told_columns("1/um,2/um,3/V"));
  CHECK(map.units == "V");
  CHECK(same(map.values, field({{3, 4}, {5, 9}})));
  CHECK(format::text.decode("x;u\n0;3\n1;4\n", told_columns("x/um,u/mV")).units == "mV");
  CHECK(format::text.decode("x;N/mm\n0;3\n1;4\n", told_columns("x/um,N/mm")).values.rows() == 2);
  CHECK_THAT(refusal(text, told_columns("1/V,2/um,3/V")),
             ContainsSubstring("'V' cannot be converted to 'm'"));
  CHECK_THAT(refusal(text, told_columns("1/um,2/um,3/nosuch")), ContainsSubstring("which is unknown"));
}

TEST_CASE("an order of lines is refused where points have none", "[formats][text][contract]") {
  Reading told = told_columns("1/um,2/um,3/nm");
  told.order = Order::yx;
  CHECK_THAT(refusal("0 0 3\n0 1 4\n1 0 5\n1 1 9\n", told), ContainsSubstring("(`from-order`)"));
}

TEST_CASE("UTF-16 without its mark is refused by its name", "[formats][text][contract]") {
  for (const bool big : {false, true}) {
    const std::string bytes = utf16(u"x [um];z [nm]\r\n0;3\r\n1;4\r\n", big).substr(2);
    for (const char* name : {"a.txt", "a.asc", "-"}) {
      CAPTURE(big, name);
      CHECK(format_of(bytes, name).name == "text");
    }
    CHECK_THAT(refusal(bytes),
               ContainsSubstring("looks like UTF-16 without its byte-order mark: save it as UTF-8"));
  }
  CHECK(known_format(std::string("\1\0\2\0\3\0\4\0", 8), "-") == nullptr);
}
