#include "formats/text_table.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

#include "formats/raster.hpp"
#include "formats/refuse.hpp"
#include "formats/text_numbers.hpp"

namespace asperity {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";

// One way to read a text.
struct Dialect {
  Separator separator;
  Comma comma;
};

struct Fault {
  std::size_t line;
  const char* at;  // in the text
  std::string what;
};

// What a text must hold, for any dialect.
struct Asked {
  std::size_t first_line;      // number of the first line
  std::optional<Shape> shape;  // of all numbers, with any line breaks; unknown for a matrix
  std::string variable;        // named in refusals
  MemoryBound memory;
};

struct Table {
  Dialect dialect;
  std::vector<double> values;
  Index lines = 0, columns = 0;  // columns of the first line
  std::optional<Fault> fault;    // of the first line that does not fit the dialect
};

char character_of(Separator separator) {
  return separator == Separator::tab ? '\t' : separator == Separator::comma ? ',' : ';';
}

// The next cell, removed from the line; after the last cell the line is null.
std::string_view take_cell(std::string_view& line, Separator separator) {
  const bool word = separator == Separator::blank;
  const std::size_t end = word ? line.find_first_of(blanks) : line.find(character_of(separator));
  const std::string_view cell = trimmed(line.substr(0, end));
  line = end == line.npos ? std::string_view() : line.substr(end + 1);
  if (word && line.data() != nullptr)
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  return cell;
}

// The part of a line with cells; empty for a comment.
std::string_view content_of(std::string_view line, Separator separator) {
  const std::string_view content = trimmed(line);
  const bool comment = content.starts_with('#') || content.starts_with('%') ||
                       (content.starts_with(';') && separator != Separator::semicolon);
  if (comment) return {};
  return separator == Separator::tab && line.find('\t') != line.npos ? line : content;
}

std::string fault_of(std::string_view cell, bool first) {
  const std::string what = quoted(cell) + " is not a number";
  const auto letter = [](unsigned char c) { return std::isalpha(c) != 0; };
  if (cell.find(',') != cell.npos && cell.find('.') != cell.npos)
    return what + ": remove thousands separators";
  if (first && std::ranges::any_of(cell.substr(0, 1), letter)) return what + ": begin lines of words with #";
  return what;
}

class TableReader {
 public:
  TableReader(std::string_view text, Dialect dialect, const Asked& asked)
      : rest_(text),
        table_{.dialect = dialect, .values = {}, .fault = {}},
        asked_(asked),
        line_(asked.first_line),
        most_(asked.memory.most_points()) {}

  Table read() {
    for (; !rest_.empty() && !table_.fault; ++line_) {
      const std::string_view line = take_line(rest_), content = content_of(line, table_.dialect.separator);
      if (!content.empty()) add(content);
    }
    if (!table_.fault) finish();
    if (table_.fault) table_.values = {};
    return std::move(table_);
  }

 private:
  // Room for all lines if they are as long as the first; address space only, until it is filled.
  void reserve() {
    const auto ends = [&](char end) { return static_cast<std::size_t>(std::ranges::count(rest_, end)); };
    const std::size_t columns = table_.values.size(), lines = 2 + std::max(ends('\n'), ends('\r'));
    const std::size_t most = columns + rest_.size();  // numbers of at least one byte each
    table_.values.reserve(lines > most / columns ? most : lines * columns);
  }

  void fail(const char* at, const std::string& what) { table_.fault = Fault{line_, at, what}; }
  std::string here() const { return "line " + std::to_string(line_); }

