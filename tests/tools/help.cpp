// The two lengths of help, the umbrella command, and what is said of an option that is not there.
#include "support.hpp"
#include "tools/cli/toolbox.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

using namespace asperity;
using namespace asperity::test;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

std::string each_tool() {
  const auto k = GENERATE(range(std::size_t{0}, std::size(cli::toolbox)));
  return std::string(cli::toolbox[k].tool);
}

// Columns of the longest line; a µ is one.
std::size_t width(const std::string& text) {
  std::size_t most = 0, now = 0;
  for (const char c : text) {
    now = c == '\n' ? 0 : now + ((static_cast<unsigned char>(c) & 0xC0) != 0x80);
    most = std::max(most, now);
  }
  return most;
}

std::string refusal(const std::string& command) {
  const Outcome run = shell(command);
  CAPTURE(command, run.error);
  CHECK(run.exit == 2);
  CHECK(run.out.empty());
  CHECK(lines(run.error) == 1);
  return run.error;
}

}  // namespace

TEST_CASE("the short help fits on a screen of 80 columns and 24 lines, the example before the options",
          "[help][contract]") {
  const std::string tool = each_tool();
  const Outcome help = shell(tool + " -h");
  CAPTURE(tool, help.out);
  CHECK(help.exit == 0);
  CHECK(help.error.empty());
  CHECK(lines(help.out) <= 24);
  CHECK(width(help.out) <= 80);
  CHECK(help.out.starts_with(tool + ": " + std::string(cli::summary_of(tool)) + "\n"));
  CHECK(help.out.find("\nExample:\n") < help.out.find("\n  -"));
  const Outcome all = shell(tool + " --help");
  CHECK(width(all.out) <= 80);
  CHECK(lines(all.out) > lines(help.out));
}

TEST_CASE("help is as wide as the terminal", "[help][contract]") {
  const Outcome wide = shell("script -qec 'stty cols 100; asperity-stats --help' /dev/null | tr -d '\\r'");
  CHECK(width(wide.out) > 80);
  CHECK(width(wide.out) <= 100);
  CHECK(width(shell("script -qec 'stty cols 60; asperity-stats --help' /dev/null | tr -d '\\r'").out) <= 62);
}

TEST_CASE("an unknown option is answered with what was meant", "[help][contract]") {
  CHECK_THAT(refusal("asperity-generate --lenght 3px"), EndsWith("--lenght: did you mean --length?\n"));
  CHECK_THAT(refusal("asperity-generate --toler 1"), EndsWith("--toler: did you mean --tolerance?\n"));
  CHECK_THAT(refusal("asperity-stress --load 5N"), EndsWith("--load: it belongs to asperity-contact\n"));
  CHECK_THAT(refusal("asperity-convert --crop 0:8,0:8"), EndsWith("--crop: it belongs to asperity-filter\n"));
  CHECK_THAT(refusal("asperity-generate -lenght 3px"), EndsWith("-lenght: did you mean --length?\n"));
  CHECK_THAT(refusal("asperity-kernel --remove-form plane"),
             EndsWith("it belongs to asperity-acf, asperity-generate, asperity-pdf and 4 other tools\n"));
  CHECK_THAT(refusal("asperity --threads 2"), EndsWith("--threads: the options of a tool follow its name\n"));
  CHECK_THAT(refusal("asperity-stats --qwertyuiop"), EndsWith("there is no option --qwertyuiop\n"));
  CHECK_THAT(refusal("asperity-contact --one --two"),
             ContainsSubstring("--one"));  // the first that was typed
  CHECK_THAT(refusal("asperity-convert one.nc two.nc three.nc"),
             ContainsSubstring("'two.nc' is one argument too many"));
  CHECK_THAT(refusal("asperity-stats --lambda-c"), EndsWith("--lambda-c needs a value\n"));
  CHECK_THAT(refusal("echo 'lenght = \"3px\"' > o.toml; asperity-generate --config o.toml"),
             EndsWith("o.toml: there is no option lenght: did you mean --length?\n"));
}

TEST_CASE("a variable of one tool is no other tool's, and one that stands for no option is refused",
          "[help][config][contract]") {
  CHECK(shell("ASPERITY_LENGTH_LEVEL=x ASPERITY_GENERATE_LENGTH_LEVEL=x asperity-stats -h").exit == 0);
  CHECK_THAT(refusal("ASPERITY_STATS_REMOVE_FROM=plane asperity-stats"),
             ContainsSubstring("ASPERITY_STATS_REMOVE_FROM: there is no option --remove-from: did you mean "
                               "--remove-form?"));
}

TEST_CASE("asperity lists the tools, runs one and opens pages", "[help][contract]") {
  const Outcome list = shell("asperity");
  CHECK(list.exit == 0);
  for (const cli::Summary& s : cli::toolbox) CHECK_THAT(list.out, ContainsSubstring(std::string(s.text)));
  CHECK(width(list.out) <= 80);
  CHECK(shell("asperity stats -h").out == shell("asperity-stats -h").out);
  CHECK(shell("asperity contact --radius").exit == 2);
  CHECK(shell("asperity help stats").out == shell("asperity-stats --help").out);
  CHECK(shell("asperity help asperity-stats").out == shell("asperity-stats --help").out);
  for (const std::string topic : {"glossary", "tasks", "options", "troubleshooting", "dataset"}) {
    CHECK_THAT(shell("asperity help").out, ContainsSubstring("\n  " + topic));
    CHECK_THAT(shell("asperity help " + topic).out, StartsWith("# "));
  }
  CHECK_THAT(shell("PAGER=cat script -qec 'asperity help glossary' /dev/null").out, StartsWith("# Glossary"));
  CHECK_THAT(refusal("asperity contct"), ContainsSubstring("did you mean contact?"));
  CHECK_THAT(refusal("asperity help nothing"), ContainsSubstring("there is no page 'nothing'"));
  CHECK(shell("source <(asperity --completion bash); COMP_WORDS=(asperity con); COMP_CWORD=1; _asperity; "
              "echo ${COMPREPLY[*]}")
            .out == "convert contact\n");
}

TEST_CASE("an error in the data of a file names the file", "[help][contract]") {
  const Outcome run =
      shell("printf '1 2\\n3 word\\n' > map.txt; asperity-acf map.txt; asperity-acf < map.txt");
  CHECK_THAT(run.error, StartsWith("asperity-acf: map.txt: ") && ContainsSubstring("\nasperity-acf: map: "));
}
