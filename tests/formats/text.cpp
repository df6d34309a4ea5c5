#include "formats/format.hpp"
#include "formats/text_numbers.hpp"
#include "formats/text_table.hpp"
#include "texts.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const double gap = std::nan("");

Reading reading(Separator separator, DecimalMark decimal = DecimalMark::any) {
  Reading out;
  out.separator = separator;
  out.decimal = decimal;
  return out;
}

}  // namespace

TEST_CASE("numbers are read as instruments and programs write them", "[formats][exact]") {
  CHECK(number_of("1.8823e-008") == 1.8823e-8);
  CHECK(number_of("+2.5") == 2.5);
  CHECK(number_of("-1,5E+003", Comma::decimal) == -1500.0);
  CHECK(number_of("-1,234,567.5", Comma::thousands) == -1234567.5);
  CHECK(number_of("1.5D-06") == 1.5e-6);
  CHECK(number_of("\u22122.5") == -2.5);
  CHECK(number_of("1e-400") == 0.0);
  for (const char* word : {"NaN", "-nan", "bad", "--", "---", "N/A"})
    CHECK(std::isnan(number_of(word).value()));
  for (const char* word : {"", "1.2.3", "1,5", "0x10", "e5", "1e", "+-1", "n", "-", "d5", "\u2212", "1,234"})
    CHECK(!number_of(word));
  for (const char* word : {"1,", ",5", "1.234,5", "1,234,567", "1.5"})
    CHECK(!number_of(word, Comma::decimal));
  for (const char* word : {"0,123", "1234,567", "1,23", "1,234e3"}) CHECK(!number_of(word, Comma::thousands));
}

TEST_CASE("a comma is decimal where another separator stands beside it", "[formats][exact]") {
  const Field expected = field({{1.5, 2}, {-3.25, 4e-9}});
  CHECK(same(matrix_of("1,5\t2\r\n-3,25\t4e-009\r\n", "map"), expected));
  CHECK(same(matrix_of("1,5;2\n-3,25;4e-9", "map"), expected));
  CHECK(same(matrix_of("1.5,2\n-3.25,4e-9\n", "map"), expected));
  CHECK(same(matrix_of("1.5, 2\n\n-3.25, 4e-9\n", "map"), expected));
}

TEST_CASE("a matrix is refused with the line that does not fit", "[formats][contract]") {
  CHECK_THROWS_WITH(matrix_of("1 2\n3\n", "map"), "line 2 has 1 number, the first line 2");
  CHECK_THROWS_WITH(matrix_of("1;2;3;\n4;5;6\n", "map"), "line 2 has 3 numbers, the first line 4");
  CHECK_THROWS_WITH(matrix_of("1 2\n3 1x\n", "map", 5), "line 6: '1x' is not a number");
  CHECK_THROWS_WITH(matrix_of("1 2\n3 x\n", "map", 5),
                    ContainsSubstring("line 6: 'x' is not a number: begin"));
  CHECK_THROWS_WITH(matrix_of("1 inf", "map"), "line 1: 'inf' is infinite");
  CHECK_THROWS_WITH(matrix_of(" \n\n", "map"), "the file has no numbers");
  CHECK_THROWS_WITH(matrix_of("X,Y\n1,2\n", "map"),
                    ContainsSubstring("line 1: 'X' is not a number: begin lines"));
  CHECK_THROWS_WITH(matrix_of("\xff\xfe\x31\0", "map"), ContainsSubstring("UTF-16"));
}

