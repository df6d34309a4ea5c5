#include "tools/cli/aligned.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "tools/cli/layout.hpp"
#include "tools/cli/readable.hpp"

namespace asperity::cli {
namespace {

constexpr std::size_t least_meaning = 20, meaning_indent = 4;
constexpr double largest_count = 1e15;  // that is shown whole
constexpr int least_place = -4;         // of a first digit that follows zeros

// As it can be copied and read back: an ASCII minus, e-3 for a power of ten.
std::string plain(std::string text) {
  for (const auto& [from, to] :
       {std::pair<std::string_view, const char*>{"−", "-"}, {"–", "-"}, {"∞", "inf"}})
    if (const std::size_t at = text.find(from); at != text.npos) text.replace(at, from.size(), to);
  return text;
}

std::string number_in(const Scale& scale, double value) {
  const std::string text = plain(scale.text(value));
  const bool bare = scale.exponent == 0 || !std::isfinite(value) || value == 0;
  return bare ? text : fmt::format("{}e{}", text, scale.exponent);
}

// ---- the columns of a general table ----

// Numbers of a column in its unit: counts whole, otherwise at most six significant digits, and decimals alike
// where that leaves each at least four.
class Digits {
 public:
  explicit Digits(const std::vector<double>& numbers) {
    double least = INFINITY, largest = 0;
    for (const double x : numbers) {
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

double modulus_of(const Cell& cell) {
  const auto* number = std::get_if<double>(&cell);
  return number && std::isfinite(*number) ? std::abs(*number) : 0;
}

double largest_in(const Table& table, std::size_t column) {
  double out = 0;
  for (const auto& row : table.rows) out = std::max(out, modulus_of(row[column]));
  return out;
}

// The end of the run of neighbours with the unit of this column.
std::size_t run_end(const std::vector<Column>& columns, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < columns.size() && columns[end].unit == columns[begin].unit) ++end;
  return end;
}

bool holds_words(const Table& table, std::size_t column) {
  return std::ranges::any_of(
      table.rows, [&](const auto& row) { return std::holds_alternative<std::string>(row[column]); });
}

Shown words_in(const Table& table, std::size_t column) {
  Shown out{one_line(table.columns[column].name), {}, Side::left};
  const bool units = table.columns[column].name == "unit";
  for (const auto& row : table.rows) {
    const auto* words = std::get_if<std::string>(&row[column]);
    const std::string text = words ? one_line(*words) : shortest(std::get<double>(row[column]));
    out.texts.push_back(units && text == "1" ? "" : text);
  }
  return out;
}

Shown numbers_in(const Table& table, std::size_t column, const Unit& unit) {
  std::vector<double> numbers;
  for (const auto& row : table.rows) numbers.push_back(std::get<double>(row[column]) / unit.factor);
  const Digits digits(numbers);
  Shown out{one_line(unit.label(table.columns[column].name)), {}, Side::right};
  for (std::size_t r = 0; r < numbers.size(); ++r)
    out.texts.push_back((table.is_bound(r, column) ? "< " : "") + digits.text(numbers[r]));
  return out;
}

// ---- values beside their errors ----

bool is_error_of(const Column& value, const Column& error) {
  return error.unit == value.unit && (error.name == "standard_error" || error.name == value.name + "_error");
}

// The value, its error and its interval end at the second digit of the error, where that is known.
void round_to_error(const Table& table, std::size_t column, const Unit& unit, std::vector<Shown>& shown) {
  std::size_t end = column + 2;
  while (end < shown.size() && (table.columns[end].name == "low_95" || table.columns[end].name == "high_95"))
    ++end;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const auto number = [&](std::size_t c) { return std::get<double>(table.rows[r][c]); };
    const Scale scale = scale_for(number(column), number(column + 1), unit);
    if (!scale.places || !std::isfinite(number(column))) continue;
    for (std::size_t c = column; c < end; ++c)
      if (!std::isnan(number(c)) && number(c) != std::round(number(c)))
        shown[c].texts[r] = number_in(scale, number(c));
  }
}

// ---- rows with units of their own ----

std::size_t place_of(const Table& table, std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(table.columns, name, &Column::name) -
                                  table.columns.begin());
}

// Of the columns in "SI" and the units, row by row.
void scale_rows(const Table& table, std::vector<Shown>& shown) {
  const std::size_t units = place_of(table, "unit"), errors = place_of(table, "standard_error");
  if (units == table.columns.size()) return;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const auto& row = table.rows[r];
    double largest = 0;
    for (std::size_t c = 0; c < row.size(); ++c)
      if (table.columns[c].unit == "SI") largest = std::max(largest, modulus_of(row[c]));
    const double error = errors < row.size() ? std::get<double>(row[errors]) : NAN;
    const Scale scale = scale_for(largest, error, std::get<std::string>(row[units]));
    shown[units].texts[r] = one_line(scale.unit.name);
    for (std::size_t c = 0; c < row.size(); ++c)
      if (table.columns[c].unit == "SI") shown[c].texts[r] = number_in(scale, std::get<double>(row[c]));
  }
}

std::vector<Shown> columns_in(const Table& table) {
  std::vector<Shown> out;
  for (std::size_t begin = 0; begin < table.columns.size();) {
    const std::size_t end = run_end(table.columns, begin);
    double largest = 0;
    for (std::size_t c = begin; c < end; ++c) largest = std::max(largest, largest_in(table, c));
    const std::string& si = table.columns[begin].unit;
    const Unit unit = si == "SI" ? Unit{} : unit_for(largest, si);
    for (std::size_t c = begin; c < end; ++c)
      out.push_back(holds_words(table, c) ? words_in(table, c) : numbers_in(table, c, unit));
    for (std::size_t c = begin; c + 1 < end; ++c)
      if (si != "SI" && !holds_words(table, c) && is_error_of(table.columns[c], table.columns[c + 1]))
        round_to_error(table, c, unit, out);
    begin = end;
  }
  scale_rows(table, out);
  for (Shown& column : out) column.measure();
  return out;
}

// ---- layout ----

// The leading columns that tell one row from another: words, and the numbers up to another unit.
std::size_t keys_of(const Table& table) {
  std::size_t words = 0;
  while (words < table.columns.size() && holds_words(table, words)) ++words;
  if (words == table.columns.size() || table.columns[words].unit == "SI") return words;
  return run_end(table.columns, words);
}

// ---- parameters ----

// "value ± error" and the 95 % interval, each with its parts one below the other.
struct Readings {
  Words values, errors, lows, highs, intervals, units, names;

