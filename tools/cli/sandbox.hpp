/// Work that may hang, crash or take all memory, done in a process of its own.
///
/// No library bounds what it does with a hostile file. A forked process does the work under limits and
/// returns bytes; if it fails, the parent goes on. The child runs the work only: no signal handlers, no exit
/// handlers, no flush of buffers, no standard error; it ends with its parent. The work must not need a lock
/// that another thread may hold (malloc's are safe). One thread at a time may call; during the call the
/// process receives SIGCHLD.
///
/// Cost      about a millisecond, and the bytes once in memory.
#pragma once

#include <array>
#include <csignal>
#include <string>
#include <sys/resource.h>
#include <sys/types.h>
#include <utility>

#include "dataset/netcdf.hpp"

namespace asperity::cli {

/// The bytes that the work hands to its sink. Throws DataError(variable, …): the work's own, or one for a
/// broken limit (memory not under the address sanitizer) or a crash.
Bytes run_in_sandbox(const WorkOfBytes& work, WorkLimits limits, const std::string& variable);

// ---- for any process under limits ----

/// A descriptor, closed with this object.
class OpenFile {
 public:
  /// Throws std::system_error, "NAME: …", where there is none.
  OpenFile(int fd, const char* name);
  ~OpenFile() { close(); }
  OpenFile(OpenFile&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  OpenFile& operator=(OpenFile&&) = delete;

  int fd() const { return fd_; }
  void close();

 private:
  int fd_;
};
/// Where to read and where to write: unlike a file, a pipe knows no limit of its size, and needs no place.
std::array<OpenFile, 2> pipe_ends();

/// A process that ignores its children's end cannot wait for it: until this object's end it does not.
class EndOfChildren {
 public:
  EndOfChildren();
  ~EndOfChildren();
  EndOfChildren(const EndOfChildren&) = delete;
  EndOfChildren& operator=(const EndOfChildren&) = delete;

 private:
  struct sigaction former_ {};
};

/// Of a child, before its work: usual answers to signals, an end with its parent, and no core file.
/// Ends the child with `failed` where the parent is gone already.
void begin_child(pid_t parent, int failed);
/// Lowers a limit of this process for good; a lower one stays.
void lower_limit(decltype(RLIMIT_CPU) resource, rlim_t bound);
/// Waits for the end of a child. Throws std::system_error where there is none.
int status_of(pid_t child);

}  // namespace asperity::cli
