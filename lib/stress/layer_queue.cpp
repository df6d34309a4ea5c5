#include "stress/layer_queue.hpp"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <vector>

#include "core/parallel.hpp"

namespace asperity {
namespace {

struct LayerQueue {
  const Index count, window;  // layers, and how many may be ahead of those handed over
  const ComputeLayer& compute;
  const LayersFinished& finished;
  std::vector<bool> complete = std::vector<bool>(static_cast<std::size_t>(count));
  Index next = 0, handed_over = 0;
  bool failed = false;
  std::mutex mutex = {};
  std::condition_variable changed = {};

  void run(int worker) {
    try {
      take_part(worker);
    } catch (...) {
      const std::lock_guard lock(mutex);
      next = count, failed = true;
      changed.notify_all();
      throw;
    }
  }

  void take_part(int worker) {
    const bool caller = worker == 0;
    auto over = [&] { return caller ? handed_over == count : next == count; };
    for (std::unique_lock lock(mutex);; changed.notify_all()) {
      changed.wait(lock, [&] { return failed || ready() || (caller && due()) || over(); });
      if (failed || over()) return;
      if (caller && due()) {
        hand_over(lock);
        continue;
      }
      const Index layer = next++;
      lock.unlock();
      compute(layer, worker);
      lock.lock();
      complete[static_cast<std::size_t>(layer)] = true;
    }
  }

  void hand_over(std::unique_lock<std::mutex>& lock) {
    const Index begin = handed_over;
    Index end = begin;
    while (end < count && complete[static_cast<std::size_t>(end)]) ++end;
    lock.unlock();
    if (finished) finished(begin, end);
    lock.lock();
    handed_over = end;
  }

  bool ready() const { return next < count && next < handed_over + window; }
  bool due() const { return handed_over < count && complete[static_cast<std::size_t>(handed_over)]; }
};

}  // namespace

void in_layers(Index count, int threads, const ComputeLayer& compute, const LayersFinished& finished) {
  const Index workers = std::clamp<Index>(threads, 1, std::max<Index>(count, 1));
  LayerQueue queue{count, finished ? workers : count, compute, finished};
  parallel_ranges(workers, static_cast<int>(workers), [&](Index, Index, int worker) { queue.run(worker); });
}

}  // namespace asperity
