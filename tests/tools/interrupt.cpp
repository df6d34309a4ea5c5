// What a signal leaves of a run: nothing. A fork is a process that one can have die at an exact place.
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sys/wait.h>
#include <unistd.h>

#include "support.hpp"
#include "tools/cli/stream.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// The wait status of a process that does this and then, if it still can, exits with 0.
template <class Deed>
int fate(Deed deed) {
  const pid_t child = ::fork();
  if (child == 0) {
    for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM})
      std::signal(signal, SIG_DFL);  // not Catch2's
    deed();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

std::string content(const std::string& name) {
  std::ifstream in(scratch(name), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

const std::string bodies = " --radius 50mm --young 208GPa --poisson 0.3 --load 5000N ";

}  // namespace

TEST_CASE("a temporary name is gone with the process that a signal ends", "[interrupt][contract]") {
  const std::string path = scratch("fleeting");
  for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM}) {
    const int status = fate([&] {
      const cli::TemporaryName name(path);
      std::ofstream(path) << "half";
      if (std::filesystem::exists(path)) std::raise(signal);
    });
    CAPTURE(signal);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == signal);
    CHECK_FALSE(std::filesystem::exists(path));
  }
}

TEST_CASE("a signal that a process was started to ignore is ignored still", "[interrupt][contract]") {
  const std::string path = scratch("kept");
  const int status = fate([&] {
    std::signal(SIGINT, SIG_IGN);
    cli::TemporaryName name(path);
    std::ofstream(path) << "whole";
    std::raise(SIGINT);
    if (!name.replace(scratch("replaced"))) ::_exit(1);
  });
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
  CHECK(content("replaced") == "whole");
  CHECK_FALSE(std::filesystem::exists(path));
}

TEST_CASE("a file that is written when a signal comes stays what it was, and no part of the new one is left",
          "[interrupt][contract]") {
  std::filesystem::create_directory(scratch("half"));
  std::ofstream(scratch("half/file")) << "former";
  const int status = fate([] {
    cli::OutputFile file(scratch("half/file"));
    file.write("new, but");
    std::raise(SIGTERM);
  });
  CHECK(WTERMSIG(status) == SIGTERM);
  CHECK(content("half/file") == "former");
  CHECK(shell("ls -A half").out == "file\n");
}

// The pipe takes 64 KiB at the most: once 200 kB have gone through, the tool is reading, and waits for more.
TEST_CASE("a tool that is interrupted while it reads leaves the target as it was", "[interrupt][contract]") {
  REQUIRE(
      shell("asperity-generate --shape 256x256 --size 3mm --rq 1um --length 4px --seed 1 -o long.nc").exit ==
      0);
  for (const std::string& tool : {"asperity-contact" + bodies + "-o", std::string("asperity-stats -o"),
                                  std::string("asperity-stress --poisson 0.3 --depths 1mm -o")})
    for (const auto& [signal, exit] : {std::pair("INT", "130\n"), std::pair("TERM", "143\n")}) {
      const Outcome run =
          shell("set -m; rm -rf there; mkdir there; echo former > there/out; mkfifo there/in;" + tool +
                " there/out < there/in & exec 3> there/in; head -c 200000 long.nc >&3; kill -" + signal +
                " %1; wait $!; echo $?; rm there/in; ls -A there; cat there/out");
      CAPTURE(tool, signal, run.error);
      CHECK(run.out == std::string(exit) + "out\nformer\n");
    }
}

// The first line of --verbose tells that the solution has begun; the tolerance is below what round-off allows
// and the grid large, so that it does not end before the signal.
TEST_CASE("a tool that is interrupted while it solves leaves the target as it was", "[interrupt][contract]") {
  const Outcome run = shell(
      "set -m; mkdir solving; echo former > solving/out; mkfifo progress;"
      "asperity-contact --smooth --shape 1024x1024 --size 3mm --tolerance 1e-14 -v" +
      bodies +
      "-o solving/out 2> progress & exec 4< progress; read line <&4; kill -TERM %1; wait $!; echo $?;"
      "ls -A solving; cat solving/out");
  CAPTURE(run.error);
  CHECK(run.out == "143\nout\nformer\n");
}

// The line of --verbose comes between the search for the maximum and the layers, of which there are more than
// can be done before the signal.
TEST_CASE("a tool that is interrupted while it writes layer by layer leaves the target as it was",
          "[interrupt][contract]") {
  const Outcome run = shell(
      "set -m; mkdir layers; echo former > layers/out; mkfifo told;"
      "asperity-contact --smooth --shape 256x256 --size 3mm" +
      bodies +
      "-o smooth.nc; asperity-stress smooth.nc --depths 0:0.2mm:2000 --maximum -v -o layers/out 2> told &"
      "exec 4< told; read line <&4; kill -TERM %1; wait $!; echo $?; ls -A layers; cat layers/out");
  CAPTURE(run.error);
  CHECK(run.out == "143\nout\nformer\n");
}
