/// Tables of numbers in text, whoever wrote them.
///
/// What separates the numbers and what a comma means is decided for the whole text: every way is tried in
/// which all lines hold numbers, and as many of them each. Separators are blanks (any run of blanks and
/// tabs), or a tab, a comma or a semicolon, each of which ends one cell; decimals are marked by a point, or
/// by a comma where it does not separate. A text that no way fits is refused with the first line that does
/// not; one that two ways fit with different numbers ("1,5" is 1.5, or 1 and 5) is refused too, unless
/// `reading` tells. Commas between thousands are understood where nothing else fits ("1,234.5 2,000"), points
/// never. Tabs are cells' ends where blanks would fit as well, unless that leaves a column empty.
///
/// An empty cell is a missing point. Where every line ends with a separator, no cell is meant behind it.
/// Lines that are empty or begin with # or %, or with ; where that does not separate, are left out; one of
/// separators alone has all its points missing. A byte-order mark of UTF-8 is left out; UTF-16 is refused. A
/// line ends with LF, CR LF or CR.
///
/// Cost      at most ten passes, all but two of which end at the first line as a rule. Memory for two tables,
///           eight bytes for a number, of which there is at most one a byte; three of them must be allowed by
///           `reading`.
#pragma once

#include <string>
#include <string_view>

#include "core/field.hpp"
#include "formats/map.hpp"

namespace asperity {

/// Lines of as many numbers each; throws DataError(variable, …) that names the line where there is something
/// else, a number that is infinite, or another number of them. `first_line` is what the first is called.
Field matrix_of(std::string_view text, const std::string& variable, std::size_t first_line = 1,
                const Reading& reading = {});
/// As many numbers as the shape has, line by line, each along x, however the text is broken into lines.
/// Throws DataError where there are more or fewer, and before memory is taken for what the text cannot hold.
Field field_of_lines(std::string_view text, Shape shape, std::size_t first_line, const Reading& reading);

}  // namespace asperity
