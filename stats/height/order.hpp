/// The order of the heights of a field that comes in strips, in memory that does not grow with the field.
///
/// Bins    hold consecutive heights by number, lowest and highest; those between are assumed to be spread
///         evenly. They are filled in one pass and have equal widths in
///             t = x/(1 + |x|),   x = (z - z̄)/Sa,   -1 < t < 1,                                        (1)
///         fine where heights are dense, coarse where they are few; a spike hardly changes Sa, unlike Sq.
/// Ranks   Four passes find the k-th smallest height: each counts the next 16 bits of the heights' 64-bit
///         keys (which have the order of the heights) among those with the bits found so far.
///
/// Symbols   z  heights [m]      z̄, Sa, Sq  the field's mean, arithmetic mean and rms height [m]
/// Accuracy  The ends of a bin are exact heights and ranks. Another rank's height is within its bin's width
///               w = (2/bins) (1 + |x|)² Sa,                                                             (2)
///           for a Gaussian field 1.5e-6 Sq at the mean and 2e-5 Sq at 2 Sq; with n random heights in a bin
///           its error is w/√(4n). RankSelection is exact. Missing heights are left out.
/// Cost      bins: one pass, a division or two per point, 25 MB; ranks: four passes and 512 kB per rank.
#pragma once

#include <cstdint>
#include <vector>

#include "core/field.hpp"
#include "stats/sample/moments.hpp"

namespace asperity {

struct HeightBin {
  double count = 0;
  double lowest = 0, highest = 0;  ///< unit of the field
};

class HeightBins {
 public:
  static constexpr Index default_count = Index{1} << 20;

  /// `moments` are those of the whole field.
  explicit HeightBins(const Moments& moments, Index count = default_count);

  void add(const Field& strip);
  /// Without empty ones.
  std::vector<HeightBin> ascending() const;

 private:
  std::size_t bin_of(double height) const;

  double mean_, sa_;
  std::vector<HeightBin> bins_;
};

/// The heights of some ranks.
class RankSelection {
 public:
  static constexpr int passes = 4;

  /// Ranks from 0, the lowest height, to N - 1.
  explicit RankSelection(const std::vector<std::uint64_t>& ranks);

  /// Call add() for all strips, then end_pass(); repeat `passes` times.
  void add(const Field& z);
  void end_pass();
  /// The height of the i-th rank, after the last pass.
  double height(std::size_t i) const;

 private:
  struct Target {
    std::uint64_t rank;     ///< among the keys with the same known bits
    std::uint64_t key = 0;  ///< the bits known so far
    std::vector<std::uint64_t> counts = {};
  };
  int shift_ = 48;
  std::vector<Target> targets_;
};

}  // namespace asperity
