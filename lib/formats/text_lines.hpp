/// The lines of a text, read in one dialect: with one separator and one meaning of commas.
///
/// A line ends with LF, CR LF or CR and has cells. Separators are blanks (any run of blanks and tabs), or a
/// tab, comma or semicolon, each of which ends one cell; an empty cell is a missing point. A cell that begins
/// with a double quote ends at the next one, and separators in it separate nothing. If every line ends with a
/// separator, there is no cell after it. A comment begins with # or %, or with ; if it is not the separator,
/// unless its first cell is a missing point.
///
/// Where words may stand above the numbers (Asked::head), the numbers begin with the first line in which
/// every cell is a number or empty and at least one is a number; from there on, a cell that is neither is a
/// fault. The lines above are kept, comments too. Among the numbers, a comment with a number in every other
/// column is a fault, unless what follows its mark is a number, too: that was taken out on purpose.
///
/// Several maps in one file are blocks of lines. An empty line parts them, or a comment like the head of a
/// block: its first word is that of a comment above all numbers, or block, channel, data, frame, image, layer
/// or map. If no two lines stand together, all are lines of one map.
///
/// Cost      one pass; memory for one double per number.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/map.hpp"
#include "formats/text_numbers.hpp"

namespace asperity {

/// One way to read a text.
struct Dialect {
  Separator separator;
  Comma comma;
  bool quotes = false;  ///< the text has double quotes
};

/// What a text must hold, in any dialect.
struct Asked {
  std::size_t first_line;      ///< number of the first line
  std::optional<Shape> shape;  ///< of all numbers, with any line breaks; unknown for a matrix
  std::string variable;        ///< named in refusals
  MemoryBound memory;
  bool head = false;                      ///< lines of words may stand above the numbers
  std::vector<std::string> missing = {};  ///< further words of missing points
};

struct Fault {
  std::size_t line;
  const char* at;  ///< in the text
  std::string what;
  bool doubtful = false;  ///< a comment that may be a line of the table
};

/// A line above the numbers; comments keep their mark.
struct HeadLine {
  std::size_t number;
  std::string_view text;
};

struct Table {
  Dialect dialect;
  std::vector<double> values = {};       ///< line by line
  Index lines = 0, columns = 0;          ///< columns of the first line
  bool holes = false;                    ///< a cell is empty
  bool proved = false;                   ///< a number shows marks between thousands: "1.234,5"
  bool contradicted = false;             ///< a number has none where they would stand: "1512.5"
  bool spaced = false;                   ///< a blank between tabs stands between thousands: "1 234,5"
  std::string mixed = {};                ///< "1.234" in a column with "481": a decimal mark, or thousands
  std::size_t next_block = 0;            ///< line of the numbers of a second block
  std::string parted_by = {};            ///< what stands above it
  std::vector<std::string> unseen = {};  ///< words of missing points that no cell has
  std::vector<HeadLine> head = {};       ///< all lines above the numbers
  Index words = 0;                       ///< the same, without comments
  std::size_t first_line = 0;            ///< of the numbers
  std::optional<Fault> fault = {};       ///< of the first line that does not fit the dialect

  Eigen::Map<const Field> field() const { return {values.data(), lines, columns}; }
};

/// The character of a separator other than blanks.
char character_of(Separator separator);
/// The cells of a line, without blanks and quotes around them.
std::vector<std::string_view> cells_of(std::string_view line, Dialect dialect);
/// Three or more # are a missing point only next to a number, % alone only before one.
bool is_comment(std::string_view line, Separator separator, const std::vector<std::string>& missing = {});
/// All lines of a text, numbered from 1.
std::vector<HeadLine> numbered_lines(std::string_view text);

Table read_table(std::string_view text, Dialect dialect, const Asked& asked);

}  // namespace asperity
