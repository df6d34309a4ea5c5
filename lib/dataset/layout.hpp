/// What stands where in Asperity's datasets: the grid, fields on it, volumes below it.
///
/// The grid is the coordinate variables x and y with the attributes length (the size of the domain),
/// periodic, unit and units, as contact.engineering reads them; depth is the coordinate z, positive
/// downwards. A field is name(x, y), a volume name(z, x, y). What is written is SI; what is read is converted
/// (dataset/units.hpp).
///
/// A point is missing where the variable mask(x, y) is not zero, where a variable has its mark
/// (dataset/conventions.hpp), or NaN. No reader invents a value: missing points are refused, unless the
/// caller can leave them out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/field.hpp"
#include "dataset/dataset.hpp"

namespace asperity {

/// Writes x and y; replaces a former grid and, if its points were others, whatever stood on it.
void set_grid(Dataset& dataset, const Grid& grid);

/// The grid that x and y make, whatever program wrote them. Of an axis whose attribute length and points
/// agree, the length tells the spacing, unless it is in single precision and the points are not. Where they
/// disagree, as after cropping by a program that does not know the attribute, the points do, and the grid is
/// not periodic. Throws DataError when x or y is missing, has no size, or is not evenly spaced.
Grid grid_of(const Dataset& dataset);
/// Gives x and y the lengths and the `periodic` that grid_of takes; a line on each length that was another.
std::vector<std::string> settle_lengths(Dataset& dataset);

/// What becomes of missing points: DataError, or NaN.
enum class Missing { refused, not_a_number };

/// name(x, y) in its si_unit_of. Throws DataError when it is missing, does not lie on (x, y), holds a number
/// that is not finite, or some of its points are missing and may not be.
Field field_of(const Dataset& dataset, std::string_view name, Missing missing = Missing::refused);
/// The same in a unit that it must measure, whatever its name: "m", "Pa", "1".
Field field_of(const Dataset& dataset, std::string_view name, std::string_view unit,
               Missing missing = Missing::refused);

struct Meaning {
  std::string_view units;      ///< SI, as UDUNITS writes it: "m", "Pa", "1"
  std::string_view long_name;  ///< in words
};

// What is written is finite: each of these throws DataError(name, …) for an infinity, and for a NaN unless
// `missing` says that it stands for a missing value.

/// Writes name(x, y) with units, long_name and actual_range; the grid must be set.
void set_field(Dataset& dataset, std::string_view name, const Field& values, Meaning meaning);
/// The least and the largest value, NaN where one of the values is.
struct Range {
  double low, high;
};
/// A variable of doubles on any dimensions, as the last one, whose values will follow encode_netcdf's bytes.
void defer_values(Dataset& dataset, std::string_view name, std::vector<std::string> dimensions, Range range,
                  Meaning meaning);
/// A number with a unit that belongs to no axis, such as the place of a section.
void set_scalar(Dataset& dataset, std::string_view name, double value, Meaning meaning);
/// A field of small integers, such as the contact state, with the meaning of each value.
void set_flags(Dataset& dataset, std::string_view name, const std::vector<std::int8_t>& values,
               std::string_view long_name, std::string_view flag_meanings);

/// The depths [m] of a dataset with z; throws DataError when there are none, or one lies above the surface.
std::vector<double> depths_of(const Dataset& dataset);
/// Likewise of a former z.
void set_depths(Dataset& dataset, const std::vector<double>& depths);
/// Writes name(z, x, y); `values` is [depth][x][y], nz·nx·ny of them.
void set_volume(Dataset& dataset, std::string_view name, std::vector<double> values, Meaning meaning);

/// The points first·step, (first + 1)·step, … of a table's row or column, in `unit` ("m", or "1" for
/// samples). Counted from a whole number, so that the lag 0 is 0 and not a rounding error.
struct Axis {
  std::string_view name;
  Index first = 0;
  double step = 1;
  std::string_view unit = "1";
  std::string_view meaning = "index";
};
/// Writes name(row, column) and the coordinates row(row) and column(column).
void set_table(Dataset& dataset, std::string_view name, const Field& values, Axis row, Axis column,
               Meaning meaning, Missing missing = Missing::refused);
/// A variable of any two dimensions as a field, as it stands ("") or in a unit that it must measure; throws
/// DataError when it is missing, or holds a number that is not finite and may not be missing.
Field table_of(const Dataset& dataset, std::string_view name, std::string_view unit = "",
               Missing missing = Missing::refused);
/// Puts `line` in front of the global attribute `history`.
void add_history(Dataset& dataset, std::string_view line);

}  // namespace asperity
