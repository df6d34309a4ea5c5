#include "tools/cli/child.hpp"

#include <cerrno>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace asperity::cli {

EndOfChildren::EndOfChildren() {
  struct sigaction usual {};
  usual.sa_handler = SIG_DFL;
  ::sigaction(SIGCHLD, &usual, &former_);
}

EndOfChildren::~EndOfChildren() { ::sigaction(SIGCHLD, &former_, nullptr); }

void lower_limit(int resource, rlim_t bound) {
  struct rlimit limit {};
  ::getrlimit(static_cast<__rlimit_resource>(resource), &limit);
  if (limit.rlim_max != RLIM_INFINITY && limit.rlim_max < bound) bound = limit.rlim_max;
  limit.rlim_cur = limit.rlim_max = bound;
  ::setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

void begin_child(pid_t parent, int failed) {
  for (int signal = 1; signal < NSIG; ++signal) std::signal(signal, SIG_DFL);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(failed);
  lower_limit(RLIMIT_CORE, 0);
}

int status_of(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "a process of its own");
  return status;
}

}  // namespace asperity::cli
