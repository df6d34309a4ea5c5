#include "tools/cli/turns.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "core/calibration.hpp"
#include "core/parallel.hpp"

namespace asperity::cli {

namespace {

thread_local std::vector<Action>* left_to_turn = nullptr;

}  // namespace

int datasets_at_once(const Tool& tool, Shape shape) {
  if (tool.verbose() || is_worth_all_threads(shape)) return 1;
  const double each = calibration::turns::bytes_a_cell * static_cast<double>(shape.cells()),
               room = static_cast<double>(tool.memory()) / std::max(each, 1.0);
  const int most = std::min(tool.thread_count(), calibration::turns::most_at_once);
  return static_cast<int>(std::clamp(room, 1.0, static_cast<double>(most)));
}

bool is_worth_all_threads(Shape shape) { return shape.cells() > calibration::turns::most_cells; }

void in_turn(Action action) {
  if (left_to_turn == nullptr) return action();
  left_to_turn->push_back(std::move(action));
}

// Where the system gives no thread, those that there are do the work, or add() does.
Turns::Turns(int at_once) : at_once_(static_cast<std::size_t>(at_once)) {
  if (at_once == 1) return;
  try {
    while (threads_.size() < at_once_)
      threads_.emplace_back([this](const std::stop_token& stop) { serve(stop); });
  } catch (const std::system_error&) {
    at_once_ = std::max<std::size_t>(threads_.size(), 1);
  }
}

Turns::~Turns() {
  for (std::jthread& thread : threads_) thread.request_stop();
}

void Turns::serve(const std::stop_token& stop) {
  work_alone();
  for (;;) {
    std::unique_lock lock(mutex_);
    const bool any = added_.wait(lock, stop, [this] { return begun_ < parts_.size(); });
    if (!any || stop.stop_requested()) return;
    Part& part = *parts_[begun_++];
    lock.unlock();
    left_to_turn = &part.left;
    part.work();
  }
}

void Turns::add(Action work) {
  if (threads_.empty()) return work();
  while (parts_.size() >= 2 * at_once_) tell_first();
  {
    const std::scoped_lock lock(mutex_);
    auto all = [work = std::move(work)]() mutable { std::exchange(work, {})(); };  // and what it holds
    parts_.push_back(std::make_unique<Part>(std::move(all)));
  }
  added_.notify_one();
}

void Turns::finish() {
  while (!parts_.empty()) tell_first();
}

void Turns::tell_first() {
  parts_.front()->end.wait();
  std::unique_lock lock(mutex_);
  const std::unique_ptr<Part> first = std::move(parts_.front());
  parts_.pop_front();
  --begun_;
  lock.unlock();
  for (Action& action : first->left) std::exchange(action, {})();
  first->end.get();
}

}  // namespace asperity::cli
