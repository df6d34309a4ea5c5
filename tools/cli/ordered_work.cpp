#include "tools/cli/ordered_work.hpp"

#include <algorithm>
#include <exception>
#include <utility>

namespace asperity::cli {

namespace {

// Several datasets at once, one thread each, against one after the other on all threads: asperity-contact of
// 4 to 16 rough spheres on two threads of a busy machine took 0.5 of the time at 256², 0.6 at 512², 0.8 at
// 1024², and 0.96 in twice the memory at 2048²; the lengths of asperity-acf 0.7 at 512² and 0.9 at 1024².
constexpr Index most_cells = 1024 * 1024;
constexpr double bytes_a_cell = 512;  // a contact takes 110, profiles' tables more
constexpr int most_at_once = 64;      // files without a name; cli/temporary.cpp has room for 256

thread_local std::vector<Action>* left_by_piece = nullptr;

}  // namespace

int datasets_at_once(const Tool& tool, Shape shape) {
  if (tool.verbose() || is_worth_all_threads(shape)) return 1;
  const double each = bytes_a_cell * static_cast<double>(shape.cells()),
               room = static_cast<double>(tool.memory()) / std::max(each, 1.0);
  const int most = std::min(tool.thread_count(), most_at_once);
  return static_cast<int>(std::clamp(room, 1.0, static_cast<double>(most)));
}

bool is_worth_all_threads(Shape shape) { return shape.cells() > most_cells; }

void in_order(Action action) {
  if (left_by_piece == nullptr) return action();
  left_by_piece->push_back(std::move(action));
}

// Where the system gives no thread, or no memory for one, those that there are do the work, or add() does.
OrderedWork::OrderedWork(int at_once) : at_once_(static_cast<std::size_t>(at_once)) {
  if (at_once == 1) return;
  try {
    while (threads_.size() < at_once_) threads_.start([this] { serve(); });
  } catch (const std::exception&) {
    at_once_ = std::max<std::size_t>(threads_.size(), 1);
  }
}

OrderedWork::~OrderedWork() {
  {
    const std::scoped_lock lock(mutex_);
    ending_ = true;
  }
  added_.notify_all();
}

void OrderedWork::serve() {
  work_alone();
  for (;;) {
    std::unique_lock lock(mutex_);
    added_.wait(lock, [this] { return ending_ || begun_ < pieces_.size(); });
    if (ending_) return;
    Piece& piece = *pieces_[begun_++];
    lock.unlock();
    left_by_piece = &piece.left;
    piece.work();
  }
}

void OrderedWork::add(std::function<Action()> work) {
  if (threads_.size() == 0) return work()();
  while (pieces_.size() >= 2 * at_once_) take_first();
  {
    const std::scoped_lock lock(mutex_);
    auto all = [work = std::move(work)]() mutable {
      in_order(std::exchange(work, {})());
    };  // and what it holds
    pieces_.push_back(std::make_unique<Piece>(std::move(all)));
  }
  added_.notify_one();
}

void OrderedWork::finish() {
  while (!pieces_.empty()) take_first();
}

void OrderedWork::take_first() {
  pieces_.front()->end.wait();
  std::unique_lock lock(mutex_);
  const std::unique_ptr<Piece> first = std::move(pieces_.front());
  pieces_.pop_front();
  --begun_;
  lock.unlock();
  for (Action& action : first->left) std::exchange(action, {})();
  first->end.get();
}

}  // namespace asperity::cli
