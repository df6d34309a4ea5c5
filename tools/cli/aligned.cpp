// Tables for people: columns of text.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "tools/cli/quantity.hpp"
#include "tools/cli/readable.hpp"
#include "tools/cli/table.hpp"

namespace asperity::cli {
namespace {

// ---- columns of text ----

using Words = std::vector<std::string>;

constexpr std::string_view gap = "  ";  // between columns

// Characters on a terminal: a µ is one, and two bytes.
std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::size_t widest(const Words& texts) {
  std::size_t out = 0;
  for (const std::string& text : texts) out = std::max(out, width_of(text));
  return out;
}

std::string padded(const std::string& text, std::size_t width, bool on_the_right) {
  const std::string blanks(width - std::min(width, width_of(text)), ' ');
  return on_the_right ? blanks + text : text + blanks;
}

// Broken at blanks into lines of `width`; a longer word has a line of its own.
Words wrapped(const std::string& text, std::size_t width) {
  Words lines(1);
  for (const std::string& word : split(text, ' '))
    if (lines.back().empty())
      lines.back() = word;
    else if (width_of(lines.back()) + 1 + width_of(word) <= width)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  return lines;
}

// With an end of line, and an ellipsis where it is too long.
std::string line_of(std::string text, std::size_t width) {
  text.resize(text.find_last_not_of(' ') + 1);
  return (width_of(text) > width ? one_line(text, width) : text) + "\n";
}

// A heading and the texts below it.
struct Shown {
  Words lines;
  bool right = false;  // numbers stand on the right
  std::size_t width;

  Shown(const std::string& heading, Words texts, bool right_ = false)
      : lines(std::move(texts)), right(right_) {
    lines.insert(lines.begin(), heading);
    width = widest(lines);
  }
  std::string at(std::size_t line) const { return padded(lines[line], width, right); }
};

std::size_t total(const std::vector<Shown>& columns) {
  std::size_t out = 0;
  for (const Shown& column : columns) out += (out ? gap.size() : 0) + column.width;
  return out;
}

// Line 0 is the headings.
std::string row_of(const std::vector<Shown>& columns, std::size_t line) {
  std::string out;
  for (std::size_t c = 0; c < columns.size(); ++c) out.append(c == 0 ? "" : gap).append(columns[c].at(line));
  return out;
}

// ---- tables for people ----

constexpr double largest_count = 1e15;  // that is shown whole
constexpr int least_place = -4;         // of a first digit that follows zeros

// Numbers of a column in its unit: counts whole, otherwise at most six significant digits, and decimals alike
// where that leaves each at least four.
class Digits {
 public:
  Digits(const Table& table, std::size_t column, double unit) {
    double least = INFINITY, largest = 0;
    for (const auto& row : table.rows) {
      const double x = std::get<double>(row[column]) / unit;
      if (!std::isfinite(x)) continue;
      whole_ = whole_ && x == std::round(x) && std::abs(x) < largest_count;
      if (x != 0) least = std::min(least, std::abs(x));
      largest = std::max(largest, std::abs(x));
    }
    if (!(largest > 0)) return;
    const auto place = [](double x) { return static_cast<int>(std::floor(std::log10(x))); };
    const int wanted = std::max(3 - place(least), 0);
    if (place(least) >= least_place && place(largest) + wanted < 6) places_ = wanted;
  }
  std::string text(double x) const {
    if (std::isnan(x)) return "-";
    if (std::isinf(x)) return x < 0 ? "-inf" : "inf";
    if (whole_) return fmt::format("{:.0f}", x + 0.0);
    if (x == 0) return "0";
    if (places_ >= 0) return fmt::format("{:.{}f}", x, places_);
    std::string text = fmt::format("{:#.5g}", x);
    if (text.ends_with('.')) text.pop_back();
    return text;
  }

