// What a tool is made of: options, messages, settings of the run, datasets, each by itself.
#include <cstdlib>
#include <fstream>

#include "core/error.hpp"
#include "support.hpp"
#include "tools/cli/datasets.hpp"
#include "tools/cli/messages.hpp"
#include "tools/cli/options.hpp"
#include "tools/cli/run_settings.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

void parse(cli::Options& options, std::vector<std::string> words) {
  words.insert(words.begin(), options.name());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  options.parse(static_cast<int>(argv.size()), argv.data());
}

// The parts of a program that writes a dataset, and a report.
struct Parts {
  cli::Options options{"asperity-stats", "of a test"};
  cli::Messages messages{"asperity-stats", options};
  cli::RunSettings settings{options, messages};
  cli::Datasets datasets{options, messages, settings};

  Parts() {
    datasets.output();
    datasets.report();
    datasets.declare_output();
    settings.memory("Memory");
    messages.declare(options);
  }
};

}  // namespace

TEST_CASE("options are read without a tool: command line before environment before default",
          "[parts][contract]") {
  ::setenv("ASPERITY_STATS_LOAD", "5kN", 1);
  ::setenv("ASPERITY_STATS_YOUNG", "2GPa", 1);
  cli::Options options("asperity-stats", "of a test");
  double load = 1, young = 1, radius = 3;
  options.quantity("--load", load, "N", "Load", "Scene");
  options.quantity("--young", young, "Pa", "Modulus", "Scene");
  options.quantity("--radius", radius, "m", "Radius", "Scene");
  parse(options, {"--load", "7N"});
  ::unsetenv("ASPERITY_STATS_LOAD");
  ::unsetenv("ASPERITY_STATS_YOUNG");
  CHECK(load == 7);
  CHECK(young == 2e9);
  CHECK(radius == 3);
  CHECK(options.given("--young"));
  CHECK_FALSE(options.given("--radius"));
  CHECK(options.typed("young", "2e+09 is too stiff") == "ASPERITY_STATS_YOUNG 2GPa");
}

TEST_CASE("a command line that cannot be read is one error in words, and a text that is asked for is thrown",
          "[parts][contract]") {
  cli::Options options("asperity-stats", "of a test");
  bool wide = false;
  options.flag("--wide", wide, "Wide", "Scene");
  options.documents();
  CHECK_THROWS_MATCHES(parse(options, {"--wyde"}), cli::CommandLineError,
                       Message("there is no option --wyde: did you mean --wide?"));
  try {
    parse(options, {"--help"});
    FAIL("no text");
  } catch (const cli::Printout& asked) {
    CHECK_THAT(asked.text, ContainsSubstring("--wide"));
  }
}

TEST_CASE("no output is another output or an input, whatever its spelling", "[parts][contract]") {
  const std::string file = scratch("same.nc"), other = scratch(".") + "/same.nc";
  std::ofstream(file) << "there";
  Parts parts;
  parse(parts.options, {"-o", file});
  parts.datasets.check_outputs();
  CHECK_THROWS_AS(parts.datasets.writes("report", other), cli::UsageError);
  CHECK_NOTHROW(parts.datasets.writes("report", scratch("report.json")));
  CHECK_THROWS_AS(parts.datasets.reads(other), cli::UsageError);
  CHECK_NOTHROW(parts.datasets.reads(other, true));  // all of it goes there
}

TEST_CASE("memory is refused by what needs it, and an input of 16 MiB is always read", "[parts][contract]") {
  Parts parts;
  parse(parts.options, {"--memory", "1MB"});
  CHECK(parts.settings.memory_bound().bytes == std::size_t{16} << 20);
  CHECK_NOTHROW(parts.settings.require_memory(16e6, "shape", "a contact"));
  CHECK_THROWS_MATCHES(parts.settings.require_memory(20e6, "shape", "a contact"), cli::UsageError,
                       Message("a contact needs some 20MB, more than the 17MB that --memory allows"));
}
