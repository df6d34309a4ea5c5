/// Fields of a contact that only a part of the cells has: the pressure of those in contact, the gap of the
/// open ones.
#pragma once

#include <optional>
#include <string>

#include "dataset/dataset.hpp"

namespace asperity::cli {

struct CountedCells {
  std::string variable, units;
  Grid grid;
  Field values;         ///< NaN on the other cells
  double cells = 0;     ///< that are not missing
  double counted = 0;   ///< of them
  std::string which;    ///< "in contact" or "open"
  std::string without;  ///< what the others are: "open, without pressure"

  /// "pressure of the 3152 cells that are in contact; the other 95.2 % of 65536 cells …".
  std::string told() const;
  /// The same where all cells are measured, and what counts these alone.
  std::string told_of_all() const;
};

/// Of the variables pressure, and gap where a contact or a pressure tells which cells are open; of others
/// nothing. Throws DataError where no cell is counted.
std::optional<CountedCells> counted_cells(const Dataset& data, const std::string& variable);

}  // namespace asperity::cli
