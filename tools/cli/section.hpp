/// Words that asperity-stress and asperity-plot share: a vertical section, and a bound of stresses.
#pragma once

#include <functional>
#include <string>

#include "core/field.hpp"
#include "dataset/dataset.hpp"

namespace asperity::cli {

/// A row of cells: along x at a y, or along y at an x.
struct CellRow {
  bool along_x = true;
  Index index = 0;  ///< in the other direction
};

/// Whether "y=max" or "x=max" is requested.
bool through_maximum(const std::string& section);

/// The row of cells nearest to "y=0", "x=0.2mm", "y=3px" or "y=max" (of two as near, the second). `maximum`
/// gives the place of the largest von Mises stress: y of a row along x, else x. Throws
/// ParameterError("section", …).
CellRow section_row(const Grid& grid, const std::string& section,
                    const std::function<double(bool along_x)>& maximum);

/// A stress: "100MPa", "0.1p0" of the Hertz pressure, "0.1pmax" of the largest contact pressure of a dataset.
class StressBound {
 public:
  StressBound() = default;
  /// Throws ParameterError("above", …) unless it is one of them, and positive.
  explicit StressBound(const std::string& text);

  bool given() const { return value_ > 0; }
  /// In Pa. Throws DataError where the dataset lacks what it is a share of.
  double in(const Dataset& data, const std::function<double()>& largest_pressure) const;
  /// "0.1 p₀", "0.1 pmax", "100 MPa"
  std::string label() const;

 private:
  enum class Of { itself, hertz, largest };
  double value_ = 0;
  Of of_ = Of::itself;
};

}  // namespace asperity::cli
