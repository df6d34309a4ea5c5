/// The largest stress near a place: what a scan of layers found, refined at points of the field.
///
/// From the depth of one longer side of a cell on, the field of stress/points.hpp itself is climbed in x, y
/// and z, by Newton's method on differences over 0.15 and then 0.03 of the depth, damped until the value
/// rises; where a criterion has a crease, the steps are then halved along each axis. Above that depth the
/// field shows the steps of the pressure between the cells: there only the columns through the cells' centres
/// count: the largest value along one is found by Brent's method, then along a higher one beside it.
///
/// Accuracy  the value 1e-7 of the maximum that is climbed (tests/stress/shallow.cpp).
/// Cost      40 to 60 points; above one cell some 36 a column.
#pragma once

#include <functional>
#include <memory>

#include "stress/cell_tree.hpp"
#include "stress/maximum.hpp"
#include "stress/points.hpp"

namespace asperity {

/// Where a stress is how large.
struct StressPlace {
  double value = 0, x = 0, y = 0, z = 0;
};

class PeakClimber {
 public:
  /// Above `below` [m] nothing is looked at. The body is kept by reference.
  PeakClimber(const LoadedBody& body, Criterion of, double below, int threads);

  /// The maximum about a place; or a lower value where that maximum will not exceed `goal`.
  StressPlace climb(const StressPlace& from, double goal) const;

  double value(double x, double y, double z) const;

 private:
  using Vector = std::array<double, 3>;
  struct Model;
  StressPlace field_peak(StressPlace from, double goal) const;
  StressPlace creep(StressPlace from) const;
  StressPlace centres_peak(const StressPlace& from) const;
  StressPlace column_peak(const StressPlace& from) const;
  Model model(const StressPlace& at, double step) const;
  StressPlace moved(const StressPlace& from, const Vector& by) const;
  std::array<bool, 3> held(const StressPlace& at, const Vector& slope) const;

  const LoadedBody& body_;
  Criterion of_;
  double below_, field_, shallowest_;
  std::unique_ptr<CellTree> tree_;        ///< of a free body
  std::unique_ptr<StressPoints> points_;  ///< of a periodic one
};

}  // namespace asperity
