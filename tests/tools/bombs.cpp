// Small files and short options that ask for much: each is refused in a line before memory is taken. Every
// line runs with 2 GB of address space and 60 s.
#include <iostream>
#include <limits>
#include <optional>
#include <regex>

#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

Outcome confined(const std::string& line) {
#ifdef __SANITIZE_ADDRESS__
  return shell(line);  // which takes address space of its own
#else
  return shell("ulimit -v 2000000; ulimit -t 60; ulimit -c 0; " + line);
#endif
}

// In MB, as --time tells it; nothing where the command line was refused before it was read to its end.
std::optional<double> peak_of(const std::string& told) {
  std::smatch found;
  if (!std::regex_search(told, found, std::regex("peak memory ([0-9]+)MB"))) return std::nullopt;
  return std::stod(found[1]);
}

// One line, of the tool's, with these words, and that of --time.
void refused(const std::string& line, int exit, const std::vector<std::string>& words) {
  const Outcome run = confined(line + " --time");
  CAPTURE(line, run.error);
  CHECK(run.exit == exit);
  const auto peak = peak_of(run.error);
  CHECK(lines(run.error) == (peak ? 2 : 1));
  CHECK(run.error.starts_with("asperity-"));
  for (const std::string& word : words) CHECK_THAT(run.error, ContainsSubstring(word));
#ifndef __SANITIZE_ADDRESS__
  CHECK(peak.value_or(0) <= 100);
#endif
}

// 8 × 8 heights between two numbers, and as a pressure their sizes: colours of heights are even about their
// mean, those of a pressure are not.
void write_heights(const std::string& name, double low, double high) {
  Dataset data;
  set_grid(data, {{8, 8}, 1e-6, 1e-6});
  Field z = Field::Constant(8, 8, low);
  for (Index k = 0; k < z.size(); k += 3) z(k) = high;
  set_field(data, "heights", z, {"m", "height"});
  set_field(data, "pressure", z.abs(), {"Pa", "pressure"});
  write_dataset(data, name);
}

const std::string every_reader[] = {"acf",  "contact", "convert", "generate", "kernel", "pdf",
                                    "plot", "psd",     "report",  "stats",    "stress", "validate"};

}  // namespace

TEST_CASE("every tool that reads has --memory", "[bombs][contract]") {
  for (const std::string& tool : every_reader)
    CHECK_THAT(shell("asperity-" + tool + " --help").out, ContainsSubstring("--memory SIZE"));
}

// 289 MB of zeros in 281 kB, a map of 2.3 GB: 2.6 GB were taken, 4.5 GB where the map has a size.
TEST_CASE("a small file of a large map is refused by its head, whoever reads it", "[bombs][contract][slow]") {
  REQUIRE(
      shell(
          "(printf 'NRRD0004\\ntype: uint8\\ndimension: 2\\nsizes: 17000 17000\\nspacings: 1 1\\n"
          "units: \"um\" \"um\"\\nencoding: gzip\\n\\n'; head -c 289000000 /dev/zero | gzip -9) > bomb.nrrd")
          .exit == 0);
  const std::string press = "asperity-contact --young 1GPa --poisson 0.3 --radius 1mm --load 1N -o c.nc ";
  const std::string draw = "asperity-generate --shape 8x8 --size 1mm --rq 1um -o g.nc ";
  for (const std::string& line :
       {std::string("asperity-stats bomb.nrrd"), std::string("asperity-stats < bomb.nrrd"),
        std::string("cat bomb.nrrd | asperity-acf --result lengths"), std::string("asperity-pdf bomb.nrrd"),
        std::string("asperity-psd bomb.nrrd --result radial"),
        std::string("asperity-report bomb.nrrd -o r.html"), std::string("asperity-convert bomb.nrrd -o c.nc"),
        std::string("asperity-convert bomb.nrrd -o c.npy"),
        std::string("asperity-plot bomb.nrrd --kind map -o p.png"), press + "bomb.nrrd",
        std::string("asperity-validate bomb.nrrd"), draw + "--length 3px --marginal bomb.nrrd"})
    refused(line + " --memory 1GB", 4,
            {"reading needs 6937MB, the memory limit is 1000MB", "raise --memory"});
}

TEST_CASE("an input without an end is read as far as --memory allows", "[bombs][contract]") {
  refused("asperity-stats /dev/zero --memory 30MB", 4, {"/dev/zero", "raise --memory"});
  refused("asperity-stats --memory 30MB < /dev/zero", 4, {"standard input", "raise --memory"});
  refused("asperity-kernel --acf /dev/zero --memory 30MB -o k.nc", 4, {"/dev/zero", "raise --memory"});
}

// The destructor of toml++ calls itself for each part of a key: 50 000 were a SIGSEGV of all tools.
TEST_CASE("a file of options that is deep, large, endless or none is refused", "[bombs][config][contract]") {
  const std::string deep = "$(printf 'a.%.0s' {1..50000})a";
  for (const std::string& content :
       {deep + " = 1", "[" + deep + "]", "[[" + deep + "]]", "x = \"\"\"a\"\"\"\"\n" + deep + " = 1",
        "b = { " + deep + " = 1 }", "# a comment\n\"a\".'b' . " + deep + " = 1"}) {
    const Outcome written = shell("cat > deep.toml <<END\n" + content + "\nEND");
    REQUIRE(written.exit == 0);
    refused("asperity-stats x.nc --config deep.toml", 2, {"deep.toml: line ", "nested too deeply"});
  }
  refused("asperity-stats x.nc --config /dev/zero", 2, {"/dev/zero: it is larger than 1 MiB"});
  refused("asperity-stats x.nc --config .", 2, {"--config: '.' cannot be read"});
  const Outcome nested = confined(
      "printf 'a = %s' $(printf '[%.0s' {1..50000}) > nested.toml;"
      "asperity-stats x.nc --config nested.toml");
  CHECK(nested.exit == 2);
  CHECK(lines(nested.error) == 1);
}

