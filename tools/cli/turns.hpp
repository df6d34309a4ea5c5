/// Several datasets worked on at once, one thread each, that are told of in their order.
///
///     Turns turns(datasets_at_once(tool, shape));
///     for (const std::string& name : names)
///       turns.add([&, name] {
///         const Surface surface = read(name);                    // on a thread of its own
///         const Parameters found = measure(surface);
///         in_turn([&, found] { mean.add(found); });              // after all that those before it left so
///       });
///     turns.finish();
///
/// Whatever others see of a dataset is left to its turn: messages (Tool::warn and its like do so by
/// themselves), sums over the datasets, and the name of a file that has been written. An error of a dataset
/// comes in its turn too, from add() or finish(), and nothing of those behind it is seen. So a run tells and
/// writes what it does with one dataset after the other, to the last byte.
///
/// Memory    of twice as many datasets as are worked on at once, with what they have left to their turns.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "core/field.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

/// How many datasets of this shape are worked on at once: as many as the run has threads where these are too
/// small for threads to share, and fewer where they need more than --memory; 1 with --verbose, whose lines
/// come as they arise.
int datasets_at_once(const Tool& tool, Shape shape);
/// Whether a dataset of this shape, though there are several, is worth all threads.
bool is_worth_all_threads(Shape shape);

using Action = std::function<void()>;

/// When all datasets before this thread's own have been told of; at once where it has none.
void in_turn(Action action);

class Turns {
 public:
  /// 1: add() does the work itself.
  explicit Turns(int at_once);
  /// Without finish(): work that goes on is awaited, not told of, and no other begins.
  ~Turns();
  Turns(const Turns&) = delete;
  Turns& operator=(const Turns&) = delete;

  /// Work on a dataset. Waits for the first ones where too many are under way.
  void add(Action work);
  /// Until nothing is left.
  void finish();

 private:
  struct Part {
    explicit Part(Action action) : work(std::move(action)) {}

    std::packaged_task<void()> work;
    std::future<void> end = work.get_future();
    std::vector<Action> left = {};  ///< to its turn
  };
  void serve(const std::stop_token& stop);
  void tell_first();

  std::size_t at_once_;
  std::mutex mutex_ = {};
  std::condition_variable_any added_ = {};
  std::deque<std::unique_ptr<Part>> parts_ = {};  ///< in order; the first `begun_` have a thread
  std::size_t begun_ = 0;
  std::vector<std::jthread> threads_ = {};
};

}  // namespace asperity::cli
