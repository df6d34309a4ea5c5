#include "tools/cli/sandbox.hpp"

#include <csignal>
#include <ctime>
#include <fstream>
#include <sstream>
#include <vector>

#include "core/error.hpp"
#include "support.hpp"

using namespace asperity;
using cli::run_in_sandbox;

namespace {

using Sink = std::function<void(std::string_view)>;

constexpr WorkLimits small{.seconds = 1, .memory = 64 << 20};

std::string bytes_of(const std::function<void(const Sink&)>& work) {
  return std::string(run_in_sandbox(work, small, "work"));
}

std::string refusal_of(const std::function<void(const Sink&)>& work) {
  try {
    run_in_sandbox(work, small, "work");
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
  const std::string folder = ASPERITY_TEST_DATA "/../corpus/netcdf4/";
  const auto bytes = [&](const std::string& name) {
    std::ostringstream out;
    out << std::ifstream(folder + name, std::ios::binary).rdbuf();
    return out.str();
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
