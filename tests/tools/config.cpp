#include "support.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

using namespace asperity::test;

namespace {

const std::string draw = "asperity-generate --shape 16x12 --size 3um,2um --rq 0.4nm --length 4px --seed 3";

std::string refused(const std::string& file) {
  const Outcome run = shell("printf '" + file + "' > bad.toml; " + draw + " --config bad.toml -o bad.nc");
  CAPTURE(file, run.error);
  CHECK(run.exit == 2);
  CHECK(lines(run.error) == 1);
  CHECK_THAT(run.error, ContainsSubstring("asperity-generate: bad.toml: "));
  return run.error;
}

}  // namespace

TEST_CASE("what --dump-config prints gives the same run and the same print", "[config][law][slow]") {
  require(draw + " -o s.nc && asperity-acf s.nc -o acf.nc");
  require("asperity-contact s.nc --radius 1mm --young 208GPa --poisson 0.3 --load 1mN -o pressed.nc");
  const auto command = GENERATE(
      as<std::string>{}, draw + " --periodic --stream 4 --first 2 --add noise --no-history",
      "asperity-kernel --length 4px,3.5px --angle 30deg --rq 0.4um --spacing 1um,2um --no-history",
      "asperity-stats s.nc --parameters height,hybrid --json",
      "asperity-acf acf.nc --result profiles --max-lag 4x3", "asperity-psd s.nc --result radial",
      "asperity-pdf s.nc --bins 5", "asperity-validate s.nc acf.nc --rq 0.4nm --significance 1e-09",
      "asperity-convert s.nc --to esri",
      "asperity-filter s.nc --remove-form plane --scale -1 --remove-form 2 --crop 2:9,:5 --no-history",
      "asperity-contact s.nc --radius 1mm,inf --young 208GPa --poisson 0.3,0.25 --load 1mN --yield 1.2GPa "
      "--no-history",
      "asperity-stress pressed.nc --depths 0:1um:3 --section y=0 --maximum --no-history",
      "asperity-plot s.nc s.nc --kind map --labels one,two --title 'a \"b\" \\ # [c] = d' --to svg -o -");
  const std::string tool = command.substr(0, command.find(' '));
  CAPTURE(command);
  const Outcome run = shell("export SOURCE_DATE_EPOCH=0; " + command + " --dump-config > a.toml; " + command +
                            " > a; " + tool + " --config a.toml --dump-config > b.toml && " + tool +
                            " --config a.toml > b && cmp a.toml b.toml && cmp a b && grep -v '^#' a.toml");
  CAPTURE(run.error);
  CHECK(run.exit == 0);
  CHECK_THAT(run.out, ContainsSubstring(" = "));
}

TEST_CASE(
    "the option --dump-config gathers the command line, the environment and the file, and the defaults as "
    "comments",
    "[config][contract]") {
  const Outcome run = shell(
      "printf 'rq = \"2um\"\\nlength-level = 0.25\\nperiodic = true\\n' > base.toml; "
      "ASPERITY_GENERATE_COUNT=3 ASPERITY_GENERATE_RQ=1um " +
      draw + " --config base.toml --dump-config");
  CHECK(run.exit == 0);
  CHECK_THAT(run.out,
             ContainsSubstring("\nshape = \"16x12\"\n") && ContainsSubstring("\nrq = \"0.4nm\"\n") &&
                 ContainsSubstring("\ncount = 3\n") && ContainsSubstring("\nlength-level = 0.25\n") &&
                 ContainsSubstring("\nperiodic = true\n") && ContainsSubstring("\n# tolerance = 1e-10\n"));
  CHECK(run.out.find("dump-config = ") == std::string::npos);
}

TEST_CASE("a file of options that cannot be meant is refused in a line that names it and the key",
          "[config][contract]") {
  CHECK_THAT(refused("sede = 1\\n"), ContainsSubstring("there is no option sede"));
  CHECK_THAT(refused("length-level = \"1mm\"\\n"), ContainsSubstring("length-level: "));
  CHECK_THAT(refused("length-level = 2\\n"),
             ContainsSubstring("length-level: "));  // refused by the model, not by the reader
  CHECK_THAT(refused("wavelength = 3mm\\n"),
             ContainsSubstring("wavelength: ") && ContainsSubstring("(line 1)"));
  CHECK_THAT(refused("count = 1\\ncount = 2\\n"), ContainsSubstring("count: "));
  CHECK_THAT(refused("periodic = 1\\n"), ContainsSubstring("periodic: must be true or false"));
  CHECK_THAT(refused("[surface]\\n"), ContainsSubstring("surface: is a table"));
  CHECK_THAT(refused("model = \"gaussian\\n"), ContainsSubstring("model: "));
  CHECK_THAT(refused("target\\n"), ContainsSubstring("target: "));
  CHECK_THAT(refused("length-level = 0.1 0.2\\n"), ContainsSubstring("length-level: "));
  CHECK_THAT(refused("man = true\\n"), ContainsSubstring("man: "));
  const Outcome absent = shell(draw + " --config absent.toml -o bad.nc");
  CHECK(absent.exit == 2);
  CHECK_THAT(absent.error, ContainsSubstring("--config: 'absent.toml' cannot be read"));
}

// The regular expression that told a number recursed once a character.
TEST_CASE("a number of a hundred thousand digits is dumped and read back", "[config][contract]") {
  require(draw + " --length-level 0.$(printf '1%.0s' $(seq 100000)) --dump-config > c.toml");
  CHECK(shell("asperity-generate --config c.toml --dump-config | cmp - c.toml").exit == 0);
}

TEST_CASE("a wrong value of the environment is named by its variable", "[config][contract]") {
  const Outcome run = shell("ASPERITY_GENERATE_LENGTH_LEVEL=high " + draw + " -o bad.nc");
  CHECK(run.exit == 2);
  CHECK_THAT(run.error, ContainsSubstring("asperity-generate: ASPERITY_GENERATE_LENGTH_LEVEL: "));
}

TEST_CASE("comments, literals and lists are read as TOML has them", "[config][contract]") {
  require(draw + " -o s.nc; cp s.nc 'a#b.nc'");
  require(
      "printf '# of statistics\\n\\n  INPUT = [ \"s.nc\",  # one\\n  '\"'a#b.nc'\"' ]  # "
      "both\\njson=true' > c.toml");
  const Outcome run = shell("asperity-stats --config c.toml | jq .Sq");
  CAPTURE(run.error);
  CHECK(run.exit == 0);
  CHECK_THAT(shell("asperity-stats --config c.toml -v 2>&1 >/dev/null").out,
             ContainsSubstring("s.nc\na#b.nc\n"));
}
