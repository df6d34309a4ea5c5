/// The order of the heights of a field that comes in strips, in memory that does not grow with the field.
///
/// Bins    of heights that follow one another, known by the lowest and the highest, those between taken to be
///         spread evenly; filled in one pass, of equal widths in
///             t = x/(1 + |x|),   x = (z - z̄)/Sa,   -1 < t < 1,                                        (1)
///         fine where heights are dense, coarse where they are few; Sa, unlike Sq, hardly grows with a spike.
/// Ranks   Passes find the k-th smallest height: each counts, among the 64-bit keys ordered as the heights
///         are, the next 16 bits of those that begin as the rank's key does.
///
/// Symbols   z  heights [m]      z̄, Sa, Sq  the field's mean, arithmetic mean and rms height [m]
/// Accuracy  The ends of a bin are exact heights and ranks. Another rank's height is within its bin's width
///               w = (2/bins) (1 + |x|)² Sa,                                                             (2)
///           of a Gaussian field 1.5e-6 Sq at the mean and 2e-5 Sq at 2 Sq; of n heights spread by chance it
///           errs by w/√(4n). RankSelection is exact. Missing heights are left out.
/// Cost      of bins one pass, a division or two a point, and 25 MB; of ranks four passes and 512 kB a rank.
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
  /// None of them empty.
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
