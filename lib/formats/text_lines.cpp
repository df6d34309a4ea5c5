#include "formats/text_lines.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "formats/refuse.hpp"
#include "formats/text_blocks.hpp"

namespace asperity {
namespace {

std::string fault_of(std::string_view cell, bool map) {
  const std::string what = quoted(cell) + " is not a number";
  const auto digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  if (cell.find(',') != cell.npos && cell.find('.') != cell.npos)
    return what + ": remove thousands separators";
  if (std::ranges::any_of(cell, digit)) return what;
  return what + ": begin lines of words with #" +
         (map ? ", or tell asperity-convert if it means a missing point (`missing`)" : "");
}

constexpr std::size_t longest_grouped = 64;  // of a number with blanks between thousands, in bytes

class TableReader {
 public:
  TableReader(std::string_view text, Dialect dialect, const Asked& asked)
      : rest_(text), asked_(asked), line_(asked.first_line), most_(asked.memory.most_points()) {
    table_.dialect = dialect;
    for (const std::string& word : asked.missing)
      marks_.push_back({word, number_of(word, dialect.comma).value_or(Map::unknown)});
  }

  Table read() {
    for (; !rest_.empty() && !table_.fault; ++line_) {
      const std::string_view line = take_line(rest_), words = trimmed(line);
      const Separator separator = table_.dialect.separator;
      if (words.empty())
        blocks_.empty_line();
      else if (!is_comment(words, separator, asked_.missing))
        add(content_of(line, separator));
      else
        add_comment(content_of(line, separator), words);
    }
    if (!table_.fault) finish();
    if (!decimal_) table_.mixed = mixed_;
    for (const Mark& mark : marks_)
      if (!mark.seen) table_.unseen.push_back(mark.word);
    if (table_.fault) table_.values = {};
    return std::move(table_);
  }

 private:
  // A word of missing points, and its number.
  struct Mark {
    std::string word;
    double value;
    bool seen = false;
  };

  // Room for all lines if they are as long as the first; address space only, until it is filled.
  void reserve() {
    const auto ends = [&](char end) { return static_cast<std::size_t>(std::ranges::count(rest_, end)); };
    const auto columns = static_cast<std::size_t>(table_.columns);
    const std::size_t lines = 2 + std::max(ends('\n'), ends('\r'));
    const std::size_t most = table_.values.size() + rest_.size();  // numbers of at least one byte each
    table_.values.reserve(lines > most / columns ? most : lines * columns);
  }

  void fail(const char* at, const std::string& what) { table_.fault = Fault{line_, at, what}; }
  std::string here() const { return "line " + std::to_string(line_); }

  void keep(std::string_view line) {
    if (!asked_.head) return;
    table_.head.push_back({line_, line});
    if (table_.head.size() > most_head_lines)
      fail(line.data(), fmt::format("more than {} lines of words", most_head_lines));
  }

  void add_comment(std::string_view line, std::string_view words) {
    blocks_.comment(words, begins_);
    begins_ ? keep(words) : check_comment(line, words);
  }

  // A cell that begins like a comment among numbers in all other columns may be a number that failed. What is
  // a number behind the mark was taken out on purpose.
  void check_comment(std::string_view line, std::string_view words) {
    const auto cells = cells_of(line, table_.dialect.separator, asked_.quotes);
    if (static_cast<Index>(cells.size()) != table_.columns) return;
    std::string_view marked;
    Index numbers = 0;
    for (const std::string_view cell : cells) {
      const auto value = number_of(cell, table_.dialect.comma);
      const bool number = value || mark_of(cell, value) != nullptr;
      numbers += number && cell.front() != '#';
      if (number || cell.empty()) continue;
      if (!marked.empty()) return;
      marked = cell;
    }
    const bool hashes = words.size() > 2 && words.find_first_not_of('#') == words.npos;
    if (marked.size() > 1 && number_of(marked.substr(1), table_.dialect.comma)) return;
    if (numbers == 0 && !hashes) return;
    fail(words.data(), fmt::format("{}: {} is a comment or a line of the table: remove it, or tell "
                                   "asperity-convert if {} means a missing point (`missing`)",
                                   here(), quoted(words), quoted(hashes ? words : marked)));
    table_.doubtful = true;
  }

  // A line of words; what came before it had no number either.
  void take_as_head(std::string_view line) {
    if (!first_fault_) first_fault_ = table_.fault;
    table_.fault.reset();
    table_.values.clear();
    table_.lines = 0;
    table_.first_line = 0;
    trailing_ = true;
    table_.holes = table_.spaced = number_ = false;
    keep(line);
    ++table_.head_lines;
  }

  void add(std::string_view line) {
    const std::size_t before = row_ = table_.values.size();
    std::string_view cell, rest = line;
    while (rest.data() != nullptr && !table_.fault)
      add_cell(cell = take_cell(rest, table_.dialect.separator, asked_.quotes));
    if (table_.fault) {
      if (begins_ && asked_.head && word_) take_as_head(line);
      return;
    }
    trailing_ = trailing_ && cell.empty();
    if (asked_.shape && cell.empty()) table_.values.pop_back();
    const auto count = static_cast<Index>(table_.values.size() - before);
    if (begins_ && number_ && asked_.head && table_.lines > 0 && count != table_.columns) drop_empty(before);
    if (table_.lines++ == 0) {
      table_.columns = count;
      table_.first_line = line_;
      table_.begins = line.data();
    }
    blocks_.numbers(line_, begins_);
    if (begins_ && number_ && count > 0) {
      begins_ = false;
      reserve();
    }
    if (!asked_.shape && count != table_.columns)
      fail(line.data(),
           fmt::format("{} has {}, the first line {}", here(), counted(count, "number"), table_.columns));
  }

