#include "dataset/apart.hpp"

#include <csignal>
#include <ctime>
#include <vector>

#include "grid/error.hpp"
#include "support.hpp"

using namespace asperity;

namespace {

using Sink = std::function<void(std::string_view)>;

constexpr Limits small{.seconds = 1, .memory = 64 << 20};

std::string bytes_of(const std::function<void(const Sink&)>& work) {
  const SparseFile out = made_apart(work, small, "work");
  return out.first(out.size());
}

std::string refusal_of(const std::function<void(const Sink&)>& work) {
  try {
    made_apart(work, small, "work");
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
  for (const auto& work : works) CHECK_THAT(refusal_of(work), ContainsSubstring("it is damaged"));
  std::signal(SIGABRT, former);
  CHECK(handled == 0);
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
TEST_CASE("work without end is ended, and costs its asker no time", "[apart][time][contract]") {
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