// Runs of separators counted as one: "1,,3" above "4,5," became two columns of shifted values.
TEST_CASE("an empty cell is a missing point, wherever it stands", "[formats][exact]") {
  const Field holes = field({{1, gap, 3}, {4, 5, gap}, {gap, 8, 9}, {7, 8, gap}});
  CHECK(same(matrix_of("1,,3\n4,5,\n,8,9\n7,8,\n", "map"), holes));
  CHECK(same(matrix_of("1;;3\n4;5;\n;8;9\n7;8;\n", "map"), holes));
  CHECK(same(matrix_of("1\t\t3\r\n4\t5\t\r\n\t8\t9\r\n7\t8\t\r\n", "map"), holes));
  CHECK(same(matrix_of("1, ,3\n4,5, \n,8,9\n7,8,\n", "map"), holes));
  CHECK(same(matrix_of("1;2\n;\n3;4\n", "map"), field({{1, 2}, {gap, gap}, {3, 4}})));
  CHECK(same(matrix_of("1,5;;3\n4;5;\n", "map"), field({{1.5, gap, 3}, {4, 5, gap}})));
}

TEST_CASE("a separator at the end of every line adds no column", "[formats][exact]") {
  const Field whole = field({{1, 2, 3}, {4, 5, 6}});
  for (const char* text :
       {"1;2;3;\n4;5;6;\n", "1,2,3,\n4,5,6,\n", "1\t2\t3\t\n4\t5\t6\t\n", " 1 2 3 \n 4 5 6 \n"})
    CHECK(same(matrix_of(text, "map"), whole));
}

TEST_CASE("the ends of lines, a byte-order mark and comments are no numbers", "[formats][exact]") {
  const Field whole = field({{1, 2}, {4, 3}});
  for (const char* text : {"\xef\xbb\xbf"
                           "1 2\r\n4 3\r\n",
                           "1\t2\r4\t3\r", "% x\n1,2.0\n; y\n\n4,3\n# 5 6\n"})
    CHECK(same(matrix_of(text, "map"), whole));
  CHECK(same(matrix_of("3.5", "map"), field({{3.5}})));
  CHECK(same(matrix_of("1\n2\n3\n", "map"), field({{1}, {2}, {3}})));
  CHECK(same(matrix_of("1;2;3", "map"), field({{1, 2, 3}})));
}

// "1.234,5;2.000,5" became four columns, "1,234" one thing or the other by the other lines.
TEST_CASE("what can be read in two ways is refused until it is told, thousands too", "[formats][contract]") {
  const std::string both = "1,5\n2,5\n";
  CHECK_THAT(refusal(both), ContainsSubstring("the `separator` or the `decimal` mark"));
  CHECK(same(matrix_of(both, "map", 1, reading(Separator::comma)), field({{1, 5}, {2, 5}})));
  CHECK(
      same(matrix_of(both, "map", 1, reading(Separator::any, DecimalMark::point)), field({{1, 5}, {2, 5}})));
  CHECK(same(matrix_of(both, "map", 1, reading(Separator::any, DecimalMark::comma)), field({{1.5}, {2.5}})));
  for (const char* text : {"1,234", "1,234 5,678\n", "1,234.5\n2,000.5\n", "1\t\t2\n3\t\t4\n"})
    CHECK_THAT(refusal(text), ContainsSubstring("the `separator` or the `decimal` mark"));
  CHECK_THAT(refusal("1,5 2.500\n"), ContainsSubstring("write one decimal mark"));
  CHECK_THAT(refusal("1,234 2.500\n"), ContainsSubstring("the `separator` or the `decimal` mark"));
  CHECK(same(matrix_of("1.234,5;2.000,5\n", "map"), field({{1234.5, 2000.5}})));
  CHECK(same(matrix_of("1.234.567,8 2\n", "map"), field({{1234567.8, 2}})));
  CHECK(same(matrix_of("1'234.5 2\u202f000\n", "map"), field({{1234.5, 2000}})));
  CHECK(same(matrix_of("1,234 5,678\n", "map", 1, reading(Separator::blank, DecimalMark::point)),
             field({{1234, 5678}})));
  CHECK(same(matrix_of("1,234.5 2,000\n3.5 1\n", "map"), field({{1234.5, 2000}, {3.5, 1}})));
  CHECK_THAT(refusal("1.23,5;2.000,5\n"), ContainsSubstring("thousands"));
  CHECK_THROWS_AS(matrix_of("1,5", "map", 1, reading(Separator::comma, DecimalMark::comma)), ParameterError);
}

