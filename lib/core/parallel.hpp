/// Loops over independent pieces on several threads, in contiguous runs, one per thread. There are no
/// reductions across threads: results do not depend on their number.
///
/// A thread that works alone, as one of several on a piece of work each, runs its loops by itself.
#pragma once

#include <algorithm>
#include <exception>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "core/field.hpp"

namespace asperity {

/// Whether this thread works alone.
bool works_alone();
/// From now on, to the thread's end.
void work_alone();

/// Number of threads for a request on the command line; 0: all of the machine. 1 where a thread works alone.
inline int resolve_threads(int requested) {
  if (works_alone()) return 1;
  return requested > 0 ? requested : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Threads that have ended when this object does, as std::jthread, which libc++ has from version 20 on.
class JoinedThreads {
 public:
  JoinedThreads() = default;
  ~JoinedThreads() {
    for (std::thread& thread : threads_) thread.join();
  }
  JoinedThreads(const JoinedThreads&) = delete;
  JoinedThreads& operator=(const JoinedThreads&) = delete;

  /// Throws std::system_error where the system gives no thread.
  template <class Work>
  void start(Work&& work) {
    threads_.emplace_back(std::forward<Work>(work));
  }
  std::size_t size() const { return threads_.size(); }

 private:
  std::vector<std::thread> threads_ = {};
};

/// Calls run(begin, end, worker) on runs that cover [0, count); worker < threads selects a buffer. Costs 30
/// µs per thread. Rethrows the first exception. If a thread cannot start for lack of memory, the caller does
/// its run.
template <class Run>
void parallel_ranges(Index count, int threads, Run run) {
  const Index workers = works_alone() ? 1 : std::clamp<Index>(threads, 1, std::max<Index>(count, 1));
  if (workers == 1) {
    run(Index{0}, count, 0);
    return;
  }
  std::vector<std::exception_ptr> failures(static_cast<std::size_t>(workers));
  {
    JoinedThreads pool;
    auto guarded = [&](Index w) {
      try {
        run(w * count / workers, (w + 1) * count / workers, static_cast<int>(w));
      } catch (...) {
        failures[static_cast<std::size_t>(w)] = std::current_exception();
      }
    };
    for (Index w = 1; w < workers; ++w) try {
        pool.start([&guarded, w] { guarded(w); });
      } catch (const std::system_error&) {
        guarded(w);
      }
    guarded(0);
  }
  for (const auto& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

}  // namespace asperity
