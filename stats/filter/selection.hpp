/// Order statistics of a field that comes in strips: the k-th smallest of N heights without holding them.
///
/// Heights are compared as 64-bit keys in their order. A pass over the field counts, for each rank that is asked for,
/// the next 16 bits of those keys that begin as the rank's key is known to; after four passes the key is known.
///
/// Accuracy  exact: the heights themselves. Missing ones are left out.
/// Cost      four passes; 512 kB a rank.
#pragma once

#include <cstdint>
#include <vector>

#include "core/field.hpp"

namespace asperity {

class RankSelection {
 public:
  static constexpr int passes = 4;

  /// Ranks from 0, the lowest height, to N - 1.
  explicit RankSelection(const std::vector<std::uint64_t>& ranks);

  /// The strips of one pass, then end_pass(); `passes` times.
  void add(const Field& z);
  void end_pass();
  /// Of the rank given as the i-th, after the last pass.
  double height(std::size_t i) const;

 private:
  struct Target {
    std::uint64_t rank;     ///< among the keys that begin as this one's
    std::uint64_t key = 0;  ///< as far as it is known
    std::vector<std::uint64_t> counts = {};
  };
  int shift_ = 48;
  std::vector<Target> targets_;
};

}  // namespace asperity
