#include "formats/head.hpp"

#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "core/words.hpp"
#include "formats/text_numbers.hpp"

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

[[noreturn]] void refuse(std::string_view key, std::string_view value, std::string_view what) {
  if (value.empty()) throw DataError("map", "its head does not state " + std::string(key));
  throw DataError("map",
                  "its " + std::string(key) + ", '" + one_line(value, 24) + "', is " + std::string(what));
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

std::string_view take_head(std::string_view& bytes, std::size_t& lines, bool (*ends)(std::string_view line),
                           std::string_view end) {
  const std::string_view all = bytes;
  for (std::string_view rest = bytes; !rest.empty();) {
    ++lines;
    if (!ends(trimmed(take_line(rest)))) continue;
    bytes = rest;
    return all.substr(0, all.size() - rest.size());
  }
  throw DataError("map", "its head has no end, " + std::string(end));
}

std::string head_line(std::string_view key, std::string_view separator, std::string_view value) {
  return std::string(key) + std::string(separator) + one_line(value) + "\n";
}

std::string head_line(std::string_view key, std::string_view separator, double value) {
  return head_line(key, separator, shortest(value));
}

}  // namespace asperity
