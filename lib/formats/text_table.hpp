/// Tables of numbers in text.
///
/// The separator and the meaning of commas are found for the whole text: all ways to read it are tried, and
/// one fits if every line has the same count of numbers. Separators are blanks (any run of blanks and tabs),
/// or a tab, comma or semicolon, each of which ends one cell; the decimal mark is a point, or a comma that is
/// not a separator or stands in quotes. If no way fits, the text is refused with the first line in error. If
/// two ways fit and give different numbers ("1,5" is 1.5, or 1 and 5), it is refused unless `reading`
/// decides, or only one way has labels of coordinates and heights for all its columns. Commas between
/// thousands are accepted only if nothing else fits ("1,234.5 2,000"), points only beside a decimal comma.
/// Unless the decimal mark is told, some number must have both, or two of them ("1.234,5", "1,234,567"), and
/// none may lack them ("1512.523"). Where tabs and blanks both fit, tabs end cells,
/// unless that leaves a column empty. Blanks between tabs may
/// stand between thousands ("1 234,5"), if the text cannot be read with blanks as separators too.
///
/// An empty cell is a missing point. If every line ends with a separator, there is no cell after it. Lines
/// that are empty or begin with # or %, or with ; if it is not the separator, are ignored, except
/// those that may be lines of the table (is_comment(), formats/text_lines.hpp); in a line of
/// separators only, all points are missing. A byte-order mark of UTF-8 is ignored; UTF-16 is refused. A line
/// ends with LF, CR LF or CR.
///
/// Lines of words above the numbers are read by table_with_head() only (formats/text_lines.hpp). Of ways that
/// fit, the one counts whose numbers begin first; where numbers above them fit only a way that fails later,
/// the text is refused, so that no line of numbers passes for words.
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
