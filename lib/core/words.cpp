#include "core/words.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <locale.h>  // NOLINT(modernize-deprecated-headers): newlocale is of POSIX
#include <vector>

namespace asperity {
namespace {

// The bytes of the first character of UTF-8 text; 0 if it is invalid.
std::size_t size_of_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return 1;
  const std::size_t size = first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
  if (first == 0xe0 && second < 0xa0) return 0;
  if (first == 0xed && second > 0x9f) return 0;
  if (first == 0xf0 && second < 0x90) return 0;
  if (first == 0xf4 && second > 0x8f) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if (byte(i) >> 6 != 2) return 0;
  return size;
}

std::string of_latin1(char byte) {
  const auto code = static_cast<unsigned char>(byte);
  return {static_cast<char>(0xc0 | code >> 6), static_cast<char>(0x80 | (code & 0x3f))};
}

// Calls visit with each character, as UTF-8.
void for_each_character(std::string_view text, const auto& visit) {
  while (!text.empty()) {
    const std::size_t size = size_of_character(text);
    if (size > 0)
      visit(text.substr(0, size));
    else
      visit(std::string_view(of_latin1(text.front())));
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
}

// Control characters of both sets, the soft hyphen, line and paragraph separators, direction marks and
// overrides, invisible joiners, the byte-order mark, and the two noncharacters.
bool speaks(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  if (character.size() == 1) return first < 0x20 || first == 0x7f;
  if (character.size() == 2)
    return (first == 0xc2 && character[1] < '\xa0') || character == "\u00ad" || character == "\u061c";
  constexpr std::string_view others[] = {"\u200b", "\u200e",       "\u200f",
                                         "\ufeff", "\xef\xbf\xbe", "\xef\xbf\xbf"};
  const auto within = [&](std::string_view low, std::string_view high) {
    return character.size() == 3 && character >= low && character <= high;
  };
  return within("\u2028", "\u202e") || within("\u2060", "\u206f") ||
         std::ranges::find(others, character) != std::end(others);
}

}  // namespace

std::string shortest(double value) {
  std::string out;
  append_number(out, value);
  return out;
}

void append_number(std::string& text, double value) {
  char digits[32];
  if (std::isnan(value))
    text += "nan";
  else
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

std::string in_digits(double value, int most) {
  char digits[64];
  const auto general = std::chars_format::general;
  return {digits, std::to_chars(digits, digits + sizeof digits, value, general, most).ptr};
}

namespace {

// Independent of the locale of the process.
double to_double(const std::string& text, char** end) {
  static const locale_t c = ::newlocale(LC_ALL_MASK, "C", nullptr);
  return ::strtod_l(text.c_str(), end, c);
}

}  // namespace

// from_chars does not say which of the two it is.
double beyond_range(std::string_view number) { return to_double(std::string(number), nullptr); }

#if defined(__cpp_lib_to_chars) && !defined(ASPERITY_PORTABLE)

std::from_chars_result read_number(std::string_view text, double& number) {
  return std::from_chars(text.data(), text.data() + text.size(), number);
}

#else

namespace {

// The characters at the beginning that may be a number: strtod knows blanks, a plus and hexadecimal digits.
std::string_view number_at_begin(std::string_view text) {
  constexpr std::string_view digits = "0123456789";
  const auto is_one_of = [&](std::size_t i, std::string_view characters) {
    return i < text.size() && characters.find(text[i]) != characters.npos;
  };
  const auto behind = [&](std::size_t i, std::string_view characters) {
    return std::min(text.find_first_not_of(characters, i), text.size());
  };
  const std::size_t sign = is_one_of(0, "-") ? 1 : 0;
  if (is_one_of(sign, "iInN")) return text.substr(0, behind(sign, "infatyINFATY"));
  const std::size_t whole = behind(sign, digits),
                    all = is_one_of(whole, ".") ? behind(whole + 1, digits) : whole;
  if (!is_one_of(all, "eE")) return text.substr(0, all);
  return text.substr(0, behind(all + (is_one_of(all + 1, "+-") ? 2 : 1), digits));
}

}  // namespace

std::from_chars_result read_number(std::string_view text, double& number) {
  const std::string word(number_at_begin(text));
  char* end = nullptr;
  const double found = to_double(word, &end);
  const auto length = static_cast<std::size_t>(end - word.c_str());
  const std::string_view mantissa = text.substr(0, std::min(word.find_first_of("eE"), length));
  const bool is_zero = mantissa.find_first_of("123456789") == mantissa.npos,
             is_infinity = mantissa.find_first_of("iI") != mantissa.npos;
  if (length == 0) return {text.data(), std::errc::invalid_argument};
  if ((std::isinf(found) && !is_infinity) || (found == 0 && !is_zero))
    return {text.data() + length, std::errc::result_out_of_range};
  number = found;
  return {text.data() + length, std::errc()};
}

#endif

std::string counted(std::int64_t count, std::string_view thing) {
  return std::to_string(count) + " " + std::string(thing) + (count == 1 ? "" : "s");
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = size_of_character(text);
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

std::string utf8_of(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for_each_character(text, [&](std::string_view character) { out += character; });
  return out;
}

std::string one_line(std::string_view whole, std::size_t most) {
  const std::size_t enough = 4 * most;  // bytes of as many characters or more
  const std::string ends = whole.size() <= 2 * enough ? ""
                                                      : std::string(whole.substr(0, enough)) +
                                                            std::string(whole.substr(whole.size() - enough));
  const std::string_view text = ends.empty() ? whole : ends;
  std::string out;
  out.reserve(text.size());
  std::vector<std::size_t> begins;
  for_each_character(text, [&](std::string_view character) {
    begins.push_back(out.size());
    out += speaks(character) ? " " : character;
  });
  if (begins.size() <= most) return out;
  const std::size_t last = most / 3, first = most - last - 1;
  return out.substr(0, begins[first]) + "…" + out.substr(begins[begins.size() - last]);
}

}  // namespace asperity
