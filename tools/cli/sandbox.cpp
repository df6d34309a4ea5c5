#include "tools/cli/sandbox.hpp"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <mutex>
#include <new>
#include <string_view>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "core/error.hpp"
#include "core/os.hpp"
#include "tools/cli/stream.hpp"

namespace asperity::cli {

OpenFile::OpenFile(int fd, const char* name) : fd_(fd) {
  if (fd < 0) throw std::system_error(errno, std::generic_category(), name);
}

void OpenFile::close() {
  if (const int fd = std::exchange(fd_, -1); fd >= 0) ::close(fd);
}

std::array<OpenFile, 2> pipe_ends() {
  int ends[2] = {-1, -1};
  os::open_pipe(ends);
  return {OpenFile(ends[0], "a pipe"), OpenFile(ends[1], "a pipe")};
}

EndOfChildren::EndOfChildren() {
  struct sigaction usual {};
  usual.sa_handler = SIG_DFL;
  ::sigaction(SIGCHLD, &usual, &former_);
}

EndOfChildren::~EndOfChildren() { ::sigaction(SIGCHLD, &former_, nullptr); }

void lower_limit(decltype(RLIMIT_CPU) resource, rlim_t bound) {
  struct rlimit limit {};
  ::getrlimit(resource, &limit);
  if (limit.rlim_max != RLIM_INFINITY && limit.rlim_max < bound) bound = limit.rlim_max;
  limit.rlim_cur = limit.rlim_max = bound;
  ::setrlimit(resource, &limit);
}

void begin_child(pid_t parent, int failed) {
  for (int signal = 1; signal < NSIG; ++signal) std::signal(signal, SIG_DFL);
  os::end_with_parent();
  if (::getppid() != parent) ::_exit(failed);
  lower_limit(RLIMIT_CORE, 0);
}

int status_of(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "a process of its own");
  return status;
}

namespace {

// How a child ends that could say so, apart from what a library ends with.
enum Ending { finished = 0, refused = 101, out_of_memory = 102, failed = 103 };

void confine(WorkLimits limits, pid_t parent, std::size_t present) {
  begin_child(parent, failed);
  lower_limit(RLIMIT_CPU, limits.seconds);
  if (present > 0) lower_limit(RLIMIT_AS, present + limits.memory);  // else the system does not tell it
  if (const int nowhere = ::open("/dev/null", O_WRONLY); nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
}

// Bytes of the work; where it refuses, those written so far, a NUL, and the words with which it refuses.
Ending work_into(int pipe, const WorkOfBytes& work) noexcept try {
  const auto write = [&](std::string_view bytes) { write_to(pipe, bytes, "a pipe"); };
  try {
    work(write);
    return finished;
  } catch (const DataError& error) {
    write(std::string_view("", 1));
    write(error.what());
    return refused;
  }
} catch (const std::bad_alloc&) {
  return out_of_memory;
} catch (...) {
  return failed;
}

[[noreturn]] void refuse(int status, std::string_view out, WorkLimits limits, const std::string& variable) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == refused)
    throw DataError(variable, std::string(out.substr(out.rfind('\0') + 1)));
  if (WIFEXITED(status) && WEXITSTATUS(status) == out_of_memory)
    throw DataError(variable, "reading it needs more memory than the " +
                                  std::to_string(limits.memory / 1'000'000) +
                                  "MB that its size and --memory allow");
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL))
    throw DataError(variable, "reading it takes longer than " + std::to_string(limits.seconds) +
                                  " s: the file is damaged");
  throw DataError(variable, "the file is damaged: the NetCDF library cannot read it");
}

}  // namespace

Bytes run_in_sandbox(const WorkOfBytes& work, WorkLimits limits, const std::string& variable) {
  static std::mutex one_at_a_time;  // a child inherits the pipe of another, and signals are the process's
  const std::scoped_lock lock(one_at_a_time);
  auto [read_end, write_end] = pipe_ends();
  const EndOfChildren heard;
  const std::size_t present = os::address_space();
  const pid_t parent = ::getpid(), child = ::fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "a process of its own");
  if (child == 0) {
    confine(limits, parent, present);
    read_end.close();  // once nobody reads any more, writing ends the child
    ::_exit(work_into(write_end.fd(), work));
  }
  write_end.close();
  Bytes out = read_to_end(read_end.fd(), "a pipe", {});
  const int status = status_of(child);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != finished) refuse(status, out, limits, variable);
  return out;
}

}  // namespace asperity::cli