  void add(std::string_view line) {
    const std::size_t before = table_.values.size();
    std::string_view cell, rest = line;
    while (rest.data() != nullptr && !table_.fault)
      add_cell(cell = take_cell(rest, table_.dialect.separator));
    if (table_.fault) return;
    trailing_ = trailing_ && cell.empty();
    if (asked_.shape && cell.empty()) table_.values.pop_back();
    const auto count = static_cast<Index>(table_.values.size() - before);
    if (table_.lines++ == 0) {
      table_.columns = count;
      if (count > 0) reserve();
    }
    if (!asked_.shape && count != table_.columns)
      fail(line.data(),
           fmt::format("{} has {}, the first line {}", here(), counted(count, "number"), table_.columns));
  }

  void add_cell(std::string_view cell) {
    const auto value = cell.empty() ? std::optional(Map::unknown) : number_of(cell, table_.dialect.comma);
    if (!value)
      fail(cell.data(), here() + ": " + fault_of(cell, table_.values.empty()));
    else if (std::isinf(*value))
      fail(cell.data(), fmt::format("{}: {} is infinite", here(), quoted(cell)));
    else
      push(*value);
  }

  // The memory is that of the table expected from the first line.
  void push(double value) {
    table_.values.push_back(value);
    if (table_.values.size() > most_)
      asked_.memory.require_map(static_cast<double>(table_.values.capacity()), asked_.variable);
  }

  void finish() {
    const std::size_t numbers = table_.values.size();
    if (table_.lines == 0) return fail(rest_.data(), "the file has no numbers");
    if (asked_.shape && numbers != static_cast<std::size_t>(asked_.shape->cells()))
      return fail(rest_.data(), fmt::format("the file has {}, its header gives {} x {}",
                                            counted(static_cast<Index>(numbers), "number"), asked_.shape->nx,
                                            asked_.shape->ny));
    if (trailing_ && !asked_.shape && table_.columns > 1) remove_last_column();
  }

  void remove_last_column() {
    const auto columns = static_cast<std::size_t>(table_.columns--);
    std::size_t place = 0;
    std::erase_if(table_.values, [&](double) { return ++place % columns == 0; });
  }

  std::string_view rest_;
  Table table_;
  Asked asked_;
  bool trailing_ = true;     // every line so far ended with an empty cell
  std::size_t line_, most_;  // most_: numbers
};

// The dialects that neither the user nor the characters of the text exclude.
std::vector<Dialect> dialects_of(std::string_view text, const Reading& reading) {
  const bool commas = text.find(',') != text.npos;
  std::vector<Dialect> out;
  for (Separator s : {Separator::semicolon, Separator::tab, Separator::comma, Separator::blank})
    for (Comma c : {Comma::none, Comma::decimal, Comma::thousands}) {
      const bool asked = reading.separator == s, decimal = c == Comma::decimal;
      if (reading.separator != Separator::any && !asked) continue;
      if (reading.decimal != DecimalMark::any &&
          (decimal != (reading.decimal == DecimalMark::comma) || c == Comma::thousands))
        continue;
      if (s == Separator::comma && c != Comma::none) continue;
      if (c == Comma::thousands && !commas) continue;
      if (decimal && !commas && reading.decimal == DecimalMark::any) continue;
      if (!asked && s != Separator::blank && text.find(character_of(s)) == text.npos) continue;
      out.push_back({s, c});
    }
  if (out.empty()) throw ParameterError("decimal", "a comma cannot be both decimal mark and separator");
  return out;
}

Eigen::Map<const Field> lines_of(const Table& table) {
  return {table.values.data(), table.lines, table.columns};
}

bool same(const Table& a, const Table& b) {
  const auto equal = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  return a.columns == b.columns && std::ranges::equal(a.values, b.values, equal);
}

// Tabs used only for alignment would leave a column empty if each of them ended a cell.
bool tabs_decide(const Table& a, const Table& b) {
  const bool tabs = a.dialect.separator == Separator::tab && b.dialect.separator == Separator::blank &&
                    a.dialect.comma == b.dialect.comma;
  if (!tabs || static_cast<Index>(a.values.size()) != a.lines * a.columns) return false;
  return !lines_of(a).isNaN().colwise().all().any();
}

std::string words_of(const Table& table) {
  constexpr std::string_view separators[] = {"", "blanks", "tabs", "commas", "semicolons"};
  constexpr std::string_view commas[] = {"", " and decimal commas", " and commas between thousands"};
  return fmt::format("{}, {} per line, separated by {}{}",
                     counted(static_cast<Index>(table.values.size()), "number"), table.columns,
                     separators[static_cast<std::size_t>(table.dialect.separator)],
                     commas[static_cast<std::size_t>(table.dialect.comma)]);
}

// Whether a table's fault is further on in the text.
bool further(const Table& a, const std::optional<Table>& b) {
  if (!b || a.fault->line != b->fault->line) return !b || a.fault->line > b->fault->line;
  return a.dialect.separator == b->dialect.separator && a.fault->at > b->fault->at;
}

std::string_view without_mark(std::string_view text, const std::string& variable) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    throw DataError(variable, "the text is in UTF-16: save it as UTF-8");
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  return text;
}