// Lines of x z and x y z became maps of two and three columns.
TEST_CASE("columns that look like coordinates are refused until it is told what they are",
          "[formats][contract]") {
  const char* texts[] = {"0 3\n0.1 2\n0.2 7\n",
                         "3 1\n2 5\n1 1\n",
                         "0 0 3\n0 1 4\n1 0 5\n1 1 9\n",
                         "0 0 3\n1 0 4\n0 1 5\n1 1 9\n2 0 3\n",
                         "0 5 3\n1.1 2 4\n2 9 5\n2.9 4 9\n",
                         "1 7 9 2 4\n2 8 8 1 1\n3 2 6 5 3\n",
                         "0 0 5\n0 1 6\n0 2 7\n",
                         ";0;1;2\n0;5;3;7\n2;9;1;2\n4;4;4;9\n",
                         "0;2;1;0\n0;5;3;7\n2;9;1;2\n4;4;4;9\n"};
  for (const char* text : texts) {
    CAPTURE(text);
    CHECK_THAT(refusal(text), ContainsSubstring("all are heights (`xyz` none)"));
    Reading matrix;
    matrix.columns = "none";
    CHECK(refusal(text, matrix) == "read");
  }
  CHECK(refusal("2 4 6\n3 5 7\n4 6 8\n5 7 9\n") == "read");
  CHECK(refusal("7 1 9 2\n0 7 3 7\n2 9 1 2\n4 4 4 9\n") == "read");
  CHECK(refusal("0 0 0\n0 0 0\n0 0 0\n0 0 0\n") == "read");
  CHECK(refusal("3 1 2\n1 5 7\n2 2 2\n9 1 4\n2 8 6\n") == "read");
  CHECK(refusal("1 2 3\n4 5 6\n7 8 9\n") == "read");
}

TEST_CASE("a text matrix has a line for each x, or as asked for each y, and may state its unit",
          "[formats][exact]") {
  const Map xy = format::text.decode("# a comment 1 2\n# units: nm\n1 2 3\n4 5 6\n", Order::xy);
  CHECK(shape_of(xy.values) == Shape{2, 3});
  CHECK(xy.values(1, 0) == 4e-9);
  CHECK(xy.units == "m");
  const Map yx = format::text.decode("1 2 3\n4 5 6\n", Order::yx);
  CHECK(shape_of(yx.values) == Shape{3, 2});
  CHECK(yx.values(2, 1) == 6);
  CHECK(yx.units.empty());
  for (const Order order : {Order::xy, Order::yx})
    CHECK(same(format::text.decode(format::text.encode(map_with_holes(), order), order).values,
               map_with_holes().values));
}

// 3 × 4 points over 12.34 µm × 5678.9 nm; a line is a y.
TEST_CASE("Gwyddion's text export is read with the units of its width, height and values",
          "[formats][exact]") {
  const std::string bytes = data_file("gwyddion-head.txt");
  REQUIRE(format::gwyddion_text.recognises(bytes));
  const Map map = format::gwyddion_text.decode(bytes, Order::xy);
  Field lines(4, 3);
  lines << 1, 1.5, 3, -2, -3, -6, 0, 0, 0, 9, 9, 9;
  CHECK(same(map.values.transpose(), lines));
  CHECK(relative_error(map.spacing[0], 12.34e-6 / 3) <= 4 * epsilon);
  CHECK(relative_error(map.spacing[1], 5678.9e-9 / 4) <= 4 * epsilon);
  CHECK(map.units == "m");
  CHECK(map.title == "My Channel Name");
}

TEST_CASE("Gwyddion's text export is read in German, with decimal commas", "[formats][exact]") {
  const Map map = format::gwyddion_text.decode(
      "# Kanal: Höhe\r\n# Breite: 1,50 nm\r\n# Höhe: 3,0 µm\r\n# Werteinheiten: nm\r\n1,5\t-2,5e-001\t4\r\n",
      Order::xy);
  CHECK(relative_error(map.spacing[0], 0.5e-9) <= 4 * epsilon);
  CHECK(relative_error(map.spacing[1], 3e-6) <= 4 * epsilon);
  CHECK(relative_error(map.values(1, 0), -0.25e-9) <= 2 * epsilon);
  CHECK(map.title == "Höhe");
}

