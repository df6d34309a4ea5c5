/// The steps of an instrument that heights stand on, and bins that hold whole steps.
///
/// Heights z = z₀ + k s with whole k come from converters of few bits and from files of few digits. In bins
/// of another width than a multiple of s some hold one step more than others, or none: a comb. Of bins
///     edges z₀ - s/2 + j m s,     m = max(1, ⌊w/s⌋),                                              (1)
/// each holds m steps, and no height lies near an edge.
///
/// Symbols   s  step      w  width wanted, of Scott's rule (stats/height/distribution.hpp)
/// Scope     Heights closer than 1e-6 of their range are one value. Steps are found if there are at most 1e5
///           of them in the range, if half of the points share their value, and if all differences between
///           neighbouring values are multiples of s to a tenth of s.
/// Accuracy  s to a tenth of itself over the steps in the range.
/// Cost      that of sorting the heights.
#pragma once

#include <vector>

#include "stats/height/distribution.hpp"

namespace asperity {

struct HeightSteps {
  Index values = 0;  ///< different ones
  double lowest = 0;
  double step = 0;  ///< 0 where they stand on none
  Index steps = 0;  ///< in the range
};
/// Equal heights.
struct HeightRun {
  double count = 0, height = 0;
};
/// Ascending, without missing points.
std::vector<HeightRun> runs_of_equal(const Field& z);
HeightSteps height_steps(const std::vector<HeightRun>& runs);
inline HeightSteps height_steps(const Field& z) { return height_steps(runs_of_equal(z)); }

/// The step of heights that come in parts, from neighbours: their least difference, where one pair in a
/// hundred or more is equal; else 0. Heights of many bits have none, and a tilt that was taken off hides it.
double neighbour_step(const Field& z);

struct Bins {
  int number = 1;
  HeightRange range;
};
/// (1), about as wide as those given.
Bins bins_on_steps(const HeightSteps& steps, const Bins& wanted);

}  // namespace asperity
