// Manual pages and completions, which tools print of themselves.
#include "tools/cli/documents.hpp"

#include "support.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

auto each_tool() {
  return GENERATE("kernel", "generate", "stats", "acf", "psd", "pdf", "validate", "convert", "contact",
                  "stress", "plot", "report");
}

// What `complete` offers behind these words, the last of which is begun.
std::string offered(const std::string& tool, const std::string& words) {
  return shell("source <(asperity-" + tool + " --completion bash); COMP_WORDS=(asperity-" + tool + " " +
               words + "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); f=$(complete -p asperity-" + tool +
               "); f=${f#*-F }; ${f%% *}; echo ${COMPREPLY[*]}")
      .out;
}

}  // namespace

TEST_CASE("a manual page has its sections and each option of --help", "[man][contract][slow]") {
  const std::string tool = std::string("asperity-") + each_tool();
  CAPTURE(tool);
  const Outcome page = shell(tool + " --man");
  CHECK(page.exit == 0);
  CHECK(page.error.empty());
  for (const char* name : {"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXAMPLES", "ACCURACY",
                           "ENVIRONMENT", "EXIT STATUS", "SEE ALSO"})
    CHECK_THAT(page.out, ContainsSubstring(std::string("\n.SH ") + name + "\n"));
  const Outcome missing =
      shell(tool + " --man | tr -d '\\\\' > page; " + tool +
            " --help | sed '/^Accuracy:/q' | grep -oE '^  (-., ?)?--[a-z-]+' | grep -oE -- '--[a-z-]+' |"
            "while read o; do grep -qF -- \"fB$o\" page || echo $o; done; " +
            tool + " --help | sed '/^Accuracy:/q' | grep -cE '^  -'");
  CAPTURE(missing.out);
  CHECK(lines(missing.out) == 1);  // how many options there are
}

TEST_CASE("a manual page passes mandoc without a warning", "[man][contract]") {
  const std::string tool = std::string("asperity-") + each_tool();
  CAPTURE(tool);
  const Outcome seen =
      shell("if command -v mandoc >/dev/null; then " + tool +
            " --man > page.1; mandoc -Tlint -Wwarning page.1; else echo SKIPPED: no mandoc; fi");
  if (skipped(seen)) return;
  CHECK(seen.out == "");
}

TEST_CASE("a manual page shows the help's words as they are", "[man][law]") {
  const Outcome seen = shell(
      "if command -v mandoc >/dev/null; then asperity-generate --man | mandoc -Tascii -Owidth=500 | col -b |"
      "tr -s '[:space:]' ' '; else echo SKIPPED: no mandoc; fi");
  if (skipped(seen)) return;
  CHECK_THAT(seen.out, ContainsSubstring("Exponent of stretched-exponential, exp(-r^EXPONENT); up to 2.") &&
                           ContainsSubstring("-o, --output FILE Output file"));
}

TEST_CASE("roff takes nothing of a text for its own", "[man][contract]") {
  CHECK(cli::roff(".5 isn't a\\b") == "\\&.5 isn\\(aqt a\\eb");
  CHECK(cli::roff("a\n.b -c") == "a\n\\&.b \\-c");
  CHECK(cli::roff("2 \xC2\xB5m") == "2 \\[u00B5]m");
}

TEST_CASE("bash completes options, the words of a choice and files", "[completion][contract]") {
  CHECK(offered("generate", "--mod") == "--model\n");
  CHECK(offered("generate", "--model m") == "matern\n");
  CHECK(offered("generate", "--model = g") == "gaussian\n");
  CHECK(offered("generate", "--rq ''") == "\n");
  CHECK(offered("contact", "--boundary ''") == "free periodic periodic_x periodic_y\n");
  shell("touch 'that surface.nc' other.file");
  CHECK(offered("stats", "--json that") == "that surface.nc\n");
  CHECK(offered("kernel", "-o other.f") == "other.file\n");
  CHECK(offered("kernel", "--he") == "--help\n");
}

