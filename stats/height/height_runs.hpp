/// The order of the heights of a field that comes in strips, in memory that does not grow with the field.
///
/// A run is n heights that follow one another in the order of all of them, known by the lowest and the highest; those
/// between are taken to be spread evenly. Runs are made in one pass, by cells of equal width in
///     t = x/(1 + |x|),   x = (z - z̄)/Sa,   -1 < t < 1,                                                (1)
/// fine where heights are dense, coarse where they are few, without end on either side; Sa, unlike Sq, hardly grows
/// with a spike. Each cell keeps the number of its heights, their lowest and their highest.
///
/// Symbols   z  heights [m]      z̄, Sa, Sq  the field's mean, arithmetic mean and rms height [m]
/// Accuracy  The ends of a run are heights of the field, and their ranks are exact; so is a run of one or two. The
///           height of any other rank is within w of what is taken for it, the width of its cell,
///               w = (2/cells) (1 + |x|)² Sa,                                                            (2)
///           of a Gaussian field 1.5e-6 Sq at the mean and 2e-5 Sq at 2 Sq. Of n heights that chance has spread it errs by w/√(4n).
/// Cost      one pass, a division or two a point; 24 bytes a cell, 25 MB.
#pragma once

#include <vector>

#include "core/field.hpp"
#include "stats/height/moments.hpp"

namespace asperity {

struct HeightRun {
  double count = 0;
  double lowest = 0, highest = 0;  ///< unit of the field
};

class HeightCells {
 public:
  static constexpr Index default_cells = Index{1} << 20;

  /// `moments` are those of the whole field.
  explicit HeightCells(const Moments& moments, Index cells = default_cells);

  void add(const Field& strip);
  /// In ascending order, none of them empty.
  std::vector<HeightRun> runs() const;

 private:
  std::size_t cell(double height) const;

  double mean_, sa_;
  std::vector<HeightRun> cells_;
};

}  // namespace asperity
