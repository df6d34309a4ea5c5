/// UTF-16, as Windows programs write it, to UTF-8. Without its mark it is refused.
#pragma once

#include <string>
#include <string_view>

namespace asperity {

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
