#include "tools/cli/program.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

#include "tools/cli/quantity.hpp"
#include "tools/cli/sandbox.hpp"
#include "tools/cli/stream.hpp"

namespace asperity::cli {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr int output_fd = 3, input_fd = 4, cannot_start = 127;
constexpr std::size_t most_messages = 16384;

OpenFile file_in_memory() { return {os::file_in_memory(), "a file in memory"}; }

// The environment, of nothing that is the user's.
std::vector<std::string> environment() {
  const char* path = std::getenv("PATH");
  std::vector<std::string> out{"LC_ALL=C.UTF-8", "OMP_NUM_THREADS=1",
                               std::string("PATH=") + (path != nullptr ? path : "/usr/bin:/bin")};
  for (const char* folder : {"HOME", "TMPDIR", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME",
                             "XDG_STATE_HOME", "XDG_RUNTIME_DIR"})
    out.push_back(std::string(folder) + "=/dev/null");
  return out;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> out;
  for (std::string& word : words) out.push_back(word.data());
  out.push_back(nullptr);
  return out;
}

struct Files {
  int output, input, messages, nowhere;
};

// Of the child: calls that are safe after a fork alone. Numbers are moved beyond those that they go to.
[[noreturn]] void become(const char* path, char** arguments, char** variables, Files files,
                         ProgramLimits limits, pid_t parent) {
  constexpr int beyond = 10;
  begin_child(parent, cannot_start);
  ::setpgid(0, 0);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  for (int* file : {&files.output, &files.input, &files.messages, &files.nowhere})
    if ((*file = ::fcntl(*file, F_DUPFD, beyond)) < 0) ::_exit(cannot_start);
  ::dup2(files.nowhere, STDIN_FILENO);
  ::dup2(files.messages, STDOUT_FILENO);
  ::dup2(files.messages, STDERR_FILENO);
  ::dup2(files.output, output_fd);
  ::dup2(files.input, input_fd);
  os::close_from(input_fd + 1);
  lower_limit(RLIMIT_CPU, limits.seconds);
  lower_limit(RLIMIT_AS, limits.memory);
  lower_limit(RLIMIT_FSIZE, limits.memory);
  ::execve(path, arguments, variables);
  ::_exit(cannot_start);
}

// What the child prints until nobody can print any more, as far as it is kept; false when the time is over.
bool listen(int fd, std::string& messages, Clock::time_point end) {
  std::array<char, 4096> piece;
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
    if (left <= 0ms) return false;
    pollfd wanted{fd, POLLIN, 0};
    if (::poll(&wanted, 1, static_cast<int>(left.count())) <= 0) continue;
    const ssize_t n = ::read(fd, piece.data(), piece.size());
    if (n == 0) return true;
    if (n > 0 && messages.size() < most_messages) messages.append(piece.data(), static_cast<std::size_t>(n));
  }
}

// Whether a child ends in time. It is not waited for: until then its number stays that of its group.
bool ends(pid_t child, Clock::time_point end) {
  for (; Clock::now() < end; std::this_thread::sleep_for(2ms)) {
    siginfo_t found{};
    if (::waitid(P_PID, static_cast<id_t>(child), &found, WEXITED | WNOHANG | WNOWAIT) == 0 &&
        found.si_pid == child)
      return true;
  }
  return false;
}

ProgramRun::End meaning_of(int status) {
  using enum ProgramRun::End;
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return signal == SIGXCPU || signal == SIGKILL ? too_long : signal == SIGXFSZ ? too_large : failed;
  }
  const int code = WEXITSTATUS(status);
  return code == 0 ? done : code == cannot_start ? not_started : failed;
}

}  // namespace

std::string program_path(const std::string& name) {
  const char* folders = std::getenv("PATH");
  for (const std::string& folder : split(folders != nullptr ? folders : "/usr/bin:/bin", ':')) {
    const std::string path = (folder.empty() ? "." : folder) + "/" + name;
    std::error_code none;
    if (::access(path.c_str(), X_OK) == 0 && std::filesystem::is_regular_file(path, none)) return path;
  }
  return {};
}

ProgramRun run_program(const std::string& path, const std::vector<std::string>& arguments,
                       std::string_view input, ProgramLimits limits) {
  const EndOfChildren heard;
  const OpenFile output = file_in_memory(), given = file_in_memory(),
                 nowhere(::open("/dev/null", O_RDONLY | O_CLOEXEC), "/dev/null");
  write_to(given.fd(), input, "a file in memory");
  ::lseek(given.fd(), 0, SEEK_SET);  // not every system opens it anew by its path
  auto [read_end, write_end] = pipe_ends();
  std::vector<std::string> words{path}, variables = environment();
  words.insert(words.end(), arguments.begin(), arguments.end());
  const std::vector<char*> argv = pointers(words), envp = pointers(variables);
  const pid_t parent = ::getpid(), child = ::fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "a process of its own");
  if (child == 0)
    become(path.c_str(), const_cast<char**>(argv.data()), const_cast<char**>(envp.data()),
           {output.fd(), given.fd(), write_end.fd(), nowhere.fd()}, limits, parent);
  ::setpgid(child, child);
  write_end.close();
  ProgramRun out;
  const auto end = Clock::now() + std::chrono::seconds(limits.seconds);
  const bool in_time = listen(read_end.fd(), out.messages, end) && ends(child, end);
  ::kill(-child, SIGKILL);
  const int status = status_of(child);
  out.end = in_time ? meaning_of(status) : ProgramRun::End::too_long;
  if (out.end == ProgramRun::End::done) out.output = Bytes::mapped(os::descriptor_path(output.fd()));
  return out;
}

}  // namespace asperity::cli
