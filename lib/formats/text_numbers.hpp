/// Matrices of numbers in text, one line each.
///
/// Numbers are separated by blanks, tabs, semicolons or commas; where other separators stand between them, a comma within
/// a number is a decimal comma. Exponents of any length (1.8823e-008) and a leading plus are understood; `nan`, `bad` and
/// `--` (any case) are missing points. Lines that are empty are skipped.
///
/// Cost      one pass; memory for the numbers that there are, at most half the bytes times eight.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grid/field.hpp"

namespace asperity {

/// Whether a comma is part of the numbers: some other separator stands in the text beside it.
bool has_decimal_commas(std::string_view text);
/// A whole word as a number, missing ones NaN; nothing when it is none.
std::optional<double> number_of(std::string_view word, bool decimal_comma = false);
/// A whole word as a whole number from 0 on; nothing when it is none, or too large.
std::optional<Index> whole_number_of(std::string_view word);

/// Lines of as many numbers each; throws DataError(variable, …) that names the line where there is something else, a
/// number that is infinite, or another number of them. `first_line` is what the first is called.
Field matrix_of(std::string_view text, const std::string& variable, std::size_t first_line = 1);
/// All numbers one after the other, whatever the lines.
std::vector<double> numbers_of(std::string_view text, const std::string& variable,
                               std::size_t first_line = 1);

/// As many numbers as the shape has, line by line, each along x, however the text is broken into lines. Throws DataError before
/// memory is taken for a shape that the text cannot hold, and where there are more or fewer.
Field field_of_lines(std::string_view text, Shape shape, const std::string& variable,
                     std::size_t first_line = 1);

/// The shortest decimal fraction that is read back the same; "nan" for a missing point.
void append_number(std::string& text, double value);
/// A line for each row of the field, with a word for what is missing.
std::string text_of(const Field& rows, char separator = '\t', std::string_view missing = "nan");

/// The next line without its end, taken off `text`.
std::string_view take_line(std::string_view& text);
/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);
/// In lower case.
std::string lower(std::string_view text);

}  // namespace asperity
