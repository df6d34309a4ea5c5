/// Numbers in text, in the spellings of instruments and programs.
///
/// 1.5, 1.8823e-008, 1.0D-6, +2, −3 (U+2212), 1'234.5, 1 234,5 (U+00A0 and other blanks of typography between
/// thousands). Missing points are `nan`, `bad`, `na`, `n/a`, `null`, `void`, `nodata`, `no data`, the errors
/// of spreadsheets in English and German as `#N/A`, `#NV`, `#DIV/0!` (any case), what Windows prints for NaN,
/// two or more hyphens or stars, and three or more #. The locale does not matter.
/// Separators: formats/text_table.hpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/field.hpp"

namespace asperity {

/// The meaning of a comma in a number: none, decimal mark, thousands separator, or decimal mark in numbers
/// with points between thousands ("1.234,5").
enum class Comma { none, decimal, thousands, decimal_and_points };

/// A whole word as a number, NaN for a missing point; nothing when it is not a number. A decimal comma has
/// digits on both sides, and no point in the same number.
std::optional<double> number_of(std::string_view word, Comma comma = Comma::none);
/// Whether a word begins with a digit, a sign or a point, and has a digit.
bool begins_like_number(std::string_view word);
/// "1,234,567": one to three digits without a leading zero, then groups of three after `mark`.
bool is_grouped(std::string_view whole, char mark);
/// A whole word as a whole number from 0; nothing when it is not one, or too large.
std::optional<Index> whole_number_of(std::string_view word);

/// A line for each row of the field, with a word for missing points.
std::string text_of(const Field& rows, char separator = '\t', std::string_view missing = "nan");

/// The next line without its end (LF, CR LF or CR), removed from `text`.
std::string_view take_line(std::string_view& text);
/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);
/// Whether a character is a letter, or of one beyond ASCII.
bool is_alpha(char c);
/// In lower case.
std::string lower(std::string_view text);

// ---- UTF-16, as Windows programs write it, to UTF-8; without its mark it is refused ----

/// Whether bytes have a control character other than white space: as bytes, or as units of 16 bits in either
/// byte order.
bool has_control(std::string_view bytes);
bool has_wide_control(std::string_view bytes);
/// Whether bytes begin with the mark of UTF-16, in either byte order.
bool is_utf16(std::string_view bytes);
/// Whether bytes without the mark look like UTF-16: of the first, one in two is zero, nearly always, and the
/// others are text.
bool lacks_mark(std::string_view bytes);
/// Throws DataError(variable, …) then.
void refuse_without_mark(std::string_view bytes, const std::string& variable);
/// In UTF-8, without the mark; halves of surrogates become U+FFFD. Memory: at most 1.5 times the bytes.
std::string utf8_from_utf16(std::string_view bytes);

}  // namespace asperity
