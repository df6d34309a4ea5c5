/// What the columns of a text are: heights, or points of a profile or of a surface.
///
/// They are points if Reading::columns says so, or the labels above them: x and z, or x, y and z, with units,
/// those of x and y of length; columns without such a name are left out where the others are the letters x, y
/// and z. Two columns x and y are a profile. Two or three columns with other names, all of lengths, are
/// points if they look so (coordinates_in). Otherwise all columns are heights; what looks like
/// coordinates then, a first line too, or has labels of some of them, is refused unless Reading::columns is
/// "none".
///
/// Points x z or x y z, in any order, become a map: on the grid that their printed coordinates lie on.
///
/// A coordinate that is printed with a last digit of size u is off by u/2 at most, and by the rounding ρ of a
/// binary number: 8ε of the largest coordinate, or 2^-22 of it if all are numbers in single precision, as
/// printed. The last digit is the finest among the coordinates, for numbers with fixed decimals and for those
/// with fixed significant digits alike. Coordinates x_k lie on a grid first + k·step if
///     |x_k - first - k·step| <= u_k/2 + ρ                                                              (1)
/// where first and step are those from the ends of the range, which are off themselves:
///     |x_k - first - k·step| <= (u_k + max(u_first, u_last))/2 + ρ  and  <= step/4 ;                    (2)
/// or else, on a grid without gaps, those of all that satisfy (1) which leave the most room to spare.
///
/// Grid lines may be missing, up to half of them: the step is then the smallest distance. Digits that are
/// too coarse, such as 2.5 of them a step, fit a grid with missing lines as well as one without. If eight
/// or more would be missing, none is: (1) held for 18 of 20 000 random choices of 8 missing ones among 20,
/// for none of 20 000 among 30 or 60. A single one is missing if there are twenty lines or more: the
/// spacing then changes by less than a twentieth. What lies between is ambiguous, unless (1) holds by ties
/// of rounding alone: then lines are missing. Coordinates that fit no grid are compared again with those
/// joined that differ by one digit.
///
/// A profile x z whose x ascend or descend, but fit no grid, is read at as many even places, by straight
/// lines between neighbours no further apart than three mean steps; a note says so.
///
/// At least half of the points of the grid must be given; the others are missing. The spacing is the range of
/// a coordinate divided by the number of steps. A profile x z has the same spacing in y. Lines without any
/// number are no points.
///
/// Cost      n log n for n points.
#pragma once

#include <string>
#include <vector>

#include "formats/text_head.hpp"

namespace asperity {

struct Columns {
  std::vector<Index> of;                ///< of z; x and z; x, y and z; none: all are heights
  std::vector<std::string> units;       ///< of each; of all heights one; "": unknown
  std::vector<std::string> left_out{};  ///< names of others

  bool points() const { return of.size() > 1; }
};

/// As Reading::columns has them, with units where they have none: "2/um,1/um,3/nm".
std::string example_of(const Columns& columns);
/// `bare`: known to be heights. Throws DataError("map", …) naming the parameters that decide.
Columns columns_of(const Table& table, const std::vector<Label>& labels, const Reading& reading, bool bare);

/// Heights in their own unit. Throws DataError("map", …) for points that are no grid, or given twice.
Map map_of_points(const Table& table, const Columns& columns);

/// Whether columns of a bare matrix look like coordinates: as heights of a map they would go unnoticed.
///
/// Columns do if the first ascends or descends in even steps and the last does not; if the first of two is
/// monotonic; if the first two of three lie on a grid or one of them is monotonic; or if the first line,
/// apart from its corner, ascends evenly too. The first line does if it alone ascends or descends in even
/// steps, of three lines and four columns at least; or apart from its corner, if that is missing, of three
/// columns. Even steps differ by a twentieth at most.
enum class Coordinates { none, columns, line };
Coordinates coordinates_in(const Eigen::Map<const Field>& lines);

}  // namespace asperity
