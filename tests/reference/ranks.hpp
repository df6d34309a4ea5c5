/// Ranks that are threads of one process: what several processes do, under a debugger and without a launcher.
#pragma once

#include <algorithm>
#include <barrier>
#include <exception>
#include <vector>

#include "core/parallel.hpp"
#include "core/ranks.hpp"

namespace asperity::test {

class ThreadRanks {
 public:
  explicit ThreadRanks(int count) : pieces_(static_cast<std::size_t>(count)), all_here_(count) {}

  /// work(ranks) on every rank at once; rethrows what the first rank throws. All throw, or none.
  template <class Work>
  void run(Work work) {
    const int count = static_cast<int>(pieces_.size());
    std::vector<std::exception_ptr> failures(pieces_.size());
    {
      JoinedThreads threads;
      for (int r = 0; r < count; ++r)
        threads.start([&, r] {
          try {
            work(One(*this, r));
          } catch (...) {
            failures[static_cast<std::size_t>(r)] = std::current_exception();
          }
        });
    }
    if (failures.front()) std::rethrow_exception(failures.front());
  }

 private:
  class One final : public Ranks {
   public:
    One(ThreadRanks& all, int rank) : all_(all), rank_(rank) {}
    int rank() const override { return rank_; }
    int count() const override { return static_cast<int>(all_.pieces_.size()); }
    void exchange(const Pieces& to, const Room& from) const override {
      all_.pieces_[static_cast<std::size_t>(rank_)] = &to;
      all_.all_here_.arrive_and_wait();
      for (std::size_t r = 0; r < from.size(); ++r) {
        const auto piece = (*all_.pieces_[r])[static_cast<std::size_t>(rank_)];
        if (piece.size() != from[r].size()) std::terminate();
        std::ranges::copy(piece, from[r].begin());
      }
      all_.all_here_.arrive_and_wait();
    }

   private:
    ThreadRanks& all_;
    int rank_;
  };

  std::vector<const Ranks::Pieces*> pieces_;
  std::barrier<> all_here_;
};

}  // namespace asperity::test
