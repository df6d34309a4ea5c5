#include "formats/head.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "formats/text_numbers.hpp"
#include "grid/error.hpp"

namespace asperity {
namespace {

bool same_key(std::string_view a, std::string_view b) { return a.size() == b.size() && lower(a) == lower(b); }

std::optional<std::string_view> value_of(std::string_view lines, std::string_view separators,
                                         std::string_view key) {
  while (!lines.empty()) {
    const std::string_view line = trimmed(take_line(lines));
    const std::size_t end = line.find_first_of(separators);
    if (end != line.npos && same_key(trimmed(line.substr(0, end)), key)) return trimmed(line.substr(end + 1));
  }
  return std::nullopt;
}

// The bytes of the character that UTF-8 text begins with; 0 where it is none (Unicode 15, table 3-7).
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

[[noreturn]] void refuse(std::string_view key, std::string_view value, std::string_view what) {
  if (value.empty()) throw DataError("map", "its head does not state " + std::string(key));
  throw DataError("map", "its " + std::string(key) + ", '" + one_line(value.substr(0, 24)) + "', is " +
                             std::string(what));
}

}  // namespace

bool Head::has(std::string_view key) const { return value_of(lines_, separators_, key).has_value(); }

std::string_view Head::text(std::string_view key) const {
  return value_of(lines_, separators_, key).value_or("");
}

double Head::number(std::string_view key) const {
  const std::string_view value = text(key);
  const double out = number_of(value).value_or(std::nan(""));
  if (!std::isfinite(out)) refuse(key, value, "no number");
  return out;
}

double Head::positive(std::string_view key) const {
  const double out = number(key);
  if (!(out > 0)) refuse(key, text(key), "not positive");
  return out;
}

Index Head::count(std::string_view key) const {
  const auto out = whole_number_of(text(key));
  if (!out) refuse(key, text(key), "no whole number from 0 on");
  return *out;
}

std::string one_line(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const auto first = static_cast<unsigned char>(text.front());
    const std::size_t size = size_of_character(text);
    if (first < 0x20 || first == 0x7f)
      out += ' ';
    else
      out += size > 0 ? text.substr(0, size) : "?";
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return out;
}

}  // namespace asperity
