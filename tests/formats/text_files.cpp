// Texts as programs and instruments write them: each a few lines, in the form of the real ones.
#include "texts.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const double gap = std::nan("");

// In units of the file, with a rounding by the factor and one by the division.
void check(const std::string& bytes, const Field& heights, double unit, double dx, double dy) {
  CAPTURE(bytes);
  const Map map = format::text.decode(bytes, {});
  REQUIRE(shape_of(map.values) == shape_of(heights));
  const Field error = (map.values / unit - heights).abs();
  CHECK((error.isNaN() == heights.isNaN()).all());
  CHECK(error.isNaN().select(0, error).maxCoeff() <=
        4 * epsilon * heights.isNaN().select(0, heights).abs().maxCoeff());
  CHECK(relative_error(map.spacing[0], dx) <= 4 * epsilon);
  CHECK(relative_error(map.spacing[1], dy) <= 4 * epsilon);
}

}  // namespace

TEST_CASE(
    "Excel's files are read: German CSV, UTF-8 with its mark, Unicode text, rows padded with separators",
    "[formats][text][exact]") {
  const Field z = field({{1.5}, {-2.25}, {1234.5}});
  check(
      "Messung 1;\r\nDatum;12.03.2024\r\nPunkte;3\r\n;\r\nX [mm];Z "
      "[µm]\r\n0,0;1,5\r\n0,1;-2,25\r\n0,2;1.234,5\r\n",
      z, 1e-6, 1e-4, 1e-4);
  check("\xef\xbb\xbf\"X [mm]\";\"Z [nm]\"\r\n\"0,0\";\"1,5\"\r\n\"0,1\";\"-2,25\"\r\n\"0,2\";\"1234,5\"\r\n",
        z, 1e-9, 1e-4, 1e-4);
  for (const bool big : {false, true})
    check(utf16(u"Weg (mm)\tHöhe (\u00b5m)\r\n0,0\t1,5\r\n0,1\t-2,25\r\n0,2\t1.234,5\r\n", big), z, 1e-6,
          1e-4, 1e-4);
  check("X [mm];Z [\xb5m];;\r\n0,0;1,5;;\r\n0,1;-2,25;;\r\n0,2;1234,5;;\r\n", z, 1e-6, 1e-4, 1e-4);
}

TEST_CASE("files of profilers are read: a head of names and values, then position and height",
          "[formats][text][exact]") {
  const Field z = field({{3.5}, {gap}, {-4.25}, {5}});
  check(
      "Meta Data\nScan Type,Standard Scan\nStylus,Radius: 12.5 um\nDuration,60\n\n"
      "Lateral (um),Total Profile (nm)\n0.0,3.5\n0.5,\n1.0,-4.25\n1.5,5\n",
      z, 1e-9, 0.5e-6, 0.5e-6);
  check("# Surface profile\r# x/um z/um\r0.0\t3.5\r0.5\t***\r1.0\t-4.25\r1.5\t5\r", z, 1e-6, 0.5e-6, 0.5e-6);
  check("\"position (mm)\", \"height (um)\"\n0.0, 3.5\n0.5, --\n1.0, -4.25\n1.5, 5\n", z, 1e-6, 0.5e-3,
        0.5e-3);
}

TEST_CASE("tables of plotting programs are read: names, units and comments in rows of their own",
          "[formats][text][exact]") {
  const Field z = field({{1, 2}, {gap, 4}, {5, 6}});
  check("A(X)\tB(Y)\tC(Z)\nmm\tmm\tum\n\t\tComments\n0\t0\t1\n0\t2\t2\n1\t2\t4\n2\t0\t5\n2\t2\t6\n", z, 1e-6,
        1e-3, 2e-3);
  check("x,y,z\nmm,mm,um\n2,2,6\n0,0,1\n1,2,4\n0,2,2\n2,0,5\n1,0,--\n", z, 1e-6, 1e-3, 2e-3);
}

