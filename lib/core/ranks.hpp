/// Several processes that solve one problem, each on some of its rows.
///
/// A rank is one of them. What ranks tell each other goes through one function, an exchange of bytes in which
/// each has a piece for each; rows of others, sums and transposes are made of it. Alone, a process is the
/// only rank, and nothing moves.
///
/// A field of n rows is dealt in runs of 64, the strips of contact/relaxation.hpp: a rank holds its own rows
/// as a Field. Results do not depend on the number of ranks, to the last bit.
///
/// Functions that exchange are collective: all ranks call them, in the same order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "core/extent.hpp"
#include "core/field.hpp"

namespace asperity {

class Ranks {
 public:
  using Pieces = std::vector<std::span<const std::byte>>;
  using Room = std::vector<std::span<std::byte>>;

  virtual ~Ranks() = default;
  virtual int rank() const { return 0; }
  virtual int count() const { return 1; }
  /// Sends to[r] to rank r, and puts what rank r has for this one into from[r], of the same length.
  virtual void exchange(const Pieces& to, const Room& from) const;
  /// The end of this rank's run, with an exit code. Where others do not come to theirs, because they wait for
  /// this one, it says its last words and ends them all.
  virtual void end(int code, const std::string& last_words) const;
};

/// The only rank.
const Ranks& alone();

/// The rows of a field, dealt to ranks.
class Slabs {
 public:
  static constexpr Index run = 64;

  /// In runs of 64, unless what is shared wants other ones.
  explicit Slabs(Index rows, const Ranks& ranks = alone(), Index run_of = run)
      : rows_(rows), run_(run_of), ranks_(&ranks) {}
  /// Of rows that stand for `factor` each, 64 a multiple of it: a rank holds those of its own.
  Slabs coarsened(Index factor) const { return Slabs((rows_ + factor - 1) / factor, *ranks_, run_ / factor); }

  const Ranks& ranks() const { return *ranks_; }
  bool shared() const { return ranks_->count() > 1; }
  Index rows() const { return rows_; }
  Extent of(int rank) const {
    const Index first = begin(rank);
    return {first, begin(rank + 1) - first};
  }
  Extent own() const { return of(ranks_->rank()); }
  /// The most rows that a rank has.
  Index longest() const {
    Index most = 0;
    for (int r = 0; r < ranks_->count(); ++r) most = std::max(most, of(r).count);
    return most;
  }
  bool operator==(const Slabs&) const = default;

 private:
  Index begin(int rank) const {
    const Index runs = (rows_ + run_ - 1) / run_;
    return std::min(rows_, runs * rank / ranks_->count() * run_);
  }

  Index rows_, run_;
  const Ranks* ranks_;
};

/// Of all ranks one after the other. T is plain data.
template <class T>
std::vector<T> gathered(const Ranks& ranks, const std::vector<T>& own);

/// The largest that a rank has; NaN where one has it.
double largest(const Ranks& ranks, double own);

/// Work that may fail on some ranks: where it does, all throw the error of the first of these, a
/// ParameterError, a DataError or a std::runtime_error.
void agree(const Ranks& ranks, const std::function<void()>& work);

/// Ranks share grids above 512 × 512 cells of 64 rows each or more; on others each does all.
Slabs shared_rows(Shape shape, const Ranks& ranks);

using ConstRows = Eigen::Ref<const Field>;

/// Rows of a field by their number, whoever holds them; each rank wants its own.
Field rows_of(const ConstRows& own, const Slabs& slabs, const std::vector<Index>& wanted);
Field rows_of(const ConstRows& own, const Slabs& slabs, Extent wanted);

/// The columns of the same field that fall to this rank, dealt as rows, each as a row.
Field transposed(const ConstRows& own, const Slabs& slabs);

// ---- implementation ----

/// What each rank has for each, of a number that both know: out[r] of from(r) numbers.
template <class T, class Count>
std::vector<std::vector<T>> exchanged(const Ranks& ranks, const std::vector<std::vector<T>>& to, Count from) {
  std::vector<std::vector<T>> out(to.size());
  Ranks::Pieces pieces;
  Ranks::Room room;
  for (std::size_t r = 0; r < to.size(); ++r) {
    out[r].resize(size(from(static_cast<int>(r))));
    pieces.push_back(std::as_bytes(std::span(to[r])));
    room.push_back(std::as_writable_bytes(std::span(out[r])));
  }
  ranks.exchange(pieces, room);
  return out;
}

template <class T>
std::vector<T> gathered(const Ranks& ranks, const std::vector<T>& own) {
  if (ranks.count() == 1) return own;
  const auto all = static_cast<std::size_t>(ranks.count());
  auto to_all = [&](const auto& values) { return Ranks::Pieces(all, std::as_bytes(std::span(values))); };
  const std::vector<Index> length{std::ssize(own)};
  std::vector<Index> lengths(all);
  Ranks::Room room;
  for (Index& each : lengths) room.push_back(std::as_writable_bytes(std::span(&each, 1)));
  ranks.exchange(to_all(length), room);
  std::vector<T> out(size(std::reduce(lengths.begin(), lengths.end())));
  auto next = out.begin();
  for (std::size_t r = 0; r < all; ++r) {
    room[r] = std::as_writable_bytes(std::span(next, size(lengths[r])));
    next += lengths[r];
  }
  ranks.exchange(to_all(own), room);
  return out;
}

}  // namespace asperity
