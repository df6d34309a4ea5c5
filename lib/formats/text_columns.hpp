/// What the columns of a text are: heights, or points of a profile or of a surface.
///
/// They are points if Reading::columns says so, or the labels above them: x and z, or x, y and z, with units,
/// those of x and y of length; columns without such a name are left out where the others are the letters x, y
/// and z. Two columns x and y are a profile. Two or three columns with other names, all of lengths, are
/// points if they look so (formats/text_points.hpp). Otherwise all columns are heights; what looks like
/// coordinates then, a first line too, or has labels of some of them, is refused unless Reading::columns is
/// "none".
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

}  // namespace asperity