TEST_CASE("a matrix below lines of words has the unit that they state", "[formats][text][exact]") {
  const Field lines = field({{1.5, 7}, {2, 3}});
  for (const char* text : {"Height (nm)\n1.5 7\n2 3\n", "--- Sample 1 ---\nUnits: nm\n\n1.5\t7\n2\t3\n",
                           "# units: nm\n1.5,7.0\n2,3\n", "Profile 1 [nm];Profile 2 [nm]\n1,5;7,0\n2;3\n",
                           "Z unit;nm\n1,5;7,0\n2;3\n"}) {
    CAPTURE(text);
    const Map map = format::text.decode(text, {});
    CHECK((map.values / 1e-9 - lines).abs().maxCoeff() <= 2 * epsilon * 7);
    CHECK(map.units == "m");
  }
  CHECK_THAT(refusal("Units: nm\nHeight (um)\n1 2\n"), ContainsSubstring("'nm' and the unit 'um'"));
  CHECK_THAT(refusal("a [nm];b [um]\n1;2\n5;2\n"), ContainsSubstring("'nm' and 'um'"));
}

// Each would lose a line of numbers, or a part of one, without a word.
TEST_CASE("no line that may have been meant as numbers passes for words above them",
          "[formats][text][contract]") {
  for (const char* text :
       {"*** 1 2\n3 4 5\n7 1 2\n? 3 4\n", "? 3 4\n5 9 7\n", "err err err\n5 9 7\n1 1 7\n",
        "1,5;x2\n1;2\n4;3\n", "x [mm];z [um]\nO,5;1,5\n1,0;2,5\n2,0;2,5\n", "? ?\n1 2\n3 1\n",
        "1,5\n2,5x\n3\n4\n", "NoDat 3 4\n5 9 7\n", "x [um];z [um]\n0;1;2h3;4\n2;4\n3;5\n",
        "1 2\n3 1\nand then\n1 2\n3 4\n", "0,5;1,5\n0,7;x\n1;2\n", "1.5 2\nend\n3 4\n"}) {
    CAPTURE(text);
    CHECK_THAT(refusal(text), ContainsSubstring("is not a number"));
  }
}

TEST_CASE("words and numbers that are told mean missing points, in every text that has them",
          "[formats][text][exact]") {
  Reading told;
  told.missing = {"-9999", "x1"};
  CHECK(same(format::text.decode("1 -9999.0 3\nx1 5 6\n", told).values, field({{1, gap, 3}, {gap, 5, 6}})));
  CHECK(same(format::gwyddion_text.decode("# Width: 3 um\n# Height: 2 um\n1 -9999 3\n4 5 x1\n", told).values,
             field({{1, gap, 3}, {4, 5, gap}}).transpose()));
}

TEST_CASE("what this program writes as text is read again to the last bit, whatever is asked for",
          "[formats][text][exact]") {
  for (const Order written : {Order::xy, Order::yx})
    for (const Order asked : {Order::xy, Order::yx}) {
      const Map map = map_with_holes(), again = format::text.decode(format::text.encode(map, written), asked);
      CHECK(same(again.values, map.values));
      CHECK(again.spacing == map.spacing);
      CHECK(format::text.encode(again, written) == format::text.encode(map, written));
    }
  const std::string steps = format::text.encode({.values = field({{0, 3}, {1, 2}, {2, 7}})}, Order::xy);
  CHECK(refusal(steps) == "read");
  CHECK_THAT(refusal(steps + steps), ContainsSubstring("perhaps a second one"));
  CHECK_THAT(refusal("# spacing: 1 0\n1 2\n"), ContainsSubstring("two positive numbers"));
  CHECK_THAT(refusal("# order: zx\n1 2\n"), ContainsSubstring("none of xy|yx"));
}

TEST_CASE("a line says how a text was read", "[formats][text][contract]") {
  CHECK_THAT(format::text.decode("x [um];y [um];z [nm]\n0;0;3\n0,5;0;4\n0;0,5;5\n", {}).understood,
             ContainsSubstring("a map of 2 x 2, points x y z, spacing 5e-07 m, 1 point missing, separated by "
                               "semicolons and decimal commas, below 1 line of words, values in nm"));
  Map map = format::text.decode("1 2\n3 1\n", Order::yx);
  CHECK_THAT(map.understood,
             Catch::Matchers::EndsWith("a line for each y, no size given, separated by blanks"));
  map.spacing = {1, 1};
  CHECK_THAT(dataset_of(map).notes.at(0), Catch::Matchers::EndsWith("blanks, no unit given: metres assumed"));
  map.understood.clear();
  CHECK(dataset_of(map).notes == std::vector<std::string>{"no unit given: metres assumed"});
  Reading told;
  told.missing = {"-9999", "999", "xx"};
  CHECK_THAT(format::text.decode("1 xx\n-9999.0 4\n", told).understood,
             Catch::Matchers::EndsWith("blanks, no cell is '999'"));
}

