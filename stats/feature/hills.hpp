/// Hills of a surface by watershed, and their pruning; dales are the hills of -z.
///
/// Points are taken by height, the highest first, those of equal height in the order of storage. A point none
/// of whose eight neighbours is taken is a peak; any other joins the hill of the highest of these. Where
/// taken points that were apart meet, at a saddle, the lower of their peaks ends (of equal ones the later),
/// and its local height is that above the saddle. The last peak of connected points has that above the lowest
/// of them. A peak of local height 0 is part of a plateau: it belongs to the hill across its saddle.
///
/// Wolf pruning merges the hill of the least local height with that across its saddle, and again, until none
/// is below a bound. That hill has a higher peak, and the local heights of the others stay: what is left are
/// the hills whose local height was not below the bound.
///
/// Neighbours go across the ends of periodic axes. Missing points belong to no hill.
///
/// Cost      n log n for n points: 0.15 to 0.25 s for 1024², 24 bytes a point.
///
/// ISO 16610-85:2013, ISO 25178-2:2021 (watershed segmentation, Wolf pruning).
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/field.hpp"

namespace asperity {

using HillNumber = std::int32_t;
inline constexpr HillNumber no_hill = -1;

struct Hill {
  Index peak = 0;  ///< i ny + j, its first point
  double height = 0, saddle = 0;
  HillNumber across = no_hill;  ///< the hill on the other side of the saddle

  double local_height() const { return height - saddle; }
};

struct Hills {
  std::vector<Hill> all = {};
  Eigen::Array<HillNumber, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> of_point = {};
};

/// All hills, by the order in which their peaks are taken. None of a constant field.
Hills hills_of(const Field& z, const Periodic& periodic);
/// Those whose local height is not below `least`.
Hills pruned(Hills hills, double least);

}  // namespace asperity
