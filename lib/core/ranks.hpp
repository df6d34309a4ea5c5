/// Several processes that solve one problem, each on some of its rows.
///
/// A rank is one of them. All communication goes through one function, an exchange of bytes in which each
/// rank has a piece for each other; rows of other ranks, sums and transposes use it. Alone, a process is the
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
  /// Ends this rank's run with an exit code. Where the others do not end, because they wait for this one, it
  /// prints its last words and ends them all.
  virtual void end(int code, const std::string& last_words) const;
};

/// The only rank.
const Ranks& alone();

/// The rows of a field, dealt to ranks.
class Slabs {
 public:
  static constexpr Index run = 64;

  /// In runs of 64, unless the shared field needs other ones.
  explicit Slabs(Index rows, const Ranks& ranks = alone(), Index run_of = run)
      : rows_(rows), run_(run_of), ranks_(&ranks) {}
  /// The slabs of a coarser field, each row of which stands for `factor` rows, a divisor of 64.
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

/// The values of all ranks, one rank after the other. T is plain data.
template <class T>
std::vector<T> gathered(const Ranks& ranks, const std::vector<T>& own);

/// The largest value of any rank; NaN if one of them is NaN.
double largest(const Ranks& ranks, double own);

/// Does work that may fail on some ranks: all then throw the error of the first of them, a ParameterError, a
/// DataError or a std::runtime_error.
void agree(const Ranks& ranks, const std::function<void()>& work);

/// Ranks share grids above 512 × 512 cells of 64 rows each or more; on others each does all.
Slabs shared_rows(Shape shape, const Ranks& ranks);

using ConstRows = Eigen::Ref<const Field>;

/// Rows of a field by their number, from whichever rank holds them; each rank asks for its own list.
Field rows_of(const ConstRows& own, const Slabs& slabs, const std::vector<Index>& wanted);
Field rows_of(const ConstRows& own, const Slabs& slabs, Extent wanted);

/// The transposed field, dealt as rows: this rank's columns of the field, each as a row.
Field transposed(const ConstRows& own, const Slabs& slabs);

// ---- implementation ----

/// Exchanges lists whose lengths both sides know: out[r], of from(r) values, is what rank r sends.
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
