/// Tables of numbers in text: which way to read one is found for the whole text.
///
/// All ways are tried (formats/text_lines.hpp), and one fits if every line has the same count of numbers. The
/// decimal mark is a point, or a comma that is not a separator or stands in quotes. If no way fits, the text
/// is refused with the first line in error. If two ways fit and give different numbers ("1,5" is 1.5, or 1
/// and 5), it is refused unless `reading` decides, or only one way has labels of coordinates and heights for
/// all its columns. Commas between thousands are accepted only if nothing else fits ("1,234.5 2,000"), points
/// only with a decimal comma. Unless `reading` gives the decimal mark, some number must have both, or two of
/// them ("1.234,5", "1,234,567"), and none may lack them ("1512.523"). Where tabs and blanks both fit, tabs
/// end cells, unless that leaves a column empty. Blanks between tabs may stand between thousands ("1 234,5"),
/// if the text cannot be read with blanks as separators too.
///
/// Lines of words above the numbers are read by table_with_head() only. Of ways that fit, the one counts
/// whose numbers begin first; where numbers above them fit only a way that fails later, the text is refused,
/// so that no line of numbers passes for words. A byte-order mark of UTF-8 is ignored.
///
/// Cost      at most sixteen passes; usually all but one or two end at the first line. Memory for two tables
///           of eight bytes per number, with at most one number per byte of text; `reading` must allow three
///           tables.
#pragma once

#include <string>
#include <string_view>

#include "core/field.hpp"
#include "formats/map.hpp"
#include "formats/text_lines.hpp"

namespace asperity {

/// Lines with the same count of numbers each. Throws DataError(variable, …) naming the line with another
/// count, an infinite number, or something else. `first_line` is the number of the first line.
Field matrix_of(std::string_view text, const std::string& variable, std::size_t first_line = 1,
                const Reading& reading = {});
/// As many numbers as the shape has cells, x fastest, with any line breaks. Throws DataError when there are
/// more or fewer, and before allocation when the text cannot hold so many.
Field field_of_lines(std::string_view text, Shape shape, std::size_t first_line, const Reading& reading);
/// The same as matrix_of for "map", below lines of words.
Table table_with_head(std::string_view text, const Reading& reading);

/// "separated by tabs and decimal commas".
std::string described(Dialect dialect);

}  // namespace asperity
