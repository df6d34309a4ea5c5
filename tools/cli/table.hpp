/// Tables on stdout: aligned on a terminal, tab-separated with a # header line in a pipe, or one JSON object.
///
/// On a terminal numbers are rounded, in units with a prefix (cli/readable.hpp). Neighbouring columns of one
/// unit share a prefix, chosen by their largest modulus; columns in "SI" have the unit of their row. A value
/// with its error in the next column, "standard_error" or its name and "_error", ends with the second digit
/// of the error, and so does its interval. No line is longer than the terminal is wide: meanings are wrapped,
/// and a table with too many columns continues below with its first columns repeated.
///
/// In a pipe numbers have the shortest form that reads back to the same double; nan is an unknown value, an
/// infinite end of an interval is open, and "<" precedes a bound. Words from files are fit for a line
/// (core/words.hpp); in JSON they are whole.
#pragma once

#include <array>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "core/words.hpp"
#include "stats/measure/parameter.hpp"

namespace asperity::cli {

class Tool;

using asperity::shortest;

using Cell = std::variant<std::string, double>;
std::string text_of(const Cell& cell);

/// What else than finite numbers a column may hold: nothing, NaN for what is not known, or infinities too.
enum class Holds { known, unknown, open };

struct Column {
  std::string name;
  std::string unit;  ///< "" for words, "1" for pure numbers
  Holds holds = Holds::known;
};

/// Rows under named columns with units.
struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
  std::set<std::array<std::size_t, 2>> bounds = {};  ///< row and column of numbers that are bounds

  bool is_bound(std::size_t row, std::size_t column) const { return bounds.contains({row, column}); }
  std::string tsv() const;  ///< "# name [unit]\t…" and one line a row
  /// {"name": {"unit": …, "values": […]}}, with "bounds": [true, …] where some are
  std::string json() const;
};

/// With what the note says.
std::string meaning_of(const Parameter& row);
/// Parameters, one a row; as JSON {"name": {"value": …, "unit": …, "standard_error": …, "interval_95": [low,
/// high], "note": …}}, and "bound": true of a value that the quantity is below.
Table table_of(const Parameters& parameters);
std::string json_of(const Parameters& parameters);

/// For a terminal of `width` columns.
std::string aligned(const Table& table, std::size_t width);
/// Columns quantity, value ± error, 95 % interval, unit, meaning.
std::string aligned(const Parameters& parameters, std::size_t width);

/// Throws DataError(name, …) for what a column does not hold, and for a parameter that is infinite.
void check_finite(const Table& table);
void check_finite(const Parameters& parameters);

/// To --output after check_finite(): one JSON object as asked, else aligned on a terminal, else TSV.
void print(const Tool& tool, const Table& table);
void print(const Tool& tool, const Parameters& parameters);

}  // namespace asperity::cli
