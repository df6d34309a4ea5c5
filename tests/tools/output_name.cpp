// A file holds the format that its name promises.
#include "tools/cli/output_name.hpp"

#include "support.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string draw = "asperity-generate --shape 16x12 --size 3mm,2mm --rq 0.4um --length 3px --seed 7 ";
const std::string press = "asperity-contact s.nc --radius 50mm --young 208GPa --poisson 0.3 ";

void write_surface() {
  static const bool once = shell(draw + "-o s.nc && " + press + "--load 5N -o p.nc").exit == 0;
  REQUIRE(once);
}

// Exit status 2, one line on --OPTION that names the file, and no file.
void check_refused(const std::string& command, const std::string& file,
                   const std::string& option = "output") {
  const Outcome run =
      shell("rm -f " + file + "; " + command + "; code=$?; test ! -e " + file + " || exit 99; exit $code");
  CAPTURE(command, run.error);
  CHECK(run.exit == 2);
  CHECK_THAT(run.error, ContainsSubstring(": --" + option + ": '"));
  CHECK_THAT(run.error, ContainsSubstring(file));
  CHECK(lines(run.error) == 1);
}

}  // namespace

TEST_CASE("an extension is a letter and up to seven letters and digits behind the last dot",
          "[output][exact]") {
  const std::pair<const char*, const char*> names[] = {
      {"a.nc", "nc"},    {"A.NC", "nc"},         {"folder.x/a", ""},  {"a", ""},
      {"-", ""},         {".hidden", ""},        {"a.", ""},          {"run_0.4um", ""},
      {"v1.2", ""},      {"tmp.W2kXh0pQzR", ""}, {"a.nc.part", "nc"}, {"a.tif.tmp", "tif"},
      {"a.part", ""},    {"s_%04d.nc", "nc"},    {"/dev/null", ""},   {"/dev/stdout", ""},
      {"/dev/fd/1", ""}, {"a.b.tiff", "tiff"},   {"a b.nc", "nc"},    {"a.n c", ""}};
  for (const auto& [name, extension] : names) {
    CAPTURE(name);
    CHECK(cli::extension_of(name) == extension);
  }
}

// -o map.tif and map.x3p held NetCDF, exit status 0.
TEST_CASE("a dataset is not written into a name of another format, nor computed for it",
          "[output][contract][slow]") {
  write_surface();
  for (const std::string extension : {"tif", "x3p", "tsv", "docx"}) {
    const std::string file = "map." + extension;
    check_refused(draw + "-o " + file, file);
    check_refused("asperity-kernel --length 3px -o " + file, file);
    check_refused(press + "--load 5N -o " + file, file);
    check_refused("asperity-stress p.nc --maximum -o " + file, file);
    check_refused("asperity-stress p.nc --depths 0:0.1mm:2 -o " + file, file);
    check_refused("asperity-acf s.nc -o " + file, file);
    check_refused("asperity-psd s.nc -o " + file, file);
  }
  check_refused(draw + "--count 2 -o m_%d.tif", "m_%d.tif");
  check_refused(press + "--sweep 1N,2N --each m_%d.tif", "m_1.tif", "each");
  check_refused("asperity-convert s.nc -o map.tif", "map.tif");
}

TEST_CASE("a dataset goes into .nc, .cdf, .nc3, names without an extension, devices and pipes",
          "[output][contract]") {
  for (const std::string name :
       {"m.nc", "m.NC", "m.cdf", "m.nc3", "m", "m.nc.part", "tmp.W2kXh0pQzR", "run_0.4um"}) {
    CAPTURE(name);
    CHECK(shell(draw + "-o " + name + " && asperity-convert " + name + " -o again_" + name).exit == 0);
    CHECK(read_dataset(name).has("heights"));
  }
  CHECK(shell(draw + "-o /dev/null").exit == 0);
  CHECK(shell(draw + "-o /dev/stdout | asperity-stats").exit == 0);
  CHECK(shell("asperity-stats <(" + draw + "-o /dev/fd/1)").exit == 0);
  CHECK(shell("mkfifo named.pipe && (" + draw + "-o named.pipe & asperity-stats named.pipe; wait)").exit ==
        0);
}

TEST_CASE("a table is text, JSON with --json alone, a page is HTML", "[output][contract][slow]") {
  write_surface();
  for (const std::string file : {"t.nc", "t.x3p", "t.png", "t.json"}) {
    check_refused("asperity-stats s.nc -o " + file, file);
    check_refused("asperity-acf s.nc --result lengths -o " + file, file);
    check_refused(press + "--sweep 1N,2N -o " + file, file);
  }
  check_refused("asperity-report s.nc -o page.pdf", "page.pdf");
  check_refused(draw + "--report r.nc -o /dev/null", "r.nc", "report");
  for (const std::string good :
       {"-o t.tsv", "-o t.txt", "-o t", "-o t.csv", "-o t.result", "--json -o t.json", "--json -o t.txt"}) {
    CAPTURE(good);
    CHECK(shell("asperity-stats s.nc " + good).exit == 0);
  }
  CHECK(shell("asperity-report s.nc -o page.html").exit == 0);
}

TEST_CASE("convert writes what the name says, or what --to says whatever the name", "[output][contract]") {
  write_surface();
  CHECK(shell("asperity-convert s.nc -o u.GSF && head -c 8 u.GSF").out == "Gwyddion");
  CHECK(shell("asperity-convert s.nc -o u.CDF && head -c 3 u.CDF").out == "CDF");
  CHECK(shell("asperity-convert s.nc --to gsf -o u.tif && head -c 8 u.tif").out == "Gwyddion");
  CHECK(shell("asperity-convert s.nc --to netcdf -o v.tif && head -c 3 v.tif").out == "CDF");
}
