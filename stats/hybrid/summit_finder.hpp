/// Finds the summits of a field row by row: points and plateaus that are higher than all around them.
///
/// A plateau is a set of points of equal height that are joined by sides or corners. It is one summit if all
/// other neighbours of its points are lower, as heights in steps make of the top of a hill. A plateau that
/// meets a missing point, or the edge of a field that is not periodic, is left out, as single points are; so
/// is one that goes around a periodic field, a ridge.
///
/// With c_i the curvature (1) of stats/hybrid/summits.hpp at its n points, and L the number of sides to lower
/// points, a plateau has the curvature
///     κ = 4 Σ c_i / L / (1 + 2 (n-1)/π),                                                              (1)
/// that of a single point at n = 1. Of a large plateau it is that of the paraboloid whose contour at half the
/// mean drop across these sides encloses the area of the plateau, half a step being what rounding leaves of a
/// summit's height on the average.
///
/// Accuracy  of Gaussian fields in steps s: κ, and the number of summits, over those without steps, by the
///           length l of the correlation exp(-r²/l²), in points:
///                            l = 4           8            16
///               s = 0.01 Sq   .99, .98     .96, .97     .97, .96
///                   0.05      .98, .93     .99, .91    1.36, .91
///                   0.1       .99, .89    1.12, .86    1.73, .86
///                   0.3      1.11, .76    1.65, .73    2.38, .75
///           where means of c_i have up to 7 times the curvature. (1) holds while s is below κ ΔxΔy; small
///           summits, and those beside a higher one of the same step, are lost whatever is done. Those that
///           are left are higher, by 0.02, 0.04, 0.07 and 0.15 of their mean height.
/// Cost      one pass, in the time of comparing points with their neighbours; union-find on those without a
///           higher one. A few rows of memory.
#pragma once

#include <vector>

#include "stats/hybrid/neighbours.hpp"

namespace asperity {

struct FoundSummit {
  Index column;       ///< of a point
  double height = 0;  ///< as in the field
  double curvature = 0;
  double points = 1;
};
using FoundSummits = std::vector<FoundSummit>;

class SummitFinder {
 public:
  /// Heights are equal where they round to the same multiple of `rounding`; 0: where they are.
  SummitFinder(double rounding = 0) : rounding_(rounding) {}
  /// The summits of the next strip, for each row of NeighbourRows(strip, 2) those of its points, from column
  /// 0 on, and the plateaus that end before it. The last row has all that are left.
  std::vector<FoundSummits> add(const Strip& strip);

 private:
  static constexpr Index none = -1;
  using Labels = std::vector<Index>;  ///< nodes of the points of a row, or none

  /// Plateaus that meet are one: a tree of nodes.
  struct Node {
    Index parent;        ///< its own number at the root
    Index x = 0, y = 0;  ///< periods from the parent's points to its own
    Index row = 0, column = 0;
    double height = 0, points = 0, curvature = 0;
    Index sides = 0;   ///< to lower points
    Index equals = 0;  ///< neighbours of the same height that were not met yet
    bool waits = false, ridge = false, done = false;
  };
  struct Place {
    Index root, x, y;
  };

  Place find(Index node) const;
  void unite(Index a, Index b, Index x, Index y);
  void meet(Index node, const Labels& above, Index column, Index x);
  void add_plateaus(const std::vector<Node>& points);
  void end_row(FoundSummits& out, bool last);
  void close(const Labels& labels, FoundSummits& out, bool last);
  void forget_closed();

  double rounding_;
  std::vector<Node> nodes_ = {};
  Labels above_ = {}, here_ = {}, first_ = {};
  Index row_ = 0, columns_ = 0;
  bool around_ = false;
};

}  // namespace asperity
