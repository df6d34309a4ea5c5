// Processes: work done apart, other programs, and what a signal leaves of a run. A fork is a process that one can have
// die at an exact place.
#include <chrono>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.hpp"
#include "tools/cli/program.hpp"
#include "tools/cli/sandbox.hpp"
#include "tools/cli/stream.hpp"
#include "tools/harness.hpp"

using namespace asperity;
using namespace asperity::test;
using cli::ProgramRun;
using cli::run_in_sandbox;

namespace {

using Sink = std::function<void(std::string_view)>;

constexpr WorkLimits small_limits{.seconds = 1, .memory = 64 << 20};

std::string bytes_of(const std::function<void(const Sink&)>& work) {
  return std::string(run_in_sandbox(work, small_limits, "work"));
}

std::string refusal_of(const std::function<void(const Sink&)>& work) {
  try {
    run_in_sandbox(work, small_limits, "work");
    return "";
  } catch (const DataError& error) {
    CHECK(error.name == "work");
    return error.what();
  }
}

volatile std::sig_atomic_t handled = 0;

}  // namespace

TEST_CASE("work done apart hands back its bytes, and leaves no trace where it was asked for",
          "[apart][contract]") {
  int touched = 0;
  CHECK(bytes_of([&](const Sink& sink) {
          touched = 1;
          sink("rough ");
          sink(std::string(100'000, 'x'));
        }) == "rough " + std::string(100'000, 'x'));
  CHECK(touched == 0);
  CHECK(bytes_of([](const Sink&) {}).empty());
}

TEST_CASE("work that refuses says so in its own words, and what it had written is forgotten",
          "[apart][contract]") {
  CHECK(refusal_of([](const Sink& sink) {
          sink("half of it");
          throw DataError("other", "it is empty");
        }) == "it is empty");
}

TEST_CASE("work that breaks, throws or ends is refused, without the handlers of the process that asked",
          "[apart][contract]") {
  const auto former = std::signal(SIGABRT, [](int) { handled = 1; });
  const std::function<void(const Sink&)> works[] = {
      [](const Sink&) { std::raise(SIGSEGV); },
      [](const Sink&) { std::raise(SIGABRT); },
      [](const Sink&) { throw 1; },
  };
  for (const auto& work : works) CHECK_THAT(refusal_of(work), ContainsSubstring("the file is damaged"));
  std::signal(SIGABRT, former);
  CHECK(handled == 0);
}

// A global heap that leads back to itself: HDF5 1.10 reads it for ever.
TEST_CASE("read apart, a NetCDF-4 file holds the same, and one at which the HDF5 library hangs is refused",
          "[apart][contract][slow]") {
  const auto bytes = [](const std::string& name) {
    return shell("cat " ASPERITY_TEST_DATA "/../corpus/netcdf4/" + name).out;
  };
  const std::string here = encode_netcdf(decode_netcdf(bytes("whole")));
  read_netcdf4_apart(&run_in_sandbox);
  CHECK(encode_netcdf(decode_netcdf(bytes("whole"))) == here);
  CHECK_THROWS_AS(decode_netcdf(bytes("hangs")), DataError);
  CHECK_THROWS_AS(decode_netcdf(bytes("never-written")), DataError);
  read_netcdf4_apart(nullptr);
}

// Shells and daemons hand that on: waiting for the child then failed.
TEST_CASE(
    "work is done apart in a process that ignores the end of its children, and it still does afterwards",
    "[apart][contract]") {
  const auto former = std::signal(SIGCHLD, SIG_IGN);
  CHECK(bytes_of([](const Sink& sink) { sink("rough"); }) == "rough");
  CHECK(std::signal(SIGCHLD, former) == SIG_IGN);
}

// One second is the limit; the clock of this process stands still meanwhile.
TEST_CASE("work without end is ended, and costs its asker no time", "[apart][time][contract][slow]") {
  const std::clock_t before = std::clock();
  CHECK_THAT(refusal_of([](const Sink&) {
               for (unsigned turns = 0;; ++turns) handled = turns % 2 == 0;
             }),
             ContainsSubstring("longer than 1 s"));
  CHECK(static_cast<double>(std::clock() - before) <= 0.5 * CLOCKS_PER_SEC);
}

#if !defined(__SANITIZE_ADDRESS__)
TEST_CASE("work that takes more memory than it may is refused", "[apart][memory][contract]") {
  CHECK_THAT(refusal_of([](const Sink& sink) {
               std::vector<std::string> hoard;
               while (hoard.size() < 32) hoard.emplace_back(8 << 20, 'x');  // four times the limit
               sink(hoard.back());
             }),
             ContainsSubstring("more memory"));
}
#endif

// ---- other programs ----

namespace {

constexpr std::size_t enough_memory = std::size_t{1} << 30;

ProgramRun sh(const std::string& script, std::string_view input = {},
              cli::ProgramLimits limits = {10, enough_memory}) {
  return cli::run_program("/bin/sh", {"-c", script}, input, limits);
}

std::string output_of(const std::string& script, std::string_view input = {}) {
  const ProgramRun run = sh(script, input);
  CHECK(run.end == ProgramRun::End::done);
  return std::string(std::string_view(run.output));
}

bool gone(const std::string& process) {
  for (int tries = 0; tries < 200; ++tries) {
    if (::kill(std::stoi(process), 0) != 0) return true;
    std::ifstream status("/proc/" + process + "/stat");
    if (std::string line; std::getline(status, line) && line.find(") Z ") != line.npos) return true;
    ::usleep(10'000);
  }
  return false;
}

}  // namespace

TEST_CASE("a program makes one file of another, in memory, without the user's environment",
          "[program][contract]") {
  CHECK(output_of("cat /proc/self/fd/4 > /proc/self/fd/3", "bytes") == "bytes");
  CHECK(output_of("echo $HOME $TMPDIR $XDG_CONFIG_HOME $DISPLAY > /proc/self/fd/3") ==
        "/dev/null /dev/null /dev/null\n");
  CHECK(output_of("cat > /proc/self/fd/3").empty());
  CHECK(output_of("ls /proc/self/fd > /proc/self/fd/3") == "0\n1\n2\n3\n4\n5\n");  // 5 is ls's own
  const ProgramRun run = sh("echo one; echo two >&2; exit 3");
  CHECK(run.end == ProgramRun::End::failed);
  CHECK(run.messages == "one\ntwo\n");
  CHECK(run.output.size() == 0);
  CHECK(cli::run_program("/dev/null", {}, {}, {10, enough_memory}).end == ProgramRun::End::not_started);
}

// The shell's own child sleeps for longer than a test.
TEST_CASE("a program that takes too long is ended with its children", "[program][contract]") {
  const auto begin = std::chrono::steady_clock::now();
  for (const char* script :
       {"sleep 1000 & echo $!; wait", "sleep 1000 >/dev/null 2>&1 & echo $!; exec >&- 2>&-; wait"}) {
    const ProgramRun run = sh(script, {}, {1, enough_memory});
    CHECK(run.end == ProgramRun::End::too_long);
    CHECK(gone(run.messages.substr(0, run.messages.find('\n'))));
  }
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(60));
  CHECK(sh("while :; do :; done", {}, {1, enough_memory}).end == ProgramRun::End::too_long);
  const ProgramRun left = sh("sleep 1000 >/dev/null 2>&1 & echo $!");
  CHECK(left.end == ProgramRun::End::done);
  CHECK(gone(left.messages.substr(0, left.messages.find('\n'))));
}

TEST_CASE("a program that writes or prints without end is ended, and takes no more than is allowed",
          "[program][contract]") {
  CHECK(sh("exec cat /dev/zero > /proc/self/fd/3", {}, {30, std::size_t{64} << 20}).end ==
        ProgramRun::End::too_large);
  const ProgramRun loud = sh("exec cat /dev/zero", {}, {1, enough_memory});
  CHECK(loud.end == ProgramRun::End::too_long);
  CHECK(loud.messages.size() <= 32768);
}

// ---- signals ----

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
  CHECK(content_of("replaced") == "whole");
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
  CHECK(content_of("half/file") == "former");
  CHECK(shell("ls -A half").out == "file\n");
}