// Sizes are written as products and divided again: an epsilon each.
TEST_CASE("what is written as Gwyddion's text is read again the same, missing points too",
          "[formats][exact]") {
  const Map map = map_with_holes();
  const Map again = format::gwyddion_text.decode(format::gwyddion_text.encode(map, Order::xy), Order::xy);
  CHECK(same(again.values, map.values));
  CHECK(relative_error(again.spacing[0], map.spacing[0]) <= 2 * epsilon);
  CHECK(relative_error(again.spacing[1], map.spacing[1]) <= 2 * epsilon);
}

// A third size, or a second unit, was passed over; a unit above the sizes was taken for the title.
TEST_CASE("Gwyddion's text with another size or unit is refused, one with an unknown unit too",
          "[formats][contract]") {
  const std::string sizes = "# Width: 2 um\n# Height: 1 um\n";
  const auto refused = [](const std::string& head, const char* words) {
    CHECK(format::gwyddion_text.recognises(head));
    CHECK_THROWS_WITH(format::gwyddion_text.decode(head + "1 2\n", {}), ContainsSubstring(words));
  };
  refused(sizes + "# Width: 3 um\n", "3 sizes, not a width and a height");
  refused(sizes + "# Value units: nm\n# Value units: um\n", "the unit 'nm' and the unit 'um'");
  refused("# Width: 2 px\n# Height: 1 px\n", "'px'");
  const Map map =
      format::gwyddion_text.decode("# Map\n# Value units: nm\n" + sizes + "# Date: 12 May 2024\n1 2\n", {});
  CHECK(relative_error(map.values(1, 0), 2e-9) <= 2 * epsilon);
}

// A head that states the size, numbers that do not fill a rectangle, or some of them missing.
TEST_CASE("formats of text with a head have missing points and refuse what is ragged as a bare matrix does",
          "[formats][contract]") {
  const std::string gwyddion = "# Width: 3 um\n# Height: 2 um\n", esri = "ncols 3\nnrows 2\ncellsize 1\n";
  CHECK(same(format::gwyddion_text.decode(gwyddion + "1\t\t3\n4\t5\t---\n", {}).values,
             field({{1, gap, 3}, {4, 5, gap}}).transpose()));
  CHECK_THROWS_WITH(format::gwyddion_text.decode(gwyddion + "1\t2\t3\n4\t5\n", {}),
                    "line 4 has 2 numbers, the first line 3");
  const Format& grid = format_named("esri", "from");
  CHECK(same(grid.decode(esri + "1,,3\n4,5,\n6", {}).values, field({{4, 1}, {5, gap}, {6, 3}})));
  CHECK(same(grid.decode(esri + "\t1\t2\t\t3\n4\t5\t6", {}).values, field({{4, 1}, {5, 2}, {6, 3}})));
  CHECK_THROWS_WITH(grid.decode(esri + "1 2 3\n4 5 6\n7", {}), ContainsSubstring("the file has 7 numbers"));
  CHECK_THROWS_WITH(grid.decode(esri + "1,234 2 3\n4 5 6", {}), ContainsSubstring("the `decimal` mark"));
}

