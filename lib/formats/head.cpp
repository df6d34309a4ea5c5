#include "formats/head.hpp"

#include <cmath>

#include "formats/refuse.hpp"
#include "formats/text_numbers.hpp"

namespace asperity {
namespace {

bool same_key(std::string_view a, std::string_view b) { return a.size() == b.size() && lower(a) == lower(b); }

[[noreturn]] void refuse_value(std::string_view key, std::string_view value, std::string_view what) {
  if (value.empty()) refuse("{} is missing in the header", key);
  refuse("{} {} in the header is not {}", key, quoted(value), what);
}

}  // namespace

std::size_t Head::lines() const {
  std::size_t out = 0;
  for (std::string_view rest = lines_; !rest.empty(); take_line(rest)) ++out;
  return out;
}

std::string_view Head::take(std::string_view& lines, std::string_view key) const {
  while (!lines.empty()) {
    const std::string_view line = trimmed(take_line(lines));
    const std::size_t end = line.find_first_of(separators_);
    if (end == line.npos || !same_key(trimmed(line.substr(0, end)), key)) continue;
    if (!line.substr(end).starts_with(":="))
      return trimmed(line.substr(end + 1));  // a user's own key in NRRD
  }
  return {};
}

bool Head::has(std::string_view key) const {
  std::string_view rest = lines_;
  return take(rest, key).data() != nullptr;
}

std::string_view Head::text(std::string_view key) const {
  std::string_view rest = lines_;
  const std::string_view out = take(rest, key);
  for (std::string_view next = take(rest, key); next.data() != nullptr; next = take(rest, key)) {
    const auto number = number_of(out);
    if (next != out && !(number && number == number_of(next)))
      refuse("{} is {} and {} in the header: remove one", key, quoted(out), quoted(next));
  }
  return out;
}

double Head::number(std::string_view key) const {
  const std::string_view value = text(key);
  const double out = number_of(value).value_or(std::nan(""));
  if (!std::isfinite(out)) refuse_value(key, value, "a number");
  return out;
}

double Head::positive(std::string_view key) const {
  const double out = number(key);
  if (!(out > 0)) refuse_value(key, text(key), "positive");
  return out;
}

Index Head::count(std::string_view key) const {
  const auto out = whole_number_of(text(key));
  if (!out) refuse_value(key, text(key), "a whole number from 0");
  return *out;
}

std::string_view take_head(std::string_view& bytes, bool (*ends)(std::string_view line)) {
  const std::string_view all = bytes;
  while (!bytes.empty())
    if (ends(trimmed(take_line(bytes)))) return all.substr(0, all.size() - bytes.size());
  refuse_cut_header();
}

}  // namespace asperity
