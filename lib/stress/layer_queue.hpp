/// Layers on several threads, handed over in order.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <vector>

#include "core/parallel.hpp"

namespace asperity {

/// finished(begin, end): the layers before `end` are complete.
using LayersFinished = std::function<void(Index begin, Index end)>;

/// compute(layer, work) for each layer < count, work of the thread. finished() is called from the calling thread; where
/// there is one, no layer `threads` or more beyond the last that it knows is begun, so that as many buffers will do.
template <class Work, class Compute>
class LayerQueue {
 public:
  LayerQueue(Index count, int threads, Compute compute, const LayersFinished& finished)
      : count_(count),
        workers_(std::clamp<Index>(threads, 1, std::max<Index>(count, 1))),
        window_(finished ? workers_ : count),
        compute_(compute),
        finished_(finished),
        complete_(static_cast<std::size_t>(count)) {}

  void run() {
    parallel_ranges(workers_, static_cast<int>(workers_), [&](Index, Index, int worker) {
      try {
        take_part(worker == 0);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        next_ = count_, failed_ = true;
        changed_.notify_all();
        throw;
      }
    });
  }

 private:
  void take_part(bool caller) {
    Work work;
    for (std::unique_lock lock(mutex_);; changed_.notify_all()) {
      changed_.wait(lock, [&] { return failed_ || ready() || (caller ? due() || over() : drained()); });
      if (failed_ || (caller ? over() : drained())) return;
      if (caller && due()) {
        hand_over(lock);
        continue;
      }
      const Index layer = next_++;
      lock.unlock();
      compute_(layer, work);
      lock.lock();
      complete_[static_cast<std::size_t>(layer)] = true;
    }
  }

  void hand_over(std::unique_lock<std::mutex>& lock) {
    const Index begin = handed_over_;
    Index end = begin;
    while (end < count_ && complete_[static_cast<std::size_t>(end)]) ++end;
    lock.unlock();
    if (finished_) finished_(begin, end);
    lock.lock();
    handed_over_ = end;
  }

  bool ready() const { return next_ < count_ && next_ < handed_over_ + window_; }
  bool due() const { return handed_over_ < count_ && complete_[static_cast<std::size_t>(handed_over_)]; }
  bool drained() const { return next_ == count_; }
  bool over() const { return handed_over_ == count_; }

  const Index count_, workers_, window_;
  Compute compute_;
  const LayersFinished& finished_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<bool> complete_;
  Index next_ = 0, handed_over_ = 0;
  bool failed_ = false;
};

/// Runs such a queue.
template <class Work, class Compute>
void in_layers(Index count, int threads, Compute compute, const LayersFinished& finished) {
  LayerQueue<Work, Compute>(count, threads, compute, finished).run();
}

}  // namespace asperity