// Above a thousand of other lines, a unit was not seen: heights of 1e-6 m became heights of 1 m.
TEST_CASE("what comments state counts however many there are", "[formats][text][contract]") {
  std::string text = "# units: um\n# spacing: 2e-6 3e-6\n# order: yx\n";
  for (int i = 0; i < 1000; ++i) text += "# a comment\n";
  const Map map = format::text.decode(text + "1 2\n3 4\n", {});
  CHECK(same(map.values, 1e-6 * field({{1, 3}, {2, 4}})));
  CHECK(map.spacing == std::array{2e-6, 3e-6});
  std::string words = "Height (um)\n";
  for (int i = 0; i < 1000; ++i) words += "Sample of a series\n";
  CHECK(same(format::text.decode(words + "1 2\n3 4\n", {}).values, 1e-6 * field({{1, 2}, {3, 4}})));
  for (int i = 0; i < 65536; ++i) words += "Sample\n";
  CHECK_THAT(refusal(words + "1 2\n3 4\n"), ContainsSubstring("more than 65536 lines of words"));
}

// Heights of a German table in whole numbers became a thousandth.
TEST_CASE("points that may stand between thousands are refused until it is told",
          "[formats][text][contract]") {
  for (const char* text : {"481 1.234\n1.500 12.481\n", "x [um];z [nm]\n0;481\n1;1.234\n2;2.056\n"})
    CHECK_THAT(refusal(text), ContainsSubstring("the point of '1.") && ContainsSubstring("`decimal` mark"));
  Reading told;
  told.decimal = DecimalMark::comma;
  CHECK(same(format::text.decode("481\n1.234\n", told).values, field({{481}, {1234}})));
  told.decimal = DecimalMark::point;
  CHECK(same(format::text.decode("481\n1.234\n", told).values, field({{481}, {1.234}})));
  // A column of one kind, a fourth digit, a zero before the point or another count behind it tell enough.
  CHECK(same(format::text.decode("1 1.234\n2 2.056\n", {}).values, field({{1, 1.234}, {2, 2.056}})));
  for (const char* more : {"1234\n", "0.125\n", "1.5\n", "1.2345\n", "1.234e0\n"}) {
    CAPTURE(more);
    CHECK(format::text.decode(std::string("481\n1.234\n") + more, {}).values(1, 0) == 1.234);
  }
}

// Two maps of a file became one.
TEST_CASE("blocks of a matrix that empty lines part are refused, an empty line below each is not",
          "[formats][text][contract]") {
  for (const char* text : {"4 2\n3 4\n\n9 6\n7 8\n", "1\n2\n \n# second\n3\n", "4 2\n\n3 4\n9 6\n"}) {
    CAPTURE(text);
    CHECK_THAT(refusal(text), ContainsSubstring("below an empty line: a file holds one map"));
  }
  const Field rows = field({{4, 2}, {3, 4}, {9, 6}});
  for (const char* text : {"4 2\r\r\n3 4\r\r\n9 6\r\r\n", "\n4 2\n3 4\n9 6\n\n\n", "4 2\n\n\n3 4\n\n9 6\n"})
    CHECK(same(format::text.decode(text, {}).values, rows));
  CHECK(same(format::text.decode("x[m] y[m] z[m]\n0 0 4\n0 1 2\n\n1 0 3\n1 1 4\n\n2 0 9\n2 1 6\n", {}).values,
             rows));
}

