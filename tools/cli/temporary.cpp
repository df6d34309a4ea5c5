#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <unistd.h>
#include <utility>

#include "tools/cli/stream.hpp"

namespace asperity::cli {
namespace {

// What a handler may read at any time.
std::array<std::atomic<const char*>, 256> names{};
static_assert(std::atomic<const char*>::is_always_lock_free);

extern "C" void remove_names_and_end(int signal) {
  for (const auto& name : names)
    if (const char* path = name.load()) ::unlink(path);
  std::signal(signal, SIG_DFL);
  std::raise(signal);  // blocked until this handler returns
}

void handle_signals() {
  for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU, SIGXFSZ}) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) continue;
    action.sa_handler = &remove_names_and_end;
    ::sigaction(signal, &action, nullptr);
  }
}

}  // namespace

TemporaryName::TemporaryName(std::string path) : path_(std::move(path)) {
  static const bool handled = (handle_signals(), true);
  static_cast<void>(handled);
  for (auto& name : names) {
    const char* nothing = nullptr;
    if (name.compare_exchange_strong(nothing, path_.c_str())) return;
  }
  throw std::length_error("too many files are being written");
}

TemporaryName::~TemporaryName() {
  if (known_) ::unlink(path());
  forget();
}

bool TemporaryName::replace(const std::string& target) {
  if (std::rename(path(), target.c_str()) != 0) return false;
  forget();
  return true;
}

void TemporaryName::forget() {
  if (!std::exchange(known_, false)) return;
  for (auto& name : names) {
    const char* mine = path();
    if (name.compare_exchange_strong(mine, nullptr)) return;
  }
}

}  // namespace asperity::cli
