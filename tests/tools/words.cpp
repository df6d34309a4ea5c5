// What the texts of files do to messages, tables, JSON and the files of other programs; and how messages
// count.
#include "core/words.hpp"

#include <nlohmann/json.hpp>

#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

using namespace asperity;
using namespace asperity::test;
using Json = nlohmann::json;

namespace {

Dataset dataset(Shape shape) {
  const Grid grid{shape, 1e-6, 1e-6};
  Dataset data;
  set_grid(data, grid);
  set_field(data, "heights", 1e-7 * random_field(shape, 1), {"m", "heights"});
  return data;
}

// values(x, y) of that unit, beside heights.
void write_values(const std::string& unit) {
  Dataset data = dataset({24, 20});
  set_field(data, "values", random_field({24, 20}, 2),
            {unit,
             "a \xb5"
             "-voltage\x1b[0m"});
  write_dataset(data, "v.nc");
}

bool is_clean(const std::string& text) {
  return is_utf8(text) && std::ranges::none_of(text, [](char c) {
           return (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7f;
         });
}

// Well-formed by a parser that is not ours, up to the bytes that stand behind XML in a .vti.
bool is_xml(const std::string& name) {
  return shell(
             "python3 -c 'import sys, xml.etree.ElementTree as t; b = open(sys.argv[1], \"rb\").read(); "
             "t.fromstring(b[:b.index(b\"<AppendedData\")] + b\"</VTKFile>\")' " +
             name)
             .exit == 0;
}

const std::string long_unit(100000, 'a');
const std::string hostile[] = {"\x1b[31mV\x1b[0m",
                               "\xb5V\x9b"
                               "31m",
                               "a]]>b\x01\x02<c>",
                               "V\nV\tV",
                               "\u202eV\u2028",
                               long_unit};

}  // namespace

// ESC sequences of a unit reached the terminal, a unit of 100 kB made a message of 100 kB, and JSON ended
// with "[json.exception.type_error.316] invalid UTF-8 byte".
TEST_CASE("the tables and messages of every tool are lines of UTF-8, whatever unit a file has",
          "[words][contract][slow]") {
  for (const std::string& unit : hostile) {
    write_values(unit);
    for (const char* tool :
         {"stats", "stats --parameters all", "stats --profile x", "acf", "acf --result profiles --json",
          "psd --result radial", "psd --result profiles", "pdf", "stats --json", "pdf --json", "validate",
          "contact --radius 1mm --young 200GPa --poisson 0.3 --load 1N", "report -o r.html",
          "plot --kind map -o p.png", "plot --kind pdf -o p.svg"}) {
      const std::string command = std::string("asperity-") + tool,
                        name = command.substr(0, command.find(' '));
      const Outcome run =
          shell(command + " --variable values v.nc" + (name == "asperity-acf" ? " | head -c 100000" : ""));
      CAPTURE(one_line(unit, 40), tool, one_line(run.error), run.exit);
      CHECK(run.exit != 1);
      if (!run.out.starts_with("CDF")) CHECK(is_clean(run.out));
      CHECK(is_clean(run.error));
      CHECK(run.error.size() <= 4000 * (1 + static_cast<std::size_t>(lines(run.error))));
    }
  }
}

TEST_CASE("the JSON of a unit keeps all of it, in UTF-8", "[words][contract]") {
  for (const std::string& unit : hostile) {
    write_values(unit);
    const Outcome run = shell("asperity-stats --json --variable values v.nc");
    INFO(one_line(run.error));
    REQUIRE(run.exit == 0);
    CHECK(Json::parse(run.out)["Sq"]["unit"] == utf8_of(unit));
  }
}

// Names of variables and attributes, and text that a report quotes.
TEST_CASE("a variable's name and an attribute speak to no terminal and no parser", "[words][contract]") {
  Dataset data = dataset({12, 10});
  data.attributes.set("contact_note", std::string("\xb5m \x1b]0;title\x07"));
  data.attributes.set("contact_load", 3.0);
  set_field(data, "pressure", random_field({12, 10}, 3).abs(), {"Pa", "\x1b[2J"});
  write_dataset(data, "v.nc");
  for (const char* line :
       {"asperity-report v.nc -o r.html && cat r.html", "asperity-stats --variable none v.nc",
        "asperity-stats --variable $'\\x1b[31mred' v.nc",
        "asperity-plot --kind map --variable $'\\x1b[31m' v.nc -o p.png",
        "asperity-stats --parameters $'\\x1b[31m' v.nc", "asperity-stats $'no\\x1b[31m\\nfile'",
        "asperity-contact --radius 1mm --young 200GPa --poisson 0.3 --load 1N v.nc --report r.json > "
        "/dev/null; cat r.json"}) {
    const Outcome run = shell(line);
    CAPTURE(line, run.error);
    CHECK(is_clean(run.out));
    CHECK(is_clean(run.error));
  }
}

// "]]>" and control characters are not allowed in XML, nor bytes that are no UTF-8.
TEST_CASE("a VTK file of any unit and name is well-formed XML", "[words][contract][slow]") {
  for (const std::string& unit : hostile) {
    write_values(unit);
    for (const char* name : {"a.vti", "a.vtr"}) {
      const Outcome run = shell(std::string("asperity-convert v.nc -o ") + name);
      INFO(one_line(run.error));
      REQUIRE(run.exit == 0);
      CHECK(is_xml(name));
    }
  }
}

TEST_CASE("heights whose unit is a Latin-1 micrometre are read as micrometres, from every format",
          "[words][contract]") {
  Dataset data = dataset({24, 20});
  write_dataset(data, "m.nc");
  data.find("heights")->attributes.set("units", "\xb5m");
  data.find("heights")->values = Values(numbers(data.find("heights")->values));
  write_dataset(data, "um.nc");
  REQUIRE(shell("asperity-convert m.nc -o m.gsf && asperity-convert m.nc -o m.nrrd").exit == 0);
  const auto sq = [](const std::string& name) {
    const Outcome run = shell("asperity-stats --json " + name);
    INFO(run.error);
    REQUIRE(run.exit == 0);
    return Json::parse(run.out)["Sq"]["value"].get<double>();
  };
  const double metres = sq("m.nc");
  CHECK(relative_error(sq("um.nc"), 1e-6 * metres) <= 1e-12);
  REQUIRE(shell("LC_ALL=C sed 's/sample units: \"m\"/sample units: \"\\xb5m\"/' m.nrrd > um.nrrd").exit == 0);
  CHECK(relative_error(sq("um.nrrd"), 1e-6 * metres) <= 1e-12);
  // In the head of a GSF a unit longer by a byte moves the numbers: by three more they are where they were.
  REQUIRE(shell("LC_ALL=C sed '0,/ZUnits = m/s//ZUnits = \\xb5m\\nA=1/' m.gsf > um.gsf").exit == 0);
  const Outcome gsf = shell("asperity-convert um.gsf -o a.nc && ncdump -h a.nc");
  INFO(gsf.error);
  CHECK((gsf.exit == 0 || gsf.error.find("units") == gsf.error.npos));
}

// "1 surfaces, 6 lags"; and "value 1000000000000…" of 301 digits.
TEST_CASE("messages count as people do, and a number in them has no more digits than it takes",
          "[words][contract]") {
  REQUIRE(shell("asperity-generate --shape 64x64 --size 64um --rq 1um --length 6px --seed 1 -o s.nc").exit ==
          0);
  CHECK(shell("asperity-validate s.nc").error.find(" 1 surface, ") != std::string::npos);
  for (const char* line :
       {"asperity-stats s.nc --lambda-c 1e300m", "asperity-stats s.nc --profile x --lambda-c 1e300m",
        "asperity-stats s.nc --parameters material --material-ratio 1e300,0.8",
        "asperity-stats s.nc --sal-level 1e300 --parameters spatial",
        "asperity-validate s.nc --kurtosis -1e300", "asperity-validate s.nc --significance 1e300",
        "asperity-generate --shape 8x8 --size 1mm --length 1px --rq 1um --length-level 1e300",
        "asperity-generate --shape 8x8 --size 1mm --length 1e300m --rq 1um"}) {
    const Outcome run = shell(std::string(line) + " > /dev/null");
    CAPTURE(line, run.error);
    CHECK(run.exit != 0);
    CHECK(run.error.find("0000000000") == run.error.npos);
    CHECK(run.error.find("1e") != run.error.npos);
  }
}

// A year of 292277026596, or of 1970 for what is no number, once went into history.
TEST_CASE(
    "SOURCE_DATE_EPOCH is a whole number of seconds within the years 1970 to 9999, or refused before the "
    "work",
    "[record][contract]") {
  const std::string draw = "asperity-generate --shape 8x8 --size 8um --rq 1um --length 1px --seed 1 -o s.nc";
  for (const char* wrong : {"-1", "1e9", "word", "253402300800", "99999999999999999999", "", " 1", "0x10"}) {
    const Outcome run = shell("rm -f s.nc; export SOURCE_DATE_EPOCH='" + std::string(wrong) + "'; " + draw);
    CAPTURE(wrong, run.error);
    CHECK((run.exit == 2 && lines(run.error) == 1));
    CHECK(run.error.starts_with("asperity-generate: SOURCE_DATE_EPOCH: \""));
    CHECK(shell("test -e s.nc").exit != 0);
    CHECK(shell("SOURCE_DATE_EPOCH='" + std::string(wrong) + "' asperity-generate --help").exit == 0);
  }
  for (const auto& [epoch, date] :
       {std::pair{"0", "1970-01-01T00:00:00Z"}, {"253402300799", "9999-12-31T23:59:59Z"}}) {
    const Outcome run = shell("SOURCE_DATE_EPOCH=" + std::string(epoch) + " " + draw);
    INFO(run.error);
    REQUIRE(run.exit == 0);
    CHECK(read_dataset("s.nc").attributes.text("history").starts_with(date));
  }
}

// A table of NaN, or of nothing, with exit status 0.
TEST_CASE("of a row of heights profiles across it and rings of wave numbers are refused by name",
          "[narrow][contract]") {
  for (const Shape shape : {Shape{1, 60}, Shape{60, 1}}) {
    write_dataset(dataset(shape), "s.nc");
    const std::string along = shape.nx > 1 ? "x" : "y", across = shape.nx > 1 ? "y" : "x";
    CHECK(shell("asperity-stats s.nc --profile " + along).exit == 0);
    CHECK(shell("asperity-psd s.nc --result profiles").exit == 0);
    for (const std::string& line :
         {"asperity-stats s.nc --profile " + across, std::string("asperity-psd s.nc --result radial")}) {
      const Outcome no = shell(line);
      CAPTURE(line, no.error);
      CHECK((no.exit == 4 && no.out.empty() && lines(no.error) == 1));
      CHECK(no.error.find("heights: ") != no.error.npos);
    }
  }
}

// Profiles and sections were left out of it, and its maps were empty frames.
TEST_CASE("a report of a row or a column has all its pictures", "[narrow][contract][slow]") {
  for (const Shape shape : {Shape{1, 40}, Shape{40, 1}}) {
    write_dataset(dataset(shape), "s.nc");
    const Outcome run = shell(
        "asperity-contact s.nc --radius 50mm --young 208GPa --poisson 0.3 --load 1mN -q | asperity-stress "
        "--depths 0:2um:3 --maximum -q | asperity-report -o r.html; grep -c 'is not drawn' r.html");
    CAPTURE(shape.nx, run.error);
    CHECK(run.out == "0\n");
  }
}

TEST_CASE("a surface that is worth too few points to be validated is refused in one line",
          "[narrow][contract]") {
  const Outcome run = shell(
      "asperity-generate --shape 2x2 --size 2um --length 1px --rq 0.1um --seed 3 -q | asperity-validate");
  INFO(run.error);
  CHECK((run.exit == 4 && run.out.empty()));
  CHECK(run.error.find("asperity-validate: acf_target: ") != run.error.npos);
  CHECK(run.error.find("asperity-validate: warning") == run.error.npos);
}

// All thirteen on what is as narrow as can be: an answer, or a line.
TEST_CASE("every tool takes a row, a column, a point and four points, or refuses them in a line",
          "[narrow][contract][slow]") {
  for (const Shape shape : {Shape{1, 40}, Shape{40, 1}, Shape{2, 40}, Shape{1, 1}, Shape{2, 2}}) {
    write_dataset(dataset(shape), "s.nc");
    const std::string contact =
        "asperity-contact s.nc --radius 50mm --young 208GPa --poisson 0.3 --load 1mN -q";
    REQUIRE(shell(contact + " -o c.nc && asperity-stress c.nc --depths 0:2um:3 -o t.nc").exit == 0);
    for (const std::string& line :
         {std::string("stats s.nc --parameters all"), std::string("acf s.nc -o a.nc"),
          std::string("psd s.nc -o p.nc"), std::string("pdf s.nc"), std::string("pdf s.nc --estimate kernel"),
          std::string("report t.nc -o r.html"), std::string("convert s.nc -o s.vti"),
          std::string("convert s.nc -o s.gsf"), std::string("filter s.nc --remove-form plane -o l.nc"),
          std::string("filter s.nc --opening 3um --fill mean --mirror both -o l.nc"),
          std::string("convert s.nc -o s.x3p"), std::string("convert s.nc -o s.npy"),
          std::string("kernel --acf s.nc -o k.nc"),
          std::string("generate --acf s.nc --shape 8x8 --seed 1 -o g.nc"),
          std::string("plot t.nc --kind map -o f.png"), std::string("plot t.nc --kind surface -o f.png"),
          std::string("plot t.nc --kind pdf -o f.png"), std::string("plot t.nc --kind acf -o f.png"),
          std::string("plot t.nc --kind contact -o f.png")}) {
      const Outcome run = shell("asperity-" + line);
      CAPTURE(shape.nx, shape.ny, line, run.error);
      CHECK((run.exit == 0 || run.exit == 2 || run.exit == 4));
      if (run.exit != 0) CHECK(run.error.find(": ") != run.error.npos);
      CHECK(run.error.find("nan") == run.error.npos);
    }
  }
}
