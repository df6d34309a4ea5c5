// Points x z and x y z in text: which columns they are, and the grid that they lie on.
#include "texts.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const double gap = std::nan("");

std::string lines_of(const std::vector<double>& xs, const char* form) {
  std::string out;
  for (const double x : xs) {
    char number[64];
    std::snprintf(number, sizeof number, form, x);
    out += std::string(number) + " " + std::to_string(out.size() % 7) + "\n";
  }
  return out;
}

std::vector<double> multiples(double step, int count) {
  std::vector<double> out;
  for (int i = 0; i < count; ++i) out.push_back(i * step);
  return out;
}

}  // namespace

// A step is a difference divided by a count, then in metres: two roundings.
TEST_CASE(
    "points of a grid make a map, in whatever order they come, and those that are not there are missing",
    "[formats][text][exact]") {
  const Field expected = field({{1, 2}, {3, gap}, {5, 6}});
  const char* texts[] = {"0 0 1\n0 3 2\n1 0 3\n2 0 5\n2 3 6\n", "2,3,6\n1,0,3\n0,3,2\n2,0,5\n0,0,1\n",
                         "0.00 0 1\n1.01 0 3\n2 0 5\n0 3 2\n2 3 6\n1 3 nan\n",
                         "x [um];y/um;z in m\n0;0;1\n;;\n0;3;2\n1;0;3\n2;0;5\n2;3;6\n;;\n"};
  for (const char* text : texts) {
    CAPTURE(text);
    const Map map = format::text.decode(text, told_columns("1/um,2/um,3/m"));
    CHECK(same(map.values, expected));
    CHECK(relative_error(map.spacing[0], 1e-6) <= 2 * epsilon);
    CHECK(relative_error(map.spacing[1], 3e-6) <= 2 * epsilon);
  }
  const Map profile = format::text.decode("2 5\n1 7\n0 9\n", told_columns("1/mm,2/m"));
  CHECK(same(profile.values, field({{9}, {7}, {5}})));
  CHECK(profile.spacing == std::array{1e-3, 1e-3});
}

TEST_CASE("labels with units say what the columns are, and any columns can be asked for by name or number",
          "[formats][text][exact]") {
  const Field heights = field({{3e-9, 4e-9}, {5e-9, 9e-9}});
  const char* texts[] = {"x [mm],y [mm],z [nm]\n0,0,3\n0,1,4\n1,0,5\n1,1,9\n",
                         "# x [mm] y [mm] z [nm]\n0 0 3\n0 1 4\n1 0 5\n1 1 9\n",
                         "Point\tX\tY\tZ\n\tmm\tmm\tnm\n1\t0\t0\t3\n2\t0\t1\t4\n3\t1\t0\t5\n4\t1\t1\t9\n",
                         "Height (nm);X Pos (mm);Y Pos (mm)\n3;0;0\n4;0;1\n5;1;0\n9;1;1\n",
                         "\"x, mm\",\"y, mm\",\"z, nm\"\n0,0,3\n0,1,4\n1,0,5\n1,1,9\n"};
  for (const char* text : texts) {
    CAPTURE(text);
    const Map map = format::text.decode(text, {});
    CHECK((map.values - heights).abs().maxCoeff() <= 2 * epsilon * 9e-9);
    CHECK(map.spacing == std::array{1e-3, 1e-3});
  }
  CHECK(format::text.decode("Position (um),Height (nm)\n0,350\n1,250\n", {}).values.rows() == 2);
  const std::string four = "x [mm];y [mm];raw [nm];filtered [nm]\n0;0;9;3\n0;1;9;4\n1;0;9;5\n1;1;8;9\n";
  CHECK_THAT(refusal(four), ContainsSubstring("the columns are x, y, raw, filtered"));
  for (const char* columns : {"x,y,filtered", "1,2,4", "X,Y,4/nm"})
    CHECK((format::text.decode(four, told_columns(columns)).values - heights).abs().maxCoeff() <=
          2 * epsilon * 9e-9);
  CHECK_THAT(refusal(four, told_columns("x,y,z")), ContainsSubstring("the text has x, y, raw, filtered"));
  CHECK_THAT(refusal(four, told_columns("1,2,5")), ContainsSubstring("4 columns"));
  CHECK_THAT(refusal(four, told_columns("x/um,y,3")), ContainsSubstring("the text has 'mm'"));
  CHECK_THAT(refusal(four, told_columns("1,1,3")), ContainsSubstring("twice"));
  CHECK_THAT(refusal(four, told_columns("um")), ContainsSubstring("a unit without a column"));
  CHECK_THAT(refusal(four, told_columns("1,2,3,4")), ContainsSubstring("x,y,z"));
  const Field alone = format::text.decode(four, told_columns("4/nm")).values / 1e-9;
  CHECK((alone - field({{3}, {4}, {5}, {9}})).abs().maxCoeff() <= 2 * epsilon * 9);
}

