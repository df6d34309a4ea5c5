#include "stress/layer_queue.hpp"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <vector>

#include "core/parallel.hpp"

namespace asperity {
namespace {

class LayerQueue {
 public:
  LayerQueue(Index count, Index window, const ComputeLayer& compute, const LayersFinished& finished)
      : count_(count),
        window_(window),
        compute_(compute),
        finished_(finished),
        complete_(static_cast<std::size_t>(count)) {}

  void run(int worker) {
    try {
      take_part(worker);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      next_ = count_, failed_ = true;
      changed_.notify_all();
      throw;
    }
  }

 private:
  void take_part(int worker) {
    const bool caller = worker == 0;
    for (std::unique_lock lock(mutex_);; changed_.notify_all()) {
      changed_.wait(lock, [&] { return failed_ || ready() || (caller ? due() || over() : drained()); });
      if (failed_ || (caller ? over() : drained())) return;
      if (caller && due()) {
        hand_over(lock);
        continue;
      }
      const Index layer = next_++;
      lock.unlock();
      compute_(layer, worker);
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

  const Index count_, window_;  ///< of all, and how many may be ahead of those handed over
  const ComputeLayer& compute_;
  const LayersFinished& finished_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<bool> complete_;
  Index next_ = 0, handed_over_ = 0;
  bool failed_ = false;
};

}  // namespace

void in_layers(Index count, int threads, const ComputeLayer& compute, const LayersFinished& finished) {
  const Index workers = std::clamp<Index>(threads, 1, std::max<Index>(count, 1));
  LayerQueue queue(count, finished ? workers : count, compute, finished);
  parallel_ranges(workers, static_cast<int>(workers), [&](Index, Index, int worker) { queue.run(worker); });
}

}  // namespace asperity
