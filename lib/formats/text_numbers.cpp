#include "formats/text_numbers.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "core/error.hpp"
#include "core/words.hpp"

namespace asperity {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Words for a missing point, in any case.
bool is_missing(std::string_view word) {
  constexpr std::string_view words[] = {"nan",     "bad",     "n/a",     "na",      "#n/a",      "null",
                                        "no data", "no_data", "nodata",  "void",    "-nan(ind)", "1.#qnan",
                                        "-1.#ind", "#nv",     "#div/0!", "#wert!",  "#value!",   "#ref!",
                                        "#num!",   "#name?",  "#null!",  "#bezug!", "#zahl!"};
  constexpr std::size_t longest = 9;
  if (word.size() > 1 && word.find_first_not_of('-') == word.npos) return true;
  if (word.size() > 1 && word.find_first_not_of('*') == word.npos) return true;
  if (word.size() > 2 && word.find_first_not_of('#') == word.npos) return true;
  return word.size() <= longest && std::ranges::find(words, lower(word)) != std::end(words);
}

// Removes `mark` between thousands before `decimal`; false where it stands elsewhere.
bool join_thousands(std::string& number, char mark, char decimal) {
  if (number.find(mark) == number.npos) return true;
  const std::size_t sign = std::min(number.find_first_not_of("+-"), number.size());
  const std::string_view whole = std::string_view(number).substr(0, number.find(decimal)).substr(sign);
  if (!is_grouped(whole, mark) || number.find(mark, sign + whole.size()) != number.npos) return false;
  std::erase(number, mark);
  return true;
}

// Blanks of typography and the apostrophe, which can only stand between thousands, as apostrophes.
void mark_thousands(std::string& number) {
  for (const std::string_view blank : {"\u00a0", "\u202f", "\u2009", "\u2019"})
    for (std::size_t at = 0; (at = number.find(blank, at)) != number.npos;)
      number.replace(at, blank.size(), "'");
}

// A decimal comma with digits on both sides becomes a point; false for any other comma, or a point.
bool point_for_comma(std::string& number) {
  if (number.find('.') != number.npos) return false;
  const std::size_t at = number.find(',');
  if (at == number.npos) return true;
  if (at == 0 || at + 1 == number.size() || !is_digit(number[at - 1]) || !is_digit(number[at + 1]))
    return false;
  number[at] = '.';
  return true;
}

// The number as C writes it: replaces other spellings of sign, exponent, decimal mark and thousands.
std::optional<std::string> in_c(std::string_view word, Comma comma) {
  constexpr std::string_view minus = "\u2212";
  std::string out;
  if (word.starts_with(minus)) out = "-";
  word.remove_prefix(out.empty() ? 0 : minus.size());
  out += word;
  const bool decimal = comma == Comma::decimal || comma == Comma::decimal_and_points;
  mark_thousands(out);
  if (!join_thousands(out, '\'', decimal ? ',' : '.')) return std::nullopt;
  if (comma == Comma::thousands && !join_thousands(out, ',', '.')) return std::nullopt;
  if (comma == Comma::decimal_and_points && !join_thousands(out, '.', ',')) return std::nullopt;
  if (decimal && !point_for_comma(out)) return std::nullopt;
  if (const std::size_t d = out.find_first_of("dD");
      d != out.npos && d > 0 && (is_digit(out[d - 1]) || out[d - 1] == '.'))
    out[d] = 'e';
  if (out.size() > 1 && out.front() == '+' && out[1] != '-') out.erase(0, 1);
  return out;
}

// Infinite, or 0, for a number beyond the range of doubles.
std::optional<double> plain_number_of(std::string_view word) {
  const auto out = leading_number<double>(word);
  return out.found && out.rest.empty() ? std::optional(out.number) : std::nullopt;
}

}  // namespace

bool begins_like_number(std::string_view word) {
  return word.find_first_of("0123456789.+-") == 0 && word.find_first_of("0123456789") != word.npos;
}

bool is_grouped(std::string_view whole, char mark) {
  if (whole.starts_with('0') || whole.size() > 19) return false;
  const std::size_t first = whole.find(mark);
  if (first == whole.npos || first == 0 || first > 3 || (whole.size() - first) % 4 != 0) return false;
  for (std::size_t i = 0; i < whole.size(); ++i)
    if ((i >= first && (i - first) % 4 == 0) ? whole[i] != mark : !is_digit(whole[i])) return false;
  return true;
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end);
  text.remove_prefix(text.starts_with("\r\n") ? 2 : text.empty() ? 0 : 1);
  return line;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  text.remove_prefix(begin);
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

