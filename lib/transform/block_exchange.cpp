#include "transform/block_exchange.hpp"

namespace asperity {

template <class Number>
BlockExchange<Number>::BlockExchange(const Slabs& rows, Index count, int threads)
    : rows_(rows), count_(count) {
  constexpr Index points_at_a_time = 1 << 16;  // of a column of blocks: some megabytes come and go
  const int ranks = rows.ranks().count();
  const Index each = (count + ranks - 1) / ranks;
  most_ = std::max<Index>({1, threads, points_at_a_time / std::max<Index>(1, rows.rows())});
  steps_ = (each + most_ - 1) / most_;
  here_.resize(size(std::min(most_, each) * rows.rows() * width));
}

template <class Number>
void BlockExchange<Number>::fetch(Index step, std::span<const Number> own) {
  Ranks::Pieces to;
  Ranks::Room from;
  for (int r = 0; r < rows_.ranks().count(); ++r) {
    to.push_back(std::as_bytes(piece(step, r, own)));
    from.push_back(std::as_writable_bytes(all_of(step, r)));
  }
  rows_.ranks().exchange(to, from);
}

template <class Number>
void BlockExchange<Number>::give_back(Index step, std::span<Number> own) {
  Ranks::Pieces to;
  Ranks::Room from;
  for (int r = 0; r < rows_.ranks().count(); ++r) {
    to.push_back(std::as_bytes(all_of(step, r)));
    from.push_back(std::as_writable_bytes(piece(step, r, own)));
  }
  rows_.ranks().exchange(to, from);
}

template class BlockExchange<double>;
template class BlockExchange<std::complex<double>>;
template class BlockExchange<std::complex<float>>;

}  // namespace asperity
