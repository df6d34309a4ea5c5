/// What memory a call takes at its peak: that of a child process that makes it, less that of one that does nothing.
#pragma once

#include <cmath>
#include <cstdio>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace asperity {

/// The largest resident set of a child process that does this [MB], NaN if it fails.
template <class Work>
double resident_peak(const Work& work) {
  ::malloc_trim(0);
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ::_exit(0);
  }
  int status = 0;
  rusage used{};
  const bool done = child > 0 && ::wait4(child, &status, 0, &used) == child && status == 0;
  return done ? static_cast<double>(used.ru_maxrss) * 1024e-6 : NAN;
}

/// What this takes beyond what the process has already [MB].
template <class Work>
double peak_memory(const Work& work) {
  const double idle = resident_peak([] {});
  return resident_peak(work) - idle;
}

}  // namespace asperity
