/// The layout of Asperity's datasets: the grid, fields on it, volumes below it.
///
/// The grid is given by the coordinates x and y with the attributes length (the size of the domain),
/// periodic, unit and units, as in contact.engineering; depth is the coordinate z, positive downwards. A
/// field is name(x, y), a volume name(z, x, y). Datasets are written in SI, and other units are converted on
/// reading (dataset/units.hpp).
///
/// A point is missing where the variable mask(x, y) is not zero, or where a variable has its mark
/// (dataset/conventions.hpp) or NaN. Missing points are refused, unless the caller can omit them; readers
/// never fill them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/extent.hpp"
#include "core/field.hpp"
#include "dataset/dataset.hpp"

namespace asperity {

/// Writes x and y. Replaces a former grid and, if it had other points, removes the variables on it.
void set_grid(Dataset& dataset, const Grid& grid);

/// The grid of x and y, from any program. If the attribute length of an axis agrees with its points, the
/// spacing follows from the length, unless only the length is in single precision. If they disagree, as after
/// cropping by a program that ignores the attribute, the spacing follows from the points, and the axis is not
/// periodic. Throws DataError when x or y is missing, has no size, or is not evenly spaced.
Grid grid_of(const Dataset& dataset);
/// Sets length and `periodic` of x and y to those of grid_of; returns a line for each changed length.
std::vector<std::string> settle_lengths(Dataset& dataset);

/// Treatment of missing points: DataError, or NaN.
enum class Missing { refused, not_a_number };

/// name(x, y) in its si_unit_of. Throws DataError when there is no such variable, it is not on (x, y), has a
/// value that is not finite, or has missing points that are refused.
Field field_of(const Dataset& dataset, std::string_view name, Missing missing = Missing::refused);
/// The same in a given unit, for any name: "m", "Pa", "1".
Field field_of(const Dataset& dataset, std::string_view name, std::string_view unit,
               Missing missing = Missing::refused);
/// Some rows of it, the others unread.
Field field_of(const Dataset& dataset, std::string_view name, std::string_view unit, Extent rows,
               Missing missing = Missing::refused);

struct Meaning {
  std::string_view units;      ///< SI, as UDUNITS writes it: "m", "Pa", "1"
  std::string_view long_name;  ///< in words
};

// Only finite values are written: each function throws DataError(name, …) for an infinity, and for a NaN
// unless `missing` allows missing values.

/// Writes name(x, y) with units, long_name and actual_range; the grid must be set.
void set_field(Dataset& dataset, std::string_view name, const Field& values, Meaning meaning);
/// The smallest and the largest value; NaN if a value is NaN.
struct Range {
  double low, high;
};
/// Adds a variable of doubles on any dimensions as the last one; its values follow the bytes of
/// encode_netcdf.
void defer_values(Dataset& dataset, std::string_view name, std::vector<std::string> dimensions, Range range,
                  Meaning meaning);
/// Writes a number with a unit, without dimensions, such as the position of a section.
void set_scalar(Dataset& dataset, std::string_view name, double value, Meaning meaning);
/// Writes a field of small integers, such as the contact state, with the meaning of each value.
void set_flags(Dataset& dataset, std::string_view name, const std::vector<std::int8_t>& values,
               std::string_view long_name, std::string_view flag_meanings);

/// The depths [m] of a dataset; throws DataError when there are none, or one lies above the surface.
std::vector<double> depths_of(const Dataset& dataset);
/// Writes z; replaces a former one like set_grid.
void set_depths(Dataset& dataset, const std::vector<double>& depths);
/// Writes name(z, x, y); `values` is [depth][x][y], nz·nx·ny of them.
void set_volume(Dataset& dataset, std::string_view name, std::vector<double> values, Meaning meaning);

/// The points first·step, (first + 1)·step, … of the rows or columns of a table, in `unit` ("m", or "1" for
/// samples). `first` is an integer, so that lag 0 is exactly 0.
struct Axis {
  std::string_view name;
  Index first = 0;
  double step = 1;
  std::string_view unit = "1";
  std::string_view meaning = "index";
};
/// Writes the coordinates row(row) and column(column) of a table.
void set_axes(Dataset& dataset, Shape table, Axis row, Axis column);
/// Writes name(row, column) and the coordinates.
void set_table(Dataset& dataset, std::string_view name, const Field& values, Axis row, Axis column,
               Meaning meaning, Missing missing = Missing::refused);
/// A variable on any two dimensions as a field, unconverted ("") or in a given unit; throws DataError when
/// there is no such variable, or it has a value that is not finite, unless missing points are allowed.
Field table_of(const Dataset& dataset, std::string_view name, std::string_view unit = "",
               Missing missing = Missing::refused);
/// Puts `line` in front of the global attribute `history`.
void add_history(Dataset& dataset, std::string_view line);

}  // namespace asperity