 private:
  bool whole_ = true;
  int places_ = -1;
};

bool holds_words(const Table& table, std::size_t column) {
  return std::ranges::any_of(
      table.rows, [&](const auto& row) { return std::holds_alternative<std::string>(row[column]); });
}

double modulus_of(const Cell& cell) {
  const auto* number = std::get_if<double>(&cell);
  return number && std::isfinite(*number) ? std::abs(*number) : 0;
}

std::size_t place_of(const Table& table, std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(table.columns, name, &Column::name) -
                                  table.columns.begin());
}

// Of each row with a unit of its own, for its columns in "SI".
std::vector<Scale> scales_of_rows(const Table& table) {
  const std::size_t units = place_of(table, "unit");
  const auto errors = static_cast<std::size_t>(
      std::ranges::find_if(table.columns, [](const Column& c) { return c.name.ends_with("_error"); }) -
      table.columns.begin());
  std::vector<Scale> out;
  if (units == table.columns.size()) return out;
  for (const auto& row : table.rows) {
    double largest = 0;
    for (std::size_t c = 0; c < row.size(); ++c)
      if (table.columns[c].unit == "SI") largest = std::max(largest, modulus_of(row[c]));
    const double error = errors < row.size() ? std::get<double>(row[errors]) : NAN;
    out.push_back(scale_for(largest, error, std::get<std::string>(row[units])));
  }
  return out;
}

// The value whose error rounds this column: itself, or the one of this error or interval.
std::optional<std::size_t> value_with_error(const std::vector<Column>& columns, std::size_t c) {
  const auto is_error = [&](std::size_t error) {
    const Column &of = columns[error - 1], &own = columns[error];
    return own.unit == of.unit && (own.name == "standard_error" || own.name == of.name + "_error");
  };
  if (c + 1 < columns.size() && is_error(c + 1)) return c;
  while (c > 0 && (columns[c].name == "low_95" || columns[c].name == "high_95")) --c;
  return c > 0 && is_error(c) ? std::optional(c - 1) : std::nullopt;
}

// Of a number that ends where an error ends.
std::optional<Scale> scale_of_error(const Table& table, std::size_t r, std::size_t c, const Unit& unit) {
  const auto number = [&](std::size_t column) { return std::get<double>(table.rows[r][column]); };
  const std::optional<std::size_t> value = value_with_error(table.columns, c);
  if (!value || std::isnan(number(c)) || number(c) == std::round(number(c))) return std::nullopt;
  const Scale out = scale_for(number(*value), number(*value + 1), unit);
  return out.places && std::isfinite(number(*value)) ? std::optional(out) : std::nullopt;
}

Shown words_in(const Table& table, std::size_t c, const std::vector<Scale>& rows) {
  const std::string& name = table.columns[c].name;
  Words texts;
  for (std::size_t r = 0; r < table.rows.size(); ++r)
    texts.push_back(name == "unit" ? one_line(rows[r].unit.name) : text_of(table.rows[r][c]));
  return {one_line(name), std::move(texts)};
}

Shown numbers_in(const Table& table, std::size_t c, const std::vector<Scale>& rows, const Unit& unit) {
  const bool in_rows = table.columns[c].unit == "SI" && !rows.empty();
  const Digits digits(table, c, unit.factor);
  Words texts;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const double x = std::get<double>(table.rows[r][c]);
    const std::optional<Scale> scale = in_rows ? rows[r] : scale_of_error(table, r, c, unit);
    texts.push_back(scale ? scale->plain(x)
                          : (table.is_bound(r, c) ? "< " : "") + digits.text(x / unit.factor));
  }
  return {one_line(unit.label(table.columns[c].name)), std::move(texts), true};
}

// The end of the run of neighbours with the unit of this column.
std::size_t run_end(const std::vector<Column>& columns, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < columns.size() && columns[end].unit == columns[begin].unit) ++end;
  return end;
}

std::vector<Shown> columns_in(const Table& table) {
  const std::vector<Scale> rows = scales_of_rows(table);
  std::vector<Shown> out;
  for (std::size_t end = 0; out.size() < table.columns.size();) {
    const std::size_t begin = std::exchange(end, run_end(table.columns, end));
    const std::string& si = table.columns[begin].unit;
    double largest = 0;
    for (const auto& row : table.rows)
      for (std::size_t c = begin; c < end; ++c) largest = std::max(largest, modulus_of(row[c]));
    const Unit unit = si == "SI" ? Unit{} : unit_for(largest, si);
    for (std::size_t c = begin; c < end; ++c)
      out.push_back(holds_words(table, c) ? words_in(table, c, rows) : numbers_in(table, c, rows, unit));
  }
  return out;
}

