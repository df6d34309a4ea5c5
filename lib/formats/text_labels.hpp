/// Words above the numbers of a text: names and units of columns.
///
/// A label is a name, or a name and a unit: x [mm], Height (µm), z/nm, x in mm, z_um. In square brackets the
/// unit may be of any quantity, else it is one of length. A line of units alone belongs to the names near it.
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

/// The labels of columns in the head of a table, one for each; none if no line gives names or units.
std::vector<Label> labels_of(const Table& table, bool quotes);
/// Whether each of two or three columns has the label of a coordinate or a height.
bool names_points(const Table& table, bool quotes);
/// The head of a table without the lines that give its columns units.
std::vector<HeadLine> without_labels(const Table& table, bool quotes);

/// Whether two units are the same length.
bool same_length(const std::string& a, const std::string& b);
bool is_length(std::string_view unit);
/// Whether UDUNITS knows a unit, of any quantity; not so of numbers.
bool is_unit(std::string_view unit);

}  // namespace asperity
