/// The largest stress near a place that the scan of layers found, refined at points of the field.
///
/// About a place the field is that of a window of 24 × 24 cells, as wide as a third of the depth, with a
/// quadratic in x, y and z for what other cells add: it meets the field of stress/points.hpp at seven
/// points, 0.03 of the depth apart. Its maximum, found by steps to the highest of 26 neighbours, is the
/// next place, until the field there has the predicted value. Above the depth of one longer side of a cell
/// the field shows the steps of the pressure between the cells: there only the columns through the cells'
/// centres count, and places move from one to the next.
///
/// Accuracy  the value 1e-6 of the maximum to which it leads (tests/stress/shallow.cpp).
/// Cost      8 to 25 points of the field, some 600 of a window, 15 to 40 µs each.
#pragma once

#include "stress/maximum.hpp"
#include "stress/points.hpp"

namespace asperity {

/// A stress and its place [m].
struct StressPlace {
  double value = 0, x = 0, y = 0, z = 0;
};

class PeakFinder {
 public:
  /// The search ends above the depth `below` [m]. The body is kept by reference.
  PeakFinder(const LoadedBody& body, Criterion of, double below, int threads);

  /// The maximum about a place; or a lower value where that maximum will not exceed `goal`.
  StressPlace find(const StressPlace& from, double goal) const;
  /// From the one point of the field there: the field's value, and what the maximum about it may reach.
  struct Estimate {
    StressPlace at;
    double reaches = 0;
  };
  Estimate estimate(const StressPlace& from) const;

 private:
  class Model;
  bool varies_x() const { return !(body_.grid.periodic.x && body_.grid.shape.nx == 1); }
  bool varies_y() const { return !(body_.grid.periodic.y && body_.grid.shape.ny == 1); }
  StressPlace within(StressPlace place, bool centred) const;
  StressPlace refined(const StressPlace& from, bool centred, double goal) const;
  StressPlace largest_of(const Model& model, const StressPlace& from, double range, double last) const;
  StressPlace largest_beside(const Model& model, StressPlace top) const;
  double at_centre(double place, double length, double spacing, Index n, bool periodic) const;

  const LoadedBody& body_;
  Criterion of_;
  double below_, steps_show_;  ///< [m]
  CellSum field_;
};

}  // namespace asperity
