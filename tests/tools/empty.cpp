// What is empty is neither absent nor a default: values of options, and inputs.
#include <string>

#include "support.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string generate =
    "asperity-generate --shape 16x12 --size 1mm --rq 0.4um --length 3px --seed 7 --no-history -q ";
const std::string bodies = " --radius 50mm --young 208GPa --poisson 0.3 --load 1N -q ";

bool says_empty(const Outcome& run, const std::string& name) {
  return run.exit == 2 && lines(run.error) == 1 && run.out.empty() &&
         run.error.find(": " + name + " is empty: ") != std::string::npos;
}

}  // namespace

// CLI11 takes the next argument for a value that is empty behind "=".
TEST_CASE("an empty value is a usage error of every option of every tool", "[empty][contract][slow]") {
  const Outcome run = shell(
      "for tool in kernel generate stats acf psd pdf validate contact stress convert plot report; do\n"
      "  for option in $(asperity-$tool --help | sed '/^Accuracy:/q' | grep -oE '^  (-., )?--[a-z0-9-]+' | "
      "grep -oE '\\-\\-.*'); "
      "do\n"
      "    [ $tool$option = plot--title ] && continue\n"
      "    out=$(asperity-$tool $option= s.nc 2>&1); s=$?\n"
      "    case \"$s $out\" in \"2 asperity-$tool: $option is empty: \"*) n=$((n+1));; *) echo \"$tool "
      "$option: $s $out\";; esac\n"
      "  done\n"
      "done; echo $n > counted");
  CAPTURE(run.error);
  CHECK(run.out.empty());
  CHECK(shell("test $(cat counted) -gt 250").exit == 0);
}

TEST_CASE("an empty value is named by where it came from", "[empty][contract]") {
  REQUIRE(shell(generate + "-o s.nc").exit == 0);
  const std::string press = "asperity-contact s.nc" + bodies;
  CHECK(says_empty(shell(press + "--counter \"$UNSET\" -o p.nc"), "--counter"));
  CHECK(says_empty(shell(press + "-o ''"), "--output"));
  CHECK(says_empty(shell("ASPERITY_CONTACT_COUNTER= " + press), "ASPERITY_CONTACT_COUNTER"));
  CHECK(says_empty(shell("ASPERITY_CONTACT_ADD= " + press), "ASPERITY_CONTACT_ADD"));
  CHECK(shell("ASPERITY_CONTACT_RADIUS= " + press + "-o p.nc").exit == 0);  // the command line comes first
  CHECK(says_empty(shell("asperity-contact ''" + bodies), "INPUT"));
  CHECK(says_empty(shell("asperity-stats s.nc ''"), "INPUT"));
  CHECK(says_empty(shell("asperity-plot '' --kind map -o m.png"), "INPUT"));
  CHECK(says_empty(shell(press + "--config ''"), "--config"));
  shell(
      "echo 'counter = \"\"' > one.toml; echo 'INPUT = [\"s.nc\", \"\"]' > two.toml; echo 'INPUT = []' "
      "> none.toml");
  CHECK(says_empty(shell(press + "--config one.toml"), "one.toml: counter"));
  CHECK(says_empty(shell("asperity-stats --config two.toml"), "INPUT"));
  const Outcome none = shell("asperity-stats --config none.toml");
  CHECK(none.exit == 2);
  CHECK(none.error.find("none.toml: INPUT: is an empty list") != std::string::npos);
}

TEST_CASE("a figure has no title where its title is empty, wherever that is said", "[empty][contract]") {
  REQUIRE(shell(generate + "-o s.nc").exit == 0);
  const std::string plot = "asperity-plot s.nc --kind map --to svg -o - ";
  const Outcome none = shell(plot + "--title ''");
  if (none.error.find("gnuplot") != none.error.npos) return;  // not installed
  CHECK(none.exit == 0);
  CHECK(none.out != shell(plot).out);
  shell("echo 'title = \"\"' > plain.toml");
  for (const std::string& same :
       {plot + "--title=", "ASPERITY_PLOT_TITLE= " + plot, plot + "--config plain.toml"})
    CHECK(shell(same).out == none.out);
}

TEST_CASE("an empty input is bad data, and of a pipe the tool before it", "[empty][contract][slow]") {
  REQUIRE(shell(generate + "-o s.nc; asperity-contact s.nc" + bodies + "-o p.nc; : > none").exit == 0);
  for (const std::string& tool :
       {std::string("stats"), std::string("validate"), std::string("acf"), std::string("psd"),
        std::string("pdf"), std::string("report"), std::string("convert --to gsf"),
        std::string("plot --kind map --to svg -o -"), "contact" + bodies, std::string("stress --depths 0"),
        std::string("stress p.nc --points -"), "contact s.nc --counter -" + bodies,
        std::string("kernel --acf -"), std::string("validate s.nc --acf -"),
        std::string("generate --shape 8x8 --size 1mm --rq 1um"),
        std::string("generate --shape 8x8 --size 1mm --rq 1um --kernel -"),
        generate.substr(9) + "--marginal -"}) {
    const std::string first = tool.substr(0, tool.find(' '));
    const std::string words =
        "asperity-" + first + ": standard input: it is empty: the tool before this one wrote nothing\n";
    for (const std::string& line :
         {"set +o pipefail; false | asperity-" + tool, "asperity-" + tool + " < none"}) {
      const Outcome run = shell(line);
      CAPTURE(line, run.error);
      CHECK(run.exit == 4);
      const bool within = tool.find("--counter") != tool.npos;  // which says in which of two files
      CHECK((within ? run.error.ends_with(words.substr(words.find("it is"))) : run.error == words));
      CHECK(run.out.empty());
    }
  }
  for (const std::string& line :
       {std::string("asperity-stats none"), std::string("asperity-convert none --to gsf"),
        std::string("asperity-kernel --acf none"), "asperity-contact s.nc --counter none" + bodies,
        std::string("asperity-stats s.nc none"), std::string("echo none | asperity-stats --files-from -"),
        std::string("asperity-generate --kernel none --shape 8x8")}) {
    const Outcome run = shell(line);
    CAPTURE(line, run.error);
    CHECK(run.exit == 4);
    CHECK(run.error.find("none: it is empty") != std::string::npos);
  }
}

// They were told to be empty, exit 4: bad data.
TEST_CASE("a file that cannot be opened is no empty file", "[program][contract]") {
  require(generate + "-o full.nc; mkdir -p folder");
  for (const auto& [line, words] :
       {std::pair{
            "for fd in /proc/$$/fd/*; do n=${fd##*/}; ((n > 2)) && eval \"exec $n>&-\"; done; ulimit -n 4; "
            "asperity-acf full.nc -o o.nc",
            "full.nc: Too many open"},
        {"asperity-acf folder -o o.nc", "folder: Is a directory"}}) {
    const Outcome run = shell(line);
    CAPTURE(line, run.error);
    CHECK((run.exit == 1 && lines(run.error) == 1));
    CHECK_THAT(run.error, ContainsSubstring(words));
  }
}
