/// What a process needs to start another one under limits, and to wait for it.
#pragma once

#include <csignal>
#include <sys/resource.h>
#include <sys/types.h>

namespace asperity::cli {

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
void lower_limit(int resource, rlim_t bound);
/// Waits for the end of a child. Throws std::system_error where there is none.
int status_of(pid_t child);

}  // namespace asperity::cli
