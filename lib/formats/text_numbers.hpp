/// Numbers in text, in the spellings that instruments and programs have for them.
///
/// 1.5, 1.8823e-008, 1.0D-6, +2, −3 (U+2212); `nan`, `bad`, `na`, `n/a` (any case) and two hyphens or more
/// are missing points. The process's language does not matter. What separates them is said in
/// formats/text_table.hpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/field.hpp"

namespace asperity {

/// What a comma is in a number: nothing, the decimal mark, or one between thousands.
enum class Comma { none, decimal, thousands };

/// A whole word as a number, missing ones NaN; nothing when it is none. A decimal comma has digits on both
/// sides, and no point beside it.
std::optional<double> number_of(std::string_view word, Comma comma = Comma::none);
/// A whole word as a whole number from 0 on; nothing when it is none, or too large.
std::optional<Index> whole_number_of(std::string_view word);

/// A line for each row of the field, with a word for what is missing.
std::string text_of(const Field& rows, char separator = '\t', std::string_view missing = "nan");

/// The next line without its end (LF, CR LF or CR), taken off `text`.
std::string_view take_line(std::string_view& text);
/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);
/// In lower case.
std::string lower(std::string_view text);

}  // namespace asperity
