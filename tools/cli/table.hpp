/// Tables on stdout: aligned on a terminal, tab-separated with a # header line in a pipe, or one JSON object.
///
/// Numbers are printed in the shortest form that reads back to the same double, in the C locale; nan is what is not known,
/// and an infinite end of an interval is open. Words from files are fit for a line (core/words.hpp); in JSON they are
/// whole, escaped, and UTF-8.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/words.hpp"
#include "stats/measure/parameter.hpp"

namespace asperity::cli {

class Tool;

using asperity::shortest;

using Cell = std::variant<std::string, double>;

/// What numbers a column may hold beside finite ones: none, NaN for what is not known, or infinities too, as open
/// intervals have.
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

  std::string tsv() const;      ///< "# name [unit]\t…" and one line a row
  std::string aligned() const;  ///< for eyes
  /// {"columns": {"name": {"unit": …, "values": […]}}}
  std::string json() const;
};

/// A table of named quantities, one a row, which as JSON is {"name": {"value": …, "unit": …, "standard_error": …,
/// "interval_95": [low, high], "note": …}}.
struct Quantities {
  using Row = Parameter;
  std::vector<Row> rows;

  Table table() const;
  std::string json() const;
};

/// Throws DataError(name, …) for a number that its column does not hold, and for a quantity that is infinite.
void check_finite(const Table& table);
void check_finite(const Quantities& quantities);

/// To --output, as --json and a terminal ask for it, after check_finite().
void print(const Tool& tool, const Table& table);
void print(const Tool& tool, const Quantities& quantities);

}  // namespace asperity::cli