TEST_CASE("dots and brackets in the texts of a file of options nest nothing", "[bombs][config][contract]") {
  const Outcome run = shell(
      "cat > dots.toml <<'END'\n# a.b.c.d.e.f.g.h.i.j.k\ntitle = 'a.b.c.d.e.f.g.h.i.j.k [[[['\n"
      "labels = \"a.b.c.d.e.f\\\".g.h.i.j.k\"\noutput = '''a.b.c.d.e.f.g.h.i.j.png'''\nabove = 0.25\nEND\n"
      "asperity-plot --config dots.toml --kind map --dump-config");
  CAPTURE(run.error);
  CHECK(run.exit == 0);
  CHECK_THAT(run.out, ContainsSubstring("title = \"a.b.c.d.e.f.g.h.i.j.k [[[[\""));
}

TEST_CASE("a number of things that takes memory or time without end is refused with a reason",
          "[bombs][contract]") {
  write_heights("s.nc", 0, 1e-6);
  REQUIRE(shell("asperity-contact s.nc --young 1GPa --poisson 0.3 --radius 1mm --load 1mN -o p.nc").exit ==
          0);
  const std::string press = "asperity-contact s.nc --young 1GPa --poisson 0.3 --radius 1mm -o o.nc ",
                    smooth =
                        "asperity-contact --smooth --size 1mm --young 1GPa --poisson 0.3 --load 1N -o o.nc ",
                    draw = "asperity-generate --size 1mm --rq 1um --length 3px -o s_%d.nc ";
  const std::pair<std::string, std::string> cases[] = {
      {"asperity-stress p.nc --depths 0:1mm:1000000000 -o o.nc",
       "--depths 0:1mm:1000000000: 1000000000 is above 100000"},
      {"asperity-stress p.nc --depths 0:1mm:99999999999999999999 -o o.nc", "is above 100000, the most"},
      {"asperity-stress p.nc --maximum --body 3 -o o.nc", "--body: 3 is above 2"},
      {press + "--sweep 1mN:2mN:1000000000", "--sweep 1mN:2mN:1000000000: 1000000000 is above 100000"},
      {press + "--load 1mN --threads 1000000000", "--threads: 1000000000 is above 4096"},
      {press + "--load 1mN --max-convolutions 99999999999", "--max-convolutions: 99999999999 is above"},
      {smooth + "--shape 1000000x1000000",
       "--shape: a contact of 1000000x1000000 cells needs some 120000000MB"},
      {smooth + "--shape 99999999999999999999x3", "--shape: '99999999999999999999x3'"},
      {"asperity-pdf s.nc --bins 100000000", "--bins: 100000000 is above 1048576"},
      {"asperity-pdf s.nc --estimate kernel --rows 100000000", "--rows: 100000000 is above 1048576"},
      {"asperity-plot s.nc --kind map --pixels 30000x30000 -o p.png", "10000, at which a picture takes"},
      {"asperity-acf s.nc --result lengths --max-lag 1000000000x1000000000", "--max-lag"},
      {"asperity-filter s.nc --decimate 9000000000000000000x1 -o o.nc", "--decimate"},
      {"asperity-kernel --length 3px --lags 1000000x1000000 -o o.nc", "more than 16777216 in all"},
      {"asperity-kernel --length 1000000000px -o o.nc", "--memory"},
      {draw + "--shape 8x8 --count 2000000000", "--count: 2000000000 is above 1000000"},
      {draw + "--shape 1000000000x1000000000", "--shape"},
      {draw + "--shape 8x8 --stream 99999999999", "--stream: 99999999999 is above"},
  };
  for (const auto& [line, words] : cases) refused(line, 2, {words});
}

// Between 1 and the next double ticks were counted for ever, and kept.
TEST_CASE("pictures and pages of heights that hardly differ, or are beyond all units, end",
          "[bombs][plot][contract][slow]") {
  if (shell("command -v gnuplot").exit != 0) {
    std::cout << "SKIPPED: gnuplot is not there\n";
    return;
  }
  const double ulp = std::numeric_limits<double>::epsilon(),
               denormal = std::numeric_limits<double>::denorm_min();
  for (const auto& [low, high] :
       {std::pair{1.0, 1 + ulp}, {-1 - ulp, -1.0}, {0.0, denormal}, {-1e308, 1e308}, {0.0, 1e308}}) {
    write_heights("n.nc", low, high);
    for (const std::string kind : {"map", "map --variable pressure", "surface", "surface --variable pressure",
                                   "profile", "pdf", "acf"}) {
      const Outcome run = confined("asperity-plot n.nc --kind " + kind + " -o n.svg");
      CAPTURE(low, high, kind, run.error);
      CHECK((run.exit == 0 || run.exit == 4));
      CHECK(lines(run.error) == (run.exit == 0 ? 0 : 1));
    }
    const Outcome page = confined("asperity-report n.nc -q -o n.html");
    CAPTURE(low, high, page.error);
    CHECK((page.exit == 0 || page.exit == 4));
  }
  write_heights("n.nc", 0, 1);
  refused("asperity-plot n.nc --kind map --range 1m,1.0000000000000002m -o n.svg", 2,
          {"--range: '1m,1.0000000000000002m' is too narrow"});
}