bool is_alpha(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
}

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

std::optional<double> number_of(std::string_view word, Comma comma) {
  constexpr std::size_t longest = 64;  // of a number in another spelling than C's
  const bool points = comma != Comma::decimal && comma != Comma::decimal_and_points;
  const auto value = plain_number_of(word);
  if (value && (points || word.find('.') == word.npos)) return value;
  if (is_missing(word)) return std::numeric_limits<double>::quiet_NaN();
  const auto plain = word.size() <= longest ? in_c(word, comma) : std::nullopt;
  return plain ? plain_number_of(*plain) : std::nullopt;
}

std::optional<Index> whole_number_of(std::string_view word) {
  const auto out = to_number<Index>(word);
  return out && *out >= 0 ? out : std::nullopt;
}

std::string text_of(const Field& rows, char separator, std::string_view missing) {
  std::string out;
  out.reserve(static_cast<std::size_t>(rows.size()) * 20);
  for (Index i = 0; i < rows.rows(); ++i)
    for (Index j = 0; j < rows.cols(); ++j) {
      if (std::isnan(rows(i, j)))
        out += missing;
      else
        append_number(out, rows(i, j));
      out += j + 1 < rows.cols() ? separator : '\n';
    }
  return out;
}

// ---- encodings ----

namespace {

bool is_control(unsigned char c) { return c < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f'; }

void append_utf8(std::string& out, char32_t c) {
  constexpr char32_t lead[] = {0, 0xc0, 0xe0, 0xf0};
  const std::size_t more = c < 0x80 ? 0 : c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
  const auto put = [&](char32_t byte) { out += static_cast<char>(static_cast<unsigned char>(byte)); };
  put(lead[more] | c >> 6 * more);
  for (std::size_t n = more; n-- > 0;) put(0x80 | (c >> 6 * n & 0x3f));
}

}  // namespace

bool has_control(std::string_view bytes) { return std::ranges::any_of(bytes, is_control); }

bool has_wide_control(std::string_view bytes) {
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const auto [low, high] =
        std::minmax({static_cast<unsigned char>(bytes[i]), static_cast<unsigned char>(bytes[i + 1])});
    if (high < 0x20 && (low > 0 || is_control(high))) return true;
  }
  return false;
}

bool is_utf16(std::string_view bytes) {
  return bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff");
}

bool lacks_mark(std::string_view bytes) {
  constexpr std::size_t looked_at = 4096, least = 8;
  constexpr double share = 0.9;  // of characters below U+0100
  bytes = bytes.substr(0, std::min(looked_at, bytes.size() / 2 * 2));
  if (is_utf16(bytes) || bytes.size() < least) return false;
  std::array<std::size_t, 2> zeros{}, control{};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto c = static_cast<unsigned char>(bytes[i]);
    zeros[i % 2] += c == 0;
    control[i % 2] += is_control(c);
  }
  const double nearly_all = share * static_cast<double>(bytes.size() / 2);
  return (static_cast<double>(zeros[0]) >= nearly_all && control[1] == 0) ||
         (static_cast<double>(zeros[1]) >= nearly_all && control[0] == 0);
}

void refuse_without_mark(std::string_view bytes, const std::string& variable) {
  if (lacks_mark(bytes))
    throw DataError(variable, "the text looks like UTF-16 without its byte-order mark: save it as UTF-8");
}

std::string utf8_from_utf16(std::string_view bytes) {
  constexpr char32_t replacement = 0xfffd;
  const bool big = bytes.starts_with("\xfe\xff");
  const auto unit = [&](std::size_t i) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(bytes[at]); };
    return static_cast<char32_t>(big ? byte(i) * 256 + byte(i + 1) : byte(i + 1) * 256 + byte(i));
  };
  const auto half = [&](std::size_t i, char32_t first) {  // of a surrogate
    return i + 1 < bytes.size() && unit(i) >= first && unit(i) < first + 0x400;
  };
  std::string out;
  out.reserve(bytes.size() / 2);
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    const bool high = half(i, 0xd800);
    if (high && half(i + 2, 0xdc00)) {
      append_utf8(out, 0x10000 + ((unit(i) - 0xd800) << 10) + (unit(i + 2) - 0xdc00));
      i += 2;
    } else {
      append_utf8(out, high || half(i, 0xdc00) ? replacement : unit(i));
    }
  }
  if (bytes.size() % 2 == 1) append_utf8(out, replacement);
  return out;
}

}  // namespace asperity
