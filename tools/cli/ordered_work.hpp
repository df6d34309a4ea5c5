/// Pieces of work done at once, one thread each, whose results are taken in the order of the pieces.
///
///     OrderedWork all(datasets_at_once(tool, shape));
///     for (const std::string& name : names)
///       all.add([&, name]() -> Action {
///         Parameters found = measure(read(name));                          // on a thread of its own
///         return [&, found = std::move(found)] { mean.add(found); };      // on this thread, in order
///       });
///     all.finish();
///
/// A run prints and writes the same as with one piece after the other, to the last byte: what others see of a
/// piece waits until its order comes. The frame does so by in_order() for messages (Tool::warn and its like)
/// and for the names of files that have been written; nothing outside tools/cli needs to. An error of a piece
/// comes from add() or finish() in its order, and nothing of later pieces is seen.
///
/// Memory    of twice as many pieces as are worked on at once, with what they have left.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <vector>

#include "core/field.hpp"
#include "core/parallel.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

/// How many datasets of this shape are worked on at once: as many as the run has threads where these are too
/// small for threads to share, and fewer where they need more than --memory; 1 with --verbose, whose lines
/// come as they arise.
int datasets_at_once(const Tool& tool, Shape shape);
/// Whether a dataset of this shape, though there are several, is worth all threads.
bool is_worth_all_threads(Shape shape);

using Action = std::function<void()>;

/// For the frame: does this when the results of all earlier pieces have been taken; at once outside a piece.
void in_order(Action action);

class OrderedWork {
 public:
  /// 1: add() does the work itself.
  explicit OrderedWork(int at_once);
  /// Without finish(): waits for work that goes on, takes nothing of it, and begins no other.
  ~OrderedWork();
  OrderedWork(const OrderedWork&) = delete;
  OrderedWork& operator=(const OrderedWork&) = delete;

  /// Work that returns how to take its result. Waits for the first pieces where too many are under way.
  void add(std::function<Action()> work);
  /// Until nothing is left.
  void finish();

 private:
  struct Piece {
    explicit Piece(Action action) : work(std::move(action)) {}

    std::packaged_task<void()> work;
    std::future<void> end = work.get_future();
    std::vector<Action> left = {};  ///< for the thread that takes them
  };
  void serve();
  void take_first();

  std::size_t at_once_;
  std::mutex mutex_ = {};
  std::condition_variable added_ = {};              ///< a piece, or the end
  std::deque<std::unique_ptr<Piece>> pieces_ = {};  ///< in order; the first `begun_` have a thread
  std::size_t begun_ = 0;
  bool ending_ = false;
  JoinedThreads threads_ = {};
};

}  // namespace asperity::cli
