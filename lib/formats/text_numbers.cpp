#include "formats/text_numbers.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/words.hpp"

namespace asperity {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";

bool is_missing(std::string_view word) {
  if (word.size() > 1 && word.find_first_not_of('-') == word.npos) return true;
  if (word.size() > 3) return false;
  const std::string name = lower(word);
  return name == "nan" || name == "bad" || name == "n/a" || name == "na";
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// "1,234,567.5": one to three digits without a leading zero, then groups of three.
bool has_thousands(std::string_view word) {
  const std::string_view whole = word.substr(0, word.find('.'));
  if (whole.starts_with('0') || whole.size() > 19) return false;
  const std::size_t first = whole.find(',');
  if (first == whole.npos || first == 0 || first > 3 || (whole.size() - first) % 4 != 0) return false;
  for (std::size_t i = 0; i < whole.size(); ++i)
    if ((i >= first && (i - first) % 4 == 0) ? whole[i] != ',' : !is_digit(whole[i])) return false;
  return true;
}

// The number as C writes it: replaces other spellings of sign, exponent and decimal mark.
std::optional<std::string> in_c(std::string_view word, Comma comma) {
  constexpr std::string_view minus = "\u2212";
  std::string out;
  if (word.starts_with(minus)) out = "-";
  word.remove_prefix(out.empty() ? 0 : minus.size());
  out += word;
  const std::size_t at = out.find(','), digits = out.find_first_not_of("+-");
  if (at != out.npos && comma == Comma::none) return std::nullopt;
  if (comma == Comma::decimal) {
    if (out.find('.') != out.npos) return std::nullopt;
    if (at != out.npos) {
      if (at == 0 || at + 1 == out.size() || !is_digit(out[at - 1]) || !is_digit(out[at + 1]))
        return std::nullopt;
      out[at] = '.';
    }
  } else if (at != out.npos) {
    if (!has_thousands(std::string_view(out).substr(digits))) return std::nullopt;
    std::erase(out, ',');
  }
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

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

std::optional<double> number_of(std::string_view word, Comma comma) {
  if (is_missing(word)) return std::numeric_limits<double>::quiet_NaN();
  if (const auto value = plain_number_of(word);
      value && !(comma == Comma::decimal && word.find('.') != word.npos))
    return value;
  const auto plain = in_c(word, comma);
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

}  // namespace asperity