  void add(const Parameter& row) {
    const Measurement m = readable(row);
    const Interval ends = row.interval_95();
    names.push_back(one_line(row.name));
    values.push_back((row.is_bound ? "< " : "") + number_in(m.scale, row.value));
    units.push_back(one_line(m.scale.unit.name));
    const bool known = !m.error.empty(), below = known && std::isfinite(ends.low),
               above = known && std::isfinite(ends.high);
    errors.push_back(known ? number_in(m.scale, row.standard_error) : "");
    lows.push_back(below ? number_in(m.scale, ends.low) : "");
    highs.push_back(above ? number_in(m.scale, ends.high) : "");
  }
  Shown value_column() const {
    const bool any = widest(errors) > 0;
    const std::size_t width = std::max(widest(values), width_of("value"));
    Shown out{padded("value", width, Side::right) + (any ? " ± error" : ""), {}, Side::left};
    for (std::size_t r = 0; r < values.size(); ++r)
      out.texts.push_back(padded(values[r], width, Side::right) +
                          (errors[r].empty() ? "" : " ± " + errors[r]));
    return out;
  }
  Shown interval_column() const {
    Shown out{"95 % interval", {}, Side::left};
    const std::size_t width = widest(lows);
    for (std::size_t r = 0; r < lows.size(); ++r) {
      const std::string &low = lows[r], &high = highs[r];
      out.texts.push_back(low.empty()    ? high.empty() ? "-" : "below " + high
                          : high.empty() ? "above " + low
                                         : padded(low, width, Side::right) + " to " + high);
    }
    return out;
  }
};

std::string meaning_of(const Parameter& row) {
  const std::string note = row.note();
  return one_line(note.empty() ? row.meaning : row.meaning + "; " + note);
}

}  // namespace

std::string aligned(const Table& table, std::size_t width) {
  const std::vector<Shown> all = columns_in(table);
  std::vector<Shown> keys(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(keys_of(table)));
  if (2 * total(keys) > width) keys.resize(std::min<std::size_t>(keys.size(), 1));
  std::string out;
  for (std::size_t next = keys.size(); out.empty() || next < all.size();) {
    std::vector<Shown> columns = keys;
    do {
      if (next < all.size()) columns.push_back(all[next++]);
    } while (next < all.size() && total(columns) + gap_width + all[next].width <= width);
    out += (out.empty() ? "" : "\n") + block(columns, table.rows.size(), width);
  }
  return out;
}

std::string aligned(const Parameters& parameters, std::size_t width) {
  Readings read;
  for (const Parameter& row : parameters) read.add(row);
  std::vector<Shown> columns{{"quantity", read.names}, read.value_column()};
  if (widest(read.lows) + widest(read.highs) > 0) columns.push_back(read.interval_column());
  columns.push_back({"unit", read.units});
  for (Shown& column : columns) column.measure();
  if (total(columns) > width && columns.size() == 4) columns.erase(columns.begin() + 2);
  const std::size_t room = width - std::min(width, total(columns) + gap_width);
  const bool beside = room >= least_meaning;
  const std::size_t start = beside ? width - room : meaning_indent, most = width - std::min(width - 1, start);
  const std::string heads = row_of(columns, 0);
  std::string out = line_of(beside ? heads + gap + "meaning" : heads, width);
  for (std::size_t r = 0; r < parameters.size(); ++r) {
    std::string text = row_of(columns, r + 1) + gap;
    for (const std::string& piece : wrapped(meaning_of(parameters[r]), most)) {
      if (!beside || text.empty()) {
        if (!text.empty()) out += line_of(text, width);
        text = std::string(start, ' ');
      }
      if (!piece.empty() || beside) out += line_of(text + piece, width);
      text.clear();
    }
  }
  return out;
}

}  // namespace asperity::cli
