/// Numbers, counts and other people's text, as they stand in a line that is read by eyes.
///
/// Text comes from files: units, names, titles, heads. It may be no UTF-8, speak to the terminal that it is shown on (the
/// sequences of ISO 6429 begin with a control character), reverse what follows it, or be as long as the file. Inside a dataset
/// it stays as it came. Where it is shown it passes through one_line; where it is kept but must be UTF-8, as in JSON, through
/// utf8_of.
///
/// Bytes that are no UTF-8 are taken as Latin-1, which instruments write: "\xb5m" is µm.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace asperity {

/// The shortest text that reads back as the same number; "nan" whatever its sign.
std::string shortest(double value);
/// "1 surface", "2 surfaces": of what has its plural in s.
std::string counted(std::int64_t count, std::string_view thing);

/// Whether text is well-formed UTF-8 (Unicode 15, table 3-7).
bool is_utf8(std::string_view text);
/// The text itself if it is UTF-8; each byte that is none of a character becomes the one of that number, Latin-1's.
std::string utf8_of(std::string_view text);

/// Characters of a line, at most; a name of a file is shorter, but for its folders.
inline constexpr std::size_t longest_line = 1000;
/// UTF-8 with blanks for what ends a line, speaks to a terminal or turns the direction of writing, or that XML does not know.
/// Of more characters than `most` the middle gives way to an ellipsis: a message's beginning says where, its end what to do.
std::string one_line(std::string_view text, std::size_t most = longest_line);

}  // namespace asperity