// The leading columns that tell one row from another: words, and the numbers up to another unit.
std::size_t keys_of(const Table& table) {
  std::size_t words = 0;
  while (words < table.columns.size() && holds_words(table, words)) ++words;
  if (words == table.columns.size() || table.columns[words].unit == "SI") return words;
  return run_end(table.columns, words);
}

}  // namespace

std::string aligned(const Table& table, std::size_t width) {
  const std::vector<Shown> all = columns_in(table);
  std::vector<Shown> keys(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(keys_of(table)));
  if (!keys.empty() && 2 * total(keys) > width) keys.erase(keys.begin() + 1, keys.end());
  std::string out;
  for (std::size_t next = keys.size(); out.empty() || next < all.size();) {
    std::vector<Shown> columns = keys;
    do {
      if (next < all.size()) columns.push_back(all[next++]);
    } while (next < all.size() && total(columns) + gap.size() + all[next].width <= width);
    if (!out.empty()) out += "\n";
    for (std::size_t line = 0; line <= table.rows.size(); ++line)
      out += line_of(row_of(columns, line), width);
  }
  return out;
}

// ---- parameters for people ----

namespace {

constexpr std::size_t least_meaning = 20, meaning_indent = 4;

Shown column_of_values(const Words& values, const Words& errors) {
  const std::size_t width = std::max(widest(values), width_of("value"));
  Words texts;
  for (std::size_t r = 0; r < values.size(); ++r)
    texts.push_back(padded(values[r], width, true) + (errors[r].empty() ? "" : " ± " + errors[r]));
  return {padded("value", width, true) + (widest(errors) > 0 ? " ± error" : ""), std::move(texts)};
}

Shown column_of_intervals(const Words& lows, const Words& highs) {
  Words texts;
  for (std::size_t r = 0; r < lows.size(); ++r) {
    const std::string &low = lows[r], &high = highs[r];
    texts.push_back(low.empty()    ? high.empty() ? "-" : "below " + high
                    : high.empty() ? "above " + low
                                   : padded(low, widest(lows), true) + " to " + high);
  }
  return {"95 % interval", std::move(texts)};
}

// All but the meaning; without the intervals where these are unknown or have no room.
std::vector<Shown> columns_in(const Parameters& parameters, std::size_t width) {
  Words names, values, errors, lows, highs, units;
  for (const Parameter& row : parameters) {
    const Scale scale = scale_for(row.value, row.standard_error, row.unit);
    const Interval ends = row.interval_95();
    const auto shown = [&](double x, bool known) { return scale.places && known ? scale.plain(x) : ""; };
    names.push_back(one_line(row.name));
    values.push_back((row.is_bound ? "< " : "") + scale.plain(row.value));
    errors.push_back(shown(row.standard_error, true));
    lows.push_back(shown(ends.low, std::isfinite(ends.low)));
    highs.push_back(shown(ends.high, std::isfinite(ends.high)));
    units.push_back(one_line(scale.unit.name));
  }
  std::vector<Shown> out{{"quantity", names}, column_of_values(values, errors), {"unit", units}};
  std::vector<Shown> more = out;
  more.insert(more.begin() + 2, column_of_intervals(lows, highs));
  const bool known = widest(lows) + widest(highs) > 0;
  return known && total(more) <= width ? more : out;
}

}  // namespace

std::string aligned(const Parameters& parameters, std::size_t width) {
  const std::vector<Shown> columns = columns_in(parameters, width);
  const std::size_t room = width - std::min(width, total(columns) + gap.size());
  // The meaning stands in the rows, or below them where it has no room there.
  const bool in_rows = room >= least_meaning;
  const std::size_t start = in_rows ? width - room : meaning_indent,
                    most = width - std::min(width - 1, start);
  const auto line = [&](std::size_t r, const std::string& meaning) {
    std::string text = row_of(columns, r);
    return line_of(in_rows ? text.append(gap).append(meaning) : text, width);
  };
  std::string out = line(0, "meaning");
  for (std::size_t r = 0; r < parameters.size(); ++r) {
    const Words pieces = wrapped(one_line(meaning_of(parameters[r])), most);
    out += line(r + 1, pieces.front());
    for (std::size_t p = in_rows ? 1 : 0; p < pieces.size(); ++p)
      if (!pieces[p].empty()) out += line_of(std::string(start, ' ') + pieces[p], width);
  }
  return out;
}

}  // namespace asperity::cli
