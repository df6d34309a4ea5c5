/// What the lines above the numbers of a text say: names and units of the columns, and the unit of the
/// values.
///
/// A label is a name, or a name and a unit: x [mm], Height (µm), z/nm, x in mm, z_um. In square brackets the
/// unit may be of any quantity, else it is one of length. A line has labels if it has one for each column; a
/// line of units alone belongs to the names near it.
///
/// In other lines a unit stands in brackets, after a separator, "in", "unit" or a name, or alone: "z unit:
/// nm", "heights in nm". Next to a number it belongs to that quantity ("Radius: 12.5 um", "Cutoff [mm]:
/// 0.8"). The words before it say whose it is: of the values (z, height, data, Höhe; or "Units" alone), of x
/// and y (width, pixel), or of neither or both, which is unclear. A number after "z factor", "scale" and the
/// like multiplies the values, unless it is 1.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/text_lines.hpp"

namespace asperity {

struct Label {
  std::string name, unit;  ///< "" where there is none
};
Label label_of(std::string_view cell);

enum class CoordinateRole { other, x, y, z };
/// By the names that instruments use: x, "X pos", Lateral, Position; z, Height, Höhe, Profile.
CoordinateRole role_of(const std::string& name);
/// Whether a name begins with the letter of its role.
bool is_letter(const std::string& name);
/// Whether a name is that of x or y, or of their size.
bool names_coordinates(std::string_view name);

struct TextHead {
  std::vector<Label> labels;     ///< of the columns, one for each; none if no line gives names or units
  std::vector<HeadLine> others;  ///< the lines that give no column a unit
};
TextHead head_of(const Table& table);
/// Whether each of two or three columns has the label of a coordinate or a height.
bool names_points(const Table& table);

/// The unit of the values: `known`, from elsewhere in the file, or as the lines state it; "" if nothing gives
/// it, or if Reading::unit_told and the lines are unclear. Throws DataError("map", …) where two units differ,
/// one is unclear, or a factor is given, unless Reading::unit_told.
std::string unit_of_values(const std::vector<HeadLine>& lines, const std::string& known,
                           const Reading& reading);

}  // namespace asperity