// Such lines were dropped as comments: the map was a row short.
TEST_CASE("a row that begins with a spreadsheet's error is a row, its cell missing",
          "[formats][text][exact]") {
  const Field rows = field({{1, 2}, {gap, 4}, {5, 6}});
  for (const std::string word : {"#N/A", "#NV", "#DIV/0!", "#WERT!", "#VALUE!", "#REF!", "#NUM!", "#NAME?",
                                 "#NULL!", "#BEZUG!", "#ZAHL!", "########"})
    for (const std::string separator : {";", "\t", " "}) {
      CAPTURE(word, separator);
      const auto row = [&](const std::string& a, const std::string& b) { return a + separator + b + "\n"; };
      CHECK(same(format::text.decode(row("1", "2") + row(word, "4") + row("5", "6"), {}).values, rows));
      CHECK(same(format::text.decode(row(word, "4") + row("5", "6"), {}).values, field({{gap, 4}, {5, 6}})));
      CHECK(same(format::text.decode(row("1", "2") + row("4", word), {}).values, field({{1, 2}, {4, gap}})));
    }
  CHECK(same(format::text.decode("1.5,2\n#N/A,4\n5,6\n", {}).values, field({{1.5, 2}, {gap, 4}, {5, 6}})));
  CHECK(same(format::text.decode("#N/A\n1\n#NV\n", {}).values, field({{gap}, {1}, {gap}})));
  CHECK(same(format::text.decode("#####\n# Title\n#####\n1\n2\n", {}).values, field({{1}, {2}})));
  CHECK(same(format::gwyddion_text.decode("# Width: 3 um\n# Height: 2 um\n#N/A\t2\t3\n4\t5\t6\n", {}).values,
             field({{gap, 2, 3}, {4, 5, 6}}).transpose()));
  Reading told;
  for (const char* word : {"#NV", "%", "#x", "#"}) {
    told.missing = {word};
    CHECK(same(format::text.decode("1;2\n" + std::string(word) + ";4\n5;6\n", told).values, rows));
  }
}

TEST_CASE("a comment that may be a row is refused, others are ignored", "[formats][text][contract]") {
  for (const char* text : {"1;2\n%;4\n5;6\n", "%;4\n5;6\n", "1 2\n% 4\n5 6\n", "1;2\n#ERR;4\n5;6\n",
                           "1,2\n#x,4\n5,6\n", "1\t2\t3\n\t#x\t4\n", "1\n####\n2\n", "#N/A;4x\n5;6\n"}) {
    CAPTURE(text);
    CHECK_THAT(refusal(text), ContainsSubstring("(`missing`)"));
  }
  for (const char* comment : {"# 1 2 3", "#x y z", "% made by", "#1 2", "#", "%", "# end;", "##", "#x"})
    for (const std::string separator : {";", " "}) {
      CAPTURE(comment, separator);
      const std::string first = "1" + separator + "2\n", second = "5" + separator + "6\n";
      const std::string text = comment + ("\n" + first) + comment + "\n" + second + comment;
      CHECK(same(format::text.decode(text, {}).values, field({{1, 2}, {5, 6}})));
    }
}

// 481,945 nm became 481945 nm.
TEST_CASE("commas stand between thousands only where a number proves it and none contradicts",
          "[formats][text][contract]") {
  for (const char* text : {"x[um];y[um];z[nm]\n0;0;1512.523\n1;0;481,945\n0;1;500.5\n1;1;600.5\n",
                           "1.5\n1,523\n2.512\n", "1,234.5;2\n1512.523;3\n", "1.234,5;2\n1512,523;3\n"})
    CHECK_THAT(refusal(text), ContainsSubstring("write one decimal mark, or give the `decimal`"));
  CHECK(same(format::text.decode("1,234.5\n2,000\n3.5\n", {}).values, field({{1234.5}, {2000}, {3.5}})));
  CHECK(same(format::text.decode("1,234,567;1.5\n", {}).values, field({{1234567, 1.5}})));
  Reading told;
  told.decimal = DecimalMark::point;
  CHECK(same(format::text.decode("1.5\n1,523\n", told).values, field({{1.5}, {1523}})));
}

// The line passed for words above the numbers.
TEST_CASE("a misspelt first number of one column is refused", "[formats][text][contract]") {
  for (const char* text : {"12O\n1.5\n2.5\n3.5\n", "-1x\n1\n2\n", ".5e\n1\n2\n", "1.2.3\n1\n2\n"}) {
    CAPTURE(text);
    CHECK_THAT(refusal(text), ContainsSubstring("line 1: ") && ContainsSubstring("is not a number"));
  }
  CHECK(
      same(format::text.decode("Height (nm)\n-- Sample 1 --\n3\n4\n", {}).values, 1e-9 * field({{3}, {4}})));
}