// The text with semicolons for commas next to a blank, if other commas have no blank: these may be decimal
// marks, as in "1,5, 2,5". Nothing if all commas are alike.
std::string commas_apart(std::string_view text) {
  const auto blank = [&](std::size_t i) { return i < text.size() && text[i] == ' '; };
  const auto beside = [&](std::size_t comma) { return blank(comma + 1) || (comma > 0 && blank(comma - 1)); };
  const auto next = [&](std::size_t from) { return text.find(',', from); };
  std::array<bool, 2> seen{};
  for (std::size_t i = next(0); i != text.npos && !(seen[0] && seen[1]); i = next(i + 1))
    seen[beside(i)] = true;
  if (!(seen[0] && seen[1])) return {};
  std::string out(text);
  for (std::size_t i = next(0); i != text.npos; i = next(i + 1))
    if (beside(i)) out[i] = ';';
  return out;
}

Table table_of(std::string_view text, const Asked& asked, const Reading& reading) {
  const std::string& variable = asked.variable;
  text = without_mark(text, variable);
  std::optional<Table> found, refused;
  for (const Dialect dialect : dialects_of(text, reading)) {
    Table table = TableReader(text, dialect, asked).read();
    if (table.fault) {
      if (further(table, refused)) refused = std::move(table);
    } else if (!found) {
      found = std::move(table);
    } else if (!same(*found, table) && !tabs_decide(*found, table)) {
      throw DataError(variable, fmt::format("the text is ambiguous: {}; or {}: give asperity-convert the "
                                            "`separator` or the `decimal` mark",
                                            words_of(*found), words_of(table)));
    }
  }
  if (!found) throw DataError(variable, refused->fault->what);
  const bool told = reading.separator != Separator::any || reading.decimal != DecimalMark::any;
  if (found->dialect.separator != Separator::comma || told) return *std::move(found);
  const std::string apart = commas_apart(text);
  if (!apart.empty() && !TableReader(apart, {Separator::semicolon, Comma::decimal}, asked).read().fault)
    throw DataError(variable, "the text is ambiguous: " + words_of(*found) +
                                  "; or separated by comma and blank, with decimal commas: tell "
                                  "asperity-convert that the comma is the separator, or write semicolons");
  return *std::move(found);
}

}  // namespace

Field matrix_of(std::string_view text, const std::string& variable, std::size_t first_line,
                const Reading& reading) {
  return lines_of(table_of(text, {first_line, {}, variable, reading.memory}, reading));
}

Field field_of_lines(std::string_view text, Shape shape, std::size_t first_line, const Reading& reading) {
  check_shape(shape, text.size() + 1);
  reading.memory.require_map(shape, "map");
  const Table table = table_of(text, {first_line, shape, "map", reading.memory}, reading);
  return Eigen::Map<const Field>(table.values.data(), shape.ny, shape.nx).transpose();
}

}  // namespace asperity
