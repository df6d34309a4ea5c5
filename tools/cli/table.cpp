#include "tools/cli/table.hpp"

#include <algorithm>
#include <cmath>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "tools/cli/output_name.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string heading(const Column& column) {
  return one_line(column.unit.empty() ? column.name : column.name + " [" + column.unit + "]");
}

// JSON has no infinities: what is not finite is null.
Json json_of(const Cell& cell) {
  if (const auto* words = std::get_if<std::string>(&cell)) return utf8_of(*words);
  const double number = std::get<double>(cell);
  return std::isfinite(number) ? Json(number) : Json(nullptr);
}

constexpr std::size_t widest_table = 1000;  // line of a text

[[noreturn]] void refuse_result(const std::string& name, double number) {
  throw DataError(name, std::string("the result is ") + (std::isnan(number) ? "not a number" : "infinite") +
                            ": the parameters exceed double precision");
}

std::string as_json(const Table& table) { return table.json(); }
std::string as_json(const Parameters& parameters) { return cli::json_of(parameters); }

// The object with what the run warned of.
std::string with_warnings(const std::string& text, const std::vector<std::string>& warnings) {
  if (warnings.empty()) return text;
  Json object = Json::parse(text);
  for (const std::string& line : warnings) object["warnings"].push_back(utf8_of(line));
  return object.dump(2) + "\n";
}

std::string as_tsv(const Table& table) { return table.tsv(); }
std::string as_tsv(const Parameters& parameters) { return table_of(parameters).tsv(); }

template <class Rows>
void put(const Tool& tool, const Rows& rows) {
  check_finite(rows);
  check_table_name(tool.output_name(), tool.json());
  tool.write_text(tool.json()                 ? with_warnings(as_json(rows), tool.warnings())
                  : tool.table_is_text()
                      ? aligned(rows, tool.output_is_terminal() ? columns_of(STDOUT_FILENO, widest_table)
                                                                : widest_table)
                      : as_tsv(rows));
}

}  // namespace

std::string text_of(const Cell& cell) {
  if (const auto* words = std::get_if<std::string>(&cell)) return one_line(*words);
  return shortest(std::get<double>(cell));
}

std::string meaning_of(const Parameter& row) {
  const std::string note = row.note();
  return note.empty() ? row.meaning : row.meaning + "; " + note;
}

std::string Table::tsv() const {
  std::string out = "#";
  for (const Column& column : columns) out += (out == "#" ? " " : "\t") + heading(column);
  out += '\n';
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < columns.size(); ++c)
      out += (is_bound(r, c) ? "<" : "") + text_of(rows[r][c]) + (c + 1 < columns.size() ? "\t" : "\n");
  return out;
}

std::string Table::json() const {
  Json object = Json::object();
  for (std::size_t c = 0; c < columns.size(); ++c) {
    Json values = Json::array();
    for (const auto& row : rows) values.push_back(json_of(row[c]));
    Json& column = object[utf8_of(columns[c].name)];
    column = {{"unit", utf8_of(columns[c].unit)}, {"values", std::move(values)}};
    if (std::ranges::any_of(bounds, [c](const auto& at) { return at[1] == c; }))
      for (std::size_t r = 0; r < rows.size(); ++r) column["bounds"].push_back(is_bound(r, c));
  }
  return object.dump(2) + "\n";
}

Table table_of(const Parameters& parameters) {
  Table out{{{"quantity", ""},
             {"value", "SI", Holds::unknown},
             {"standard_error", "SI", Holds::unknown},
             {"low_95", "SI", Holds::open},
             {"high_95", "SI", Holds::open},
             {"unit", ""},
             {"meaning", ""}},
            {}};
  for (const Parameter& row : parameters) {
    const Interval ends = row.interval_95();
    const double error = std::isfinite(row.standard_error) ? row.standard_error : NAN;
    if (row.is_bound) out.bounds.insert({out.rows.size(), 1});
    out.rows.push_back({row.name, row.value, error, ends.low, ends.high, row.unit, meaning_of(row)});
  }
  return out;
}

std::string json_of(const Parameters& parameters) {
  Json object = Json::object();
  for (const Parameter& row : parameters) {
    Json entry{{"value", json_of(row.value)}, {"unit", utf8_of(row.unit)}};
    const Interval ends = row.interval_95();
    if (row.is_bound) entry["bound"] = true;
    if (std::isfinite(row.standard_error)) entry["standard_error"] = row.standard_error;
    if (ends.known()) entry["interval_95"] = {json_of(ends.low), json_of(ends.high)};
    entry["meaning"] = utf8_of(row.meaning);
    if (const std::string note = row.note(); !note.empty()) entry["note"] = utf8_of(note);
    object[utf8_of(row.name)] = std::move(entry);
  }
  return object.dump(2) + "\n";
}

void check_finite(const Parameters& parameters) {
  for (const Parameter& row : parameters)
    if (std::isinf(row.value)) refuse_result(row.name, row.value);
}

void check_finite(const Table& table) {
  for (const auto& row : table.rows)
    for (std::size_t c = 0; c < row.size(); ++c) {
      const auto* number = std::get_if<double>(&row[c]);
      const Holds holds = table.columns[c].holds;
      if (number == nullptr || std::isfinite(*number) || holds == Holds::open) continue;
      if (std::isinf(*number) || holds == Holds::known) refuse_result(table.columns[c].name, *number);
    }
}

void print(const Tool& tool, const Table& table) { put(tool, table); }
void print(const Tool& tool, const Parameters& parameters) { put(tool, parameters); }

}  // namespace asperity::cli
