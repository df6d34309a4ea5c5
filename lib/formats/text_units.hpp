/// What the lines above the numbers of a text say of the unit of its values.
///
/// A unit stands in brackets, behind a separator, "in", "unit" or a name, or alone: "z unit: nm",
/// "Height (nm)", "heights in nm"; beside a number it belongs to that quantity ("Radius: 12.5 um",
/// "Cutoff [mm]: 0.8"). The words before it tell whose it is: of the values (z, height, data, Höhe; or
/// "Units" alone), of x and y (width, pixel), or of neither or both, which is unclear. A number behind
/// "z factor", "scale" and the like multiplies the values, unless it is 1.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/text_lines.hpp"

namespace asperity {

/// The unit of the values: `known`, from elsewhere in the file, or as the head states it; "" if it is told
/// (Reading::unit_told) and the head is unclear, or nothing gives it. Throws DataError("map", …) where two
/// units differ, one is unclear, or a factor is given, and none is told.
std::string unit_of_values(const std::vector<HeadLine>& head, const std::string& known,
                           const Reading& reading);

/// Whether a name is that of x or y, or of their size.
bool names_coordinates(std::string_view name);
/// The lines of a text.
std::vector<HeadLine> head_lines(std::string_view text);

}  // namespace asperity
