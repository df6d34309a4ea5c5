/// The lines of a text, read in one way: with one separator and one meaning of commas.
///
/// A line has cells (formats/text_cells.hpp). Where words may stand above the numbers (Asked::head), the
/// numbers begin with the first line in which every cell is a number or empty and at least one is a number;
/// from there on, a cell that is neither is a fault. The lines above are kept, comments too. Among the
/// numbers, a comment with a number in every other column is a fault, unless its first cell is a number
/// behind the mark.
///
/// Cost      one pass; memory for one double per number.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/map.hpp"
#include "formats/text_cells.hpp"
#include "formats/text_numbers.hpp"

namespace asperity {

/// One way to read a text.
struct Dialect {
  Separator separator;
  Comma comma;
};

struct Fault {
  std::size_t line;
  const char* at;  ///< in the text
  std::string what;
};

/// What a text must hold, for any dialect.
struct Asked {
  std::size_t first_line;      ///< number of the first line
  std::optional<Shape> shape;  ///< of all numbers, with any line breaks; unknown for a matrix
  std::string variable;        ///< named in refusals
  MemoryBound memory;
  bool head = false;                      ///< lines of words may stand above the numbers
  bool quotes = false;                    ///< the text has double quotes
  std::vector<std::string> missing = {};  ///< further words of missing points
};

/// A line above the numbers; comments keep their mark.
struct HeadLine {
  std::size_t number;
  std::string_view text;
};

struct Table {
  Dialect dialect;
  std::vector<double> values;            ///< line by line
  Index lines = 0, columns = 0;          ///< columns of the first line
  bool holes = false;                    ///< a cell is empty
  bool proved = false;                   ///< a number shows marks between thousands: "1.234,5"
  bool contradicted = false;             ///< a number has none where they would stand: "1512.5"
  std::string mixed = {};                ///< "1.234" in a column with "481": a decimal mark, or thousands
  bool spaced = false;                   ///< a blank between tabs stands between thousands: "1 234,5"
  std::size_t next_block = 0;            ///< line of the numbers of a second block (formats/text_blocks.hpp)
  std::string parted_by = {};            ///< what stands above it
  std::vector<std::string> unseen = {};  ///< words of missing points that no cell has
  std::vector<HeadLine> head = {};       ///< all of them
  std::size_t head_lines = 0;            ///< all of them, without comments
  std::size_t first_line = 0;            ///< of the numbers
  const char* begins = nullptr;          ///< the same in the text
  std::optional<Fault> fault = {};       ///< of the first line that does not fit the dialect
  bool doubtful = false;                 ///< the fault is a comment that may be a line of the table
};

/// More lines above the numbers are a fault.
inline constexpr std::size_t most_head_lines = 65536;

Table read_table(std::string_view text, Dialect dialect, const Asked& asked);

}  // namespace asperity