// Between points z is a straight line: exact where z is one, and at places that are points.
TEST_CASE("a profile of uneven points is read at even places, by straight lines, and told",
          "[formats][text][exact]") {
  for (const char* text : {"0.00 1\n1.00 2\n2.23 3\n", "2.23 3\n1.00 2\n0.00 1\n"}) {
    const Map map = format::text.decode(text, told_columns("1/um,2/m"));
    CHECK(map.spacing == std::array{1.115e-6, 1.115e-6});
    CHECK((map.values - Field{{1}, {2 + 0.115 / 1.23}, {3}}).abs().maxCoeff() <= 8 * epsilon * 3);
    CHECK_THAT(map.understood, ContainsSubstring("by 1e-06 to 1.23e-06 m: read at 3 even places"));
  }
  // Of 0, 1, … 9, 10.3 and 30 the mean step is 30/11: no line crosses the gap of 19.7.
  std::string gap;
  for (int k = 0; k < 10; ++k) gap += std::to_string(k) + ".0 " + std::to_string(k) + "\n";
  const Map map = format::text.decode(gap + "10.3 10.3\n30.0 30\n", told_columns("1/um,2/m"));
  for (Index i = 0; i < 12; ++i) {
    CAPTURE(i);
    const double x = 30.0 / 11 * static_cast<double>(i);
    CHECK(std::isnan(map.values(i, 0)) == (x > 10.3));
    if (x < 10.3) CHECK(map.values(i, 0) == Approx(x));
  }
  CHECK_THAT(map.understood, ContainsSubstring("heights are missing"));
}

// 2.2 was taken for a tenth of spacings off; 1 is now off by half a digit. An uneven profile with a place given
// twice was refused as uneven.
TEST_CASE("points that are no grid are refused", "[formats][text][contract]") {
  const Reading profile = told_columns("1/m,2/m"), map = told_columns("1/m,2/m,3/m");
  CHECK_THAT(refusal("0.00 0 1\n1.00 0 2\n2.23 0 3\n", map),
             ContainsSubstring("not evenly spaced to their printed digits: 1 is off by 0.1 spacings"));
  CHECK_THAT(refusal("0 0 1\n1 1 2\n2 2 3\n3 3 4\n", map),
             ContainsSubstring("fill less than half of a grid of 4 x 4"));
  CHECK_THAT(refusal("0 1\n1 2\n1 3\n", profile), ContainsSubstring("x = 1 is given twice"));
  for (const char* uneven : {"0 1\n1 2\n1 3\n4.5 2\n", "0 1\n4.5 2\n1 2\n1 3\n", "9 1\n2.5 4\n1 2\n1 3\n"})
    CHECK_THAT(refusal(uneven, profile), ContainsSubstring("x = 1 is given twice"));
  CHECK_THAT(refusal("0 1\n1 2\nnan 3\n", profile), ContainsSubstring("a coordinate x is missing"));
  CHECK_THAT(refusal("1 2\n", profile), ContainsSubstring("at least 2 points"));
  CHECK_THAT(refusal("x;z\n0;1\n1;2\n", {}),
             ContainsSubstring("no unit of x") && ContainsSubstring("1/um,2/nm"));
  // The example named columns 1, 2 and 3, so that it transposed this map.
  CHECK_THAT(refusal("y,x,z\n0,5,3\n1,5,4\n0,6,5\n", {}), ContainsSubstring("`xyz` 2/um,1/um,3/nm"));
  CHECK_THAT(refusal("y,x [mm],z\n0,5,3\n1,5,4\n0,6,5\n", {}), ContainsSubstring("`xyz` 2,1/um,3/nm"));
  CHECK_THAT(refusal("Raw,y,x,Height\n9,0,5,3\n9,1,5,4\n9,0,6,5\n", {}),
             ContainsSubstring("`xyz` 3/um,2/um,4/nm"));
  CHECK_THAT(refusal("x [mm];z\n0;1\n1;2\n", {}), ContainsSubstring("no unit of z"));
  CHECK_THAT(refusal("t [s];z [um]\n0;1\n1;2\n2;4\n", {}), ContainsSubstring("look like coordinates"));
}

// Rounded to the last digit u, ends and points are off by u/2 each: the spacing by u over the count of steps.
TEST_CASE("a grid is found to the digits of its coordinates, and to those of single precision",
          "[formats][text][exact]") {
  struct Case {
    const char* form;
    double step;
    int count;
    double digit;  // of the ends
  };
  for (const auto& [form, step, count, digit] :
       {Case{"%.2f", 1.0 / 3, 50, 0.01}, Case{"%.3g", 1.0 / 3, 20, 0.01}, Case{"%.18e", 0.1, 300, 0},
        Case{"%.1f", 0.7, 40, 0.1}, Case{"%.6g", 0.5e-3, 1000, 1e-6}, Case{"%.0f", 20, 9, 1}}) {
    CAPTURE(form, step);
    const Map map = format::text.decode(lines_of(multiples(step, count), form), told_columns("1/m,2/m"));
    REQUIRE(map.values.rows() == count);
    CHECK(std::abs(map.spacing[0] - step) <= digit / (count - 1) + 4 * epsilon * step);
  }
  std::vector<double> single;
  for (int i = 0; i < 400; ++i) single.push_back(static_cast<double>(static_cast<float>(i) * 0.1f));
  for (const char* form : {"%.9g", "%.17g"})
    CHECK(format::text.decode(lines_of(single, form), told_columns("1/m,2/m")).values.rows() == 400);
}

TEST_CASE("whole lines of a grid may be missing, and too few digits to tell are refused",
          "[formats][text][contract]") {
  const Reading profile = told_columns("1/m,2/m");
  const Map map = format::text.decode("0.0 1\n0.1 2\n0.4 3\n0.5 4\n", profile);
  CHECK(same(map.values, field({{1}, {2}, {gap}, {gap}, {3}, {4}})));
  CHECK_THAT(refusal("0 1\n3 2\n5 3\n8 4\n10 5\n", profile), ContainsSubstring("too few digits"));
}
