#include "tools/cli/sandbox.hpp"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <mutex>
#include <new>
#include <string_view>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "core/error.hpp"
#include "tools/cli/child.hpp"
#include "tools/cli/stream.hpp"

namespace asperity::cli {
namespace {

// How a child ends that could say so, apart from what a library ends with.
enum Ending { finished = 0, refused = 101, out_of_memory = 102, failed = 103 };

// Bytes of address space; 0 where the system does not tell. The address sanitizer takes more than it needs.
std::size_t address_space() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

void confine(WorkLimits limits, pid_t parent, std::size_t present) {
  begin_child(parent, failed);
  lower_limit(RLIMIT_CPU, limits.seconds);
  if (present > 0) lower_limit(RLIMIT_AS, present + limits.memory);
  if (const int nowhere = ::open("/dev/null", O_WRONLY); nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
}

// A pipe from the child: unlike a file, it knows no limit of its size, and needs no place.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), name);
  }
  ~Pipe() {
    close(0);
    close(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  /// Of the child: once nobody reads any more, writing ends it.
  void only_write() { close(0); }
  void write(std::string_view bytes) const { write_to(ends_[1], bytes, name); }
  /// Until nobody can write any more; this process no longer can.
  Bytes read() {
    close(1);
    return read_to_end(ends_[0], name, {});
  }

 private:
  static constexpr const char* name = "a pipe";
  void close(int end) {
    if (const int fd = std::exchange(ends_[end], -1); fd >= 0) ::close(fd);
  }
  int ends_[2] = {-1, -1};
};

// Bytes of the work, or, behind what there is of them and a NUL, the words with which it refuses.
Ending work_into(const Pipe& out, const WorkOfBytes& work) noexcept try {
  try {
    work([&](std::string_view bytes) { out.write(bytes); });
    return finished;
  } catch (const DataError& error) {
    out.write(std::string_view("", 1));
    out.write(error.what());
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
  Pipe pipe;
  const EndOfChildren heard;
  const std::size_t present = address_space();
  const pid_t parent = ::getpid(), child = ::fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "a process of its own");
  if (child == 0) {
    confine(limits, parent, present);
    pipe.only_write();
    ::_exit(work_into(pipe, work));
  }
  Bytes out = pipe.read();
  const int status = status_of(child);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != finished) refuse(status, out, limits, variable);
  return out;
}

}  // namespace asperity::cli