// Of these, all but the exact "Units: nm" and "Height (nm)" were read as metres.
TEST_CASE("a unit that the head gives the values is used, in whatever words, and that of x and y is not",
          "[formats][text][exact]") {
  const std::string rows = "\n1 7 2 5 3\n2 3 4 9 1\n";
  for (const char* head : {"z unit: nm",
                           "\\Exported image units: nm",
                           "Height units = nm",
                           "Z [nm]",
                           "(nm)",
                           "nm",
                           "nm;nm;nm;nm;nm",
                           "# z-unit = nm",
                           "Value units: nm",
                           "Einheit: nm",
                           "Höheneinheit: nm",
                           "Alle Werte in nm",
                           "All values are in nanometers",
                           "data in Nanometer",
                           "# x in mm, y in mm, z in nm",
                           "xy unit: um; z unit: nm",
                           "XUnits = um\nZUnits = nm",
                           "Pixel size: 0.5 um\nUnits: nm",
                           "z/nm",
                           "Messwerte/nm",
                           "Units: x um, y um, z nm",
                           "H\xf6he nm",
                           "Rauheit [nm]",
                           "UNITS NM",
                           "# Values in units of nm",
                           "# units: 1e-9 m",
                           "Z scale = 1\nheights in nm",
                           "Wavelength (um): 0.6328\nUnits: nm",
                           "Cutoff [mm] 0.8\nZ [nm]"}) {
    CAPTURE(head);
    CHECK(relative_error(format::text.decode(head + rows, {}).values(0, 1), 7e-9) <= 2 * epsilon);
  }
  CHECK(format::text.decode("Einheit Mikrometer" + rows, {}).values(0, 0) == 1e-6);
  CHECK(format::text.decode("Value units: V" + rows, {}).units == "V");
  for (const char* head :
       {"pixel size: 0.5 um", "Pixel size (um)", "Lateral units: um", "xy unit: um", "Scan size: 10 um",
        "Stylus radius: 12.5 um", "Radius;12.5;um", "Scan line : 150. [um]", "Wavelength (nm): 632.8",
        "Cutoff [mm]\t0.8", "Height range: 12 nm", "Date: 12 May 2024 10:30 pm", "Mode: point\nDirection: in",
        "Force unit: nN", "Zoom factor: 2.5"}) {
    CAPTURE(head);
    CHECK(
        format::text.decode(head + ("\n1 7 2 5 3 8 6" + std::string("\n2 3 4 9 1 5 7\n")), {}).units.empty());
  }
  CHECK(format::text.decode("Pixel size (um)\n1\n7\n2\n", {}).units.empty());
  CHECK(format::esri.decode("ncols 2\nnrows 1\nzunits nm\ncellsize 1e-6\n1 2\n", {}).values(0, 0) == 1e-9);
  CHECK(format::gwyddion_text.decode("# Value units: nm\n# Width: 2 um\n# Height: 1 um\n1 2\n", {})
            .values(0, 0) == 1e-9);
}

TEST_CASE("a unit in the head that may be another's, or a factor of the heights, is refused until it is told",
          "[formats][text][contract]") {
  Reading told;
  told.unit_told = true;
  for (const auto& [head, words] :
       {std::pair{"Length unit: um", "line 1: 'um' may be the unit of the values"},
        {"Surface map (um)", "'um' may be"},
        {"Measured [V]", "'V' may be"},
        {"h=2 w=6\npixel size=3.7e-007 m\ndata unit=rad\nheight conversion factor (-> m)=6.3e-008",
         "line 4: a factor"},
        {"Z scale: 100 nm", "a factor"},
        {"Z-Faktor: 1,5", "a factor"},
        {"# Bit2nm = 0.05", "a factor"},
        {"heights in 1e-9 m", "a factor"},
        {"Units: mm, mm, nm", "'mm' and the unit 'nm'"}}) {
    CAPTURE(head);
    const std::string text = std::string(head) + "\n1 7 2 5 3 6 8 1\n2 3 4 9 1 2 6 5\n";
    CHECK_THAT(refusal(text), ContainsSubstring(words) && ContainsSubstring("(`unit`"));
    CHECK(format::text.decode(text, told).units.empty());
  }
  CHECK_THAT(refusal("a [nm];b\n1;2\n5;2\n"), ContainsSubstring("the units 'nm' and ''"));
  CHECK_THAT(refusal("# units: nm\n1 2\n# units: um\n"), ContainsSubstring("perhaps a second one"));
  CHECK_THAT(refusal("# spacing: 1 1\n# spacing: 1 2\n1 2\n"), ContainsSubstring("'1 1' and '1 2'"));
}