  // Lines of separators above the numbers, of another count: they belong to the head.
  void drop_empty(std::size_t numbers) {
    table_.values.erase(table_.values.begin(), table_.values.begin() + static_cast<std::ptrdiff_t>(numbers));
    table_.lines = 0;
  }

  void add_cell(std::string_view cell) {
    word_ = false;
    if (cell.empty()) {
      table_.holes = true;
      return push(Map::unknown);
    }
    auto value = number_in(cell);
    if (Mark* mark = mark_of(cell, value)) {
      mark->seen = true;
      value = Map::unknown;
    }
    if (!value) {
      word_ = true;
      fail(cell.data(), here() + ": " + fault_of(cell, asked_.variable == "map"));
    } else if (std::isinf(*value)) {
      fail(cell.data(), fmt::format("{}: {} is infinite", here(), quoted(cell)));
    } else {
      number_ |= std::isfinite(*value);
      if (std::isfinite(*value)) prove(cell);
      if (asked_.head && !decimal_ && std::isfinite(*value)) compare(cell);
      push(*value);
    }
  }

  // Between tabs, blanks may stand between thousands.
  std::optional<double> number_in(std::string_view cell) {
    const auto out = number_of(cell, table_.dialect.comma);
    if (out || table_.dialect.separator != Separator::tab || cell.find(' ') == cell.npos) return out;
    std::string marked(cell.substr(0, longest_grouped));
    std::ranges::replace(marked, ' ', '\'');
    const auto grouped = cell.size() > marked.size() ? std::nullopt : number_of(marked, table_.dialect.comma);
    table_.spaced |= grouped.has_value();
    return grouped;
  }

  Mark* mark_of(std::string_view cell, const std::optional<double>& value) {
    for (Mark& mark : marks_)
      if ((value && *value == mark.value) || cell == mark.word) return &mark;
    return nullptr;
  }

  // "1.234,5" and "1.234.567" have no other meaning; "1234,5" has no mark between thousands.
  void prove(std::string_view cell) {
    const Comma comma = table_.dialect.comma;
    if (comma != Comma::thousands && comma != Comma::decimal_and_points) return;
    const std::size_t mark = cell.find(comma == Comma::thousands ? ',' : '.');
    table_.proved |= mark != cell.npos && cell.find_first_of(".,", mark + 1) != cell.npos;
    const std::size_t digit = std::min(cell.find_first_of("0123456789.,"), cell.size());
    const std::size_t end = std::min(cell.find_first_not_of("0123456789", digit), cell.size());
    table_.contradicted |= end - digit > 3;
  }

  // A point before three digits may stand between thousands if numbers of its column without one have no more
  // digits than three, and no number shows that it is a decimal mark.
  void compare(std::string_view cell) {
    if (table_.dialect.comma != Comma::none) return;
    const std::size_t digit = std::min(cell.find_first_of("0123456789."), cell.size());
    const std::string_view number = cell.substr(digit);
    const std::size_t end = std::min(number.find_first_not_of("0123456789"), number.size());
    const bool whole = end == number.size();
    decimal_ = whole ? number.size() > 3 : !is_grouped(number, '.');
    const std::size_t column = table_.values.size() - row_;
    seen_.resize(std::max(seen_.size(), column + 1));
    seen_[column][whole ? 0 : 1] = true;
    if (seen_[column][0] && seen_[column][1] && mixed_.empty()) mixed_ = cell;
  }

  // The memory is that of the table expected from the first line.
  void push(double value) {
    table_.values.push_back(value);
    if (table_.values.size() > most_)
      asked_.memory.require_map(static_cast<double>(table_.values.capacity()), asked_.variable);
  }

  void finish() {
    const std::size_t numbers = table_.values.size();
    if (table_.lines == 0 && first_fault_) {
      table_.fault = first_fault_;
      return;
    }
    if (table_.lines == 0) return fail(rest_.data(), "the file has no numbers");
    if (asked_.shape && numbers != static_cast<std::size_t>(asked_.shape->cells()))
      return fail(rest_.data(), fmt::format("the file has {}, its header gives {} x {}",
                                            counted(static_cast<Index>(numbers), "number"), asked_.shape->nx,
                                            asked_.shape->ny));
    if (trailing_ && !asked_.shape && table_.columns > 1) remove_last_column();
    table_.next_block = blocks_.second();
    table_.parted_by = blocks_.parted_by();
  }

  void remove_last_column() {
    const auto columns = static_cast<std::size_t>(table_.columns--);
    std::size_t place = 0;
    std::erase_if(table_.values, [&](double) { return ++place % columns == 0; });
  }

  std::string_view rest_;
  Table table_ = {};
  const Asked& asked_;
  bool trailing_ = true;              // every line so far ended with an empty cell
  bool begins_ = true;                // no line had a number so far
  bool number_ = false;               // a cell had one, in a line of nothing else if begins_ is false
  bool word_ = false;                 // the last cell is neither a number nor empty
  std::optional<Fault> first_fault_;  // of the first line of words
  std::vector<Mark> marks_;
  std::size_t row_ = 0;                      // of the values, where this line begins
  std::vector<std::array<bool, 2>> seen_{};  // of each column: numbers without a point, and with one
  std::string mixed_;                        // as Table::mixed
  bool decimal_ = false;                     // points are decimal marks
  TextBlocks blocks_{};
  std::size_t line_, most_;  // most_: numbers
};

}  // namespace

Table read_table(std::string_view text, Dialect dialect, const Asked& asked) {
  return TableReader(text, dialect, asked).read();
}

}  // namespace asperity