TEST_CASE("a description for programs has every option of --help, and the unit of a number",
          "[describe][contract]") {
  const std::string tool = "asperity-" + std::string(each_tool());
  CAPTURE(tool);
  const Outcome names = shell(tool + " --describe | jq -r '.options[].names[]' | sort");
  CHECK(names.exit == 0);
  CHECK(names.out == shell(tool + " --help | sed '/^Accuracy:/q' | grep -oE '^  (-., )?--?[a-z-]+' |" +
                           " grep -oE -- '--?[a-z-]+' | sort")
                         .out);
  CHECK(shell(tool + " --describe | jq -r '.tool, .statuses[0].meaning'").out == tool + "\ndone\n");
  const auto told = [](const std::string& option) {
    return shell("asperity-contact --describe | jq -c '.options[] | select(.name == \"" + option + "\")" +
                 " | [.value, .unit, .words, .required, .prints, .excludes]'")
        .out;
  };
  CHECK(told("load") == "[\"other\",\"N\",[],false,false,[]]\n");
  CHECK(told("young") == "[\"other\",\"Pa\",[],true,false,[]]\n");
  CHECK(told("smooth") == "[\"flag\",\"\",[],false,false,[\"INPUT\",\"files-from\",\"variable\"]]\n");
  CHECK(told("progress") == "[\"word\",\"\",[\"auto\",\"always\",\"never\"],false,false,[]]\n");
  CHECK(told("man") == "[\"flag\",\"\",[],false,true,[]]\n");
}

TEST_CASE("a description for programs has the attributes that the tool leaves in a dataset, and no other's",
          "[describe][contract]") {
  const std::string results = " --describe | jq -c '.results[] | select(.name == \"";
  CHECK(shell("asperity-contact" + results + "contact_area\")'").out ==
        R"({"name":"contact_area","role":"result","unit":"m2","text":"real contact area"})"
        "\n");
  CHECK(shell("asperity-stress" + results + "contact_area\")'").out == "");
  CHECK(shell("asperity-stats --describe | jq -c .results").out == "[]\n");
}

// The choices of FILE.png|.svg|.pdf were offered as words.
TEST_CASE("a kind that names files is completed by files", "[completion][contract]") {
  shell("touch map.png");
  CHECK(offered("plot", "-o ma") == "map.png\n");
  shell("touch heights.nc");
  CHECK(offered("generate", "--marginal hei") == "heights.nc\n");
}

TEST_CASE("completions are right by the grammar of their shells", "[completion][contract][slow]") {
  const std::string tool = std::string("asperity-") + each_tool();
  CAPTURE(tool);
  const Outcome bash = shell(tool + " --completion bash > c; bash -n c");
  CHECK(bash.exit == 0);
  CHECK(bash.error.empty());
  const Outcome zsh = shell("command -v zsh >/dev/null || { echo SKIPPED: no zsh; exit; };" + tool +
                            " --completion zsh > c; zsh -n c");
  if (skipped(zsh)) return;
  CHECK(zsh.exit == 0);
  CHECK(zsh.error.empty());
  CHECK(shell(tool + " --completion fish").exit == 2);
}

// In a terminal of zsh's own module zpty; Tab behind "--mod" and "--model=mat". `until_shown` waits for what the
// shell shows, at most 20 s.
TEST_CASE("zsh completes options and the words of a choice", "[completion][contract][slow]") {
  const Outcome zsh = shell(
      "command -v zsh >/dev/null || { echo SKIPPED: no zsh; exit; }; mkdir zsh;"
      "asperity-generate --completion zsh > zsh/_asperity-generate; cat > ask.zsh <<'ASK'\n"
      "zmodload zsh/zpty\n"
      "until_shown() { for i in {1..400}; do zpty -r -t shell part && shown+=$part; [[ $shown == *$1* ]] && "
      "return;"
      " sleep 0.05; done; }\n"
      "zpty shell 'zsh -f -i'\n"
      "zpty -w shell \"PS1=; fpath=(\\$PWD/zsh \\$fpath); autoload -U compinit; compinit -u -D; bindkey '^I' "
      "complete-word; print rea''dy\"\n"
      "until_shown ready; zpty -n -w shell $'asperity-generate --mod\\t'; until_shown --model\n"
      "zpty -n -w shell $'mat\\t'; until_shown matern; print -r -- $shown\n"
      "ASK\n"
      "zsh -f ask.zsh");
  if (skipped(zsh)) return;
  CAPTURE(zsh.out, zsh.error);
  CHECK_THAT(zsh.out, ContainsSubstring("--model"));
  CHECK_THAT(zsh.out, ContainsSubstring("matern"));
}
