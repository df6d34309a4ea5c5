/// The cells of a line of text, and which lines are comments.
///
/// A cell that begins with a double quote ends at the next one, and separators in it separate nothing.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/map.hpp"

namespace asperity {

char character_of(Separator separator);
/// The next cell, removed from the line; after the last cell the line is null.
std::string_view take_cell(std::string_view& line, Separator separator, bool quotes);
/// The part of a line with cells.
std::string_view content_of(std::string_view line, Separator separator);
/// The cells of a line, without blanks and quotes around them.
std::vector<std::string_view> cells_of(std::string_view line, Separator separator, bool quotes);
/// Whether a line is a comment: it begins with # or %, or with ; if it is not the separator. Not so where its
/// first cell is a missing point, of three or more # only beside a number, or % alone before a number.
bool is_comment(std::string_view line, Separator separator, const std::vector<std::string>& missing = {});

}  // namespace asperity
