#include "formats/text_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "dataset/bytes.hpp"
#include "formats/refuse.hpp"

namespace asperity {
namespace {

constexpr std::string_view white = " \t\r\f\v", decimal_digits = "0123456789";

// ---- cells ----

// The end of a quoted cell: after its second quote; a doubled one is part of it.
std::size_t end_of_quotes(std::string_view line) {
  std::size_t at = line.find('"', 1);
  while (at != line.npos && at + 1 < line.size() && line[at + 1] == '"') at = line.find('"', at + 2);
  return at == line.npos ? line.size() : at + 1;
}

// The next cell, removed from the line; after the last cell the line is null.
std::string_view take_cell(std::string_view& line, Separator separator, bool quotes) {
  const bool word = separator == Separator::blank;
  std::size_t from = 0;
  if (quotes) {
    const std::size_t first = line.find_first_not_of(separator == Separator::tab ? " " : white);
    if (first != line.npos && line[first] == '"') from = first + end_of_quotes(line.substr(first));
  }
  const std::size_t end = word ? line.find_first_of(white, from) : line.find(character_of(separator), from);
  std::string_view cell = trimmed(line.substr(0, end));
  line = end == line.npos ? std::string_view() : line.substr(end + 1);
  if (word && line.data() != nullptr)
    line.remove_prefix(std::min(line.find_first_not_of(white), line.size()));
  if (from > 0 && cell.size() > 1 && cell.ends_with('"')) cell = trimmed(cell.substr(1, cell.size() - 2));
  return cell;
}

// The part of a line with cells: a tab at its ends separates.
std::string_view content_of(std::string_view line, Separator separator) {
  return separator == Separator::tab && line.find('\t') != line.npos ? line : trimmed(line);
}

// ---- words of refusals and comments ----

std::string fault_of(std::string_view cell, bool map) {
  const std::string what = quoted(cell) + " is not a number";
  if (cell.find(',') != cell.npos && cell.find('.') != cell.npos)
    return what + ": remove thousands separators";
  if (cell.find_first_of(decimal_digits) != cell.npos) return what;
  return what + ": begin lines of words with #" +
         (map ? ", or, if it means a missing point, give it (`missing`)" : "");
}

// The first letters of a comment that are in no number; "" without a letter.
std::string first_word(std::string_view comment) {
  comment.remove_prefix(std::min(comment.find_first_not_of("#%;"), comment.size()));
  for (comment = trimmed(comment); !comment.empty(); comment = trimmed(comment)) {
    const std::string_view word = comment.substr(0, comment.find_first_of(" \t"));
    comment.remove_prefix(word.size());
    if (std::ranges::none_of(word, is_alpha) || number_of(word) || number_of(word, Comma::decimal)) continue;
    std::string out = lower(word);
    std::erase_if(out, [](char c) { return decimal_digits.find(c) != decimal_digits.npos; });
    const auto begin = std::ranges::find_if(out, is_alpha);
    return {begin, std::find_if_not(begin, out.end(), is_alpha)};
  }
  return "";
}

bool names_block(const std::string& word) {
  constexpr std::string_view names[] = {"block", "channel", "data", "frame", "image", "layer", "map"};
  return std::ranges::find(names, word) != std::end(names);
}

// ---- the table ----

class TableReader {
 public:
  TableReader(std::string_view text, Dialect dialect, const Asked& asked)
      : rest_(text), asked_(asked), line_(asked.first_line), most_(asked.memory.most_points()) {
    table_.dialect = dialect;
    for (const std::string& word : asked.missing)
      marks_.push_back({word, number_of(word, dialect.comma).value_or(Map::unknown)});
  }

  Table read() {
    const Separator separator = table_.dialect.separator;
    for (; !rest_.empty() && !table_.fault; ++line_) {
      const std::string_view line = take_line(rest_), words = trimmed(line);
      if (words.empty())
        parted_ = "an empty line";
      else if (!is_comment(words, separator, asked_.missing))
        add(content_of(line, separator));
      else
        add_comment(content_of(line, separator), words);
    }
    if (!table_.fault) finish();
    if (decimal_) table_.mixed.clear();
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
    constexpr std::size_t most_head_lines = 65536;
    if (!asked_.head) return;
    table_.head.push_back({line_, line});
    if (table_.head.size() > most_head_lines)
      fail(line.data(), fmt::format("more than {} lines of words", most_head_lines));
  }

  void add_comment(std::string_view line, std::string_view words) {
    const bool own = words.starts_with("# units:") || words.starts_with("# order:");
    if (own && asked_.head && table_.lines > 0)  // of a second map that this program wrote
      refuse_rest({words.data(), rest_.data() + rest_.size()}, asked_.variable);
    std::string word = first_word(words);
    if (begins_) {
      block_words_.insert(std::move(word));
      return keep(words);
    }
    if (parted_.empty() && !word.empty() && (names_block(word) || block_words_.contains(word)))
      parted_ = "the comment " + quoted(words);
    check_comment(line, words);
  }

  // A cell that begins like a comment among numbers in all other columns may be a number that failed.
  void check_comment(std::string_view line, std::string_view words) {
    const auto cells = cells_of(line, table_.dialect);
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
    fail(words.data(),
         fmt::format("{}: {} is a comment or a line of the table: remove it, or, if {} means a missing "
                     "point, give it (`missing`)",
                     here(), quoted(words), quoted(hashes ? words : marked)));
    table_.fault->doubtful = true;
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
    ++table_.words;
  }

  void add(std::string_view line) {
    row_ = table_.values.size();
    std::string_view cell, rest = line;
    while (rest.data() != nullptr && !table_.fault)
      add_cell(cell = take_cell(rest, table_.dialect.separator, table_.dialect.quotes));
    if (table_.fault) {
      if (begins_ && asked_.head && word_) take_as_head(line);
      return;
    }
    trailing_ = trailing_ && cell.empty();
    if (asked_.shape && cell.empty()) table_.values.pop_back();
    const auto count = static_cast<Index>(table_.values.size() - row_);
    if (begins_ && number_ && asked_.head && table_.lines > 0 && count != table_.columns) drop_empty();
    if (table_.lines++ == 0) {
      table_.columns = count;
      table_.first_line = line_;
    }
    settle_block();
    if (begins_ && number_ && count > 0) {
      begins_ = false;
      reserve();
    }
    if (!asked_.shape && count != table_.columns)
      fail(line.data(),
           fmt::format("{} has {}, the first line {}", here(), counted(count, "number"), table_.columns));
  }

  // Lines of separators above the numbers, of another count: they belong to the head.
  void drop_empty() {
    table_.values.erase(table_.values.begin(), table_.values.begin() + static_cast<std::ptrdiff_t>(row_));
    table_.lines = 0;
  }

  void settle_block() {
    if (parted_.empty()) {
      together_ |= !begins_;
    } else if (!begins_ && table_.next_block == 0) {
      table_.next_block = line_;
      table_.parted_by = parted_;
    }
    parted_.clear();
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
      if (std::isfinite(*value)) {
        number_ = true;
        prove(cell);
        if (asked_.head && !decimal_) compare(cell);
      }
      push(*value);
    }
  }

  // Between tabs, blanks may stand between thousands.
  std::optional<double> number_in(std::string_view cell) {
    constexpr std::size_t longest = 64;  // of a number with blanks between thousands, in bytes
    const auto out = number_of(cell, table_.dialect.comma);
    if (out || table_.dialect.separator != Separator::tab || cell.size() > longest) return out;
    std::string marked(cell);
    std::ranges::replace(marked, ' ', '\'');
    const auto grouped = number_of(marked, table_.dialect.comma);
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
    const std::size_t end = std::min(cell.find_first_not_of(decimal_digits, digit), cell.size());
    table_.contradicted |= end - digit > 3;
  }

  // A point before three digits may stand between thousands if numbers of its column without one have no more
  // digits than three, and no number shows that it is a decimal mark.
  void compare(std::string_view cell) {
    if (table_.dialect.comma != Comma::none) return;
    const std::string_view number = cell.substr(std::min(cell.find_first_of("0123456789."), cell.size()));
    const bool whole = number.find_first_not_of(decimal_digits) == number.npos;
    decimal_ = whole ? number.size() > 3 : !is_grouped(number, '.');
    const std::size_t column = table_.values.size() - row_;
    seen_.resize(std::max(seen_.size(), column + 1));
    seen_[column][whole ? 0 : 1] = true;
    if (seen_[column][0] && seen_[column][1] && table_.mixed.empty()) table_.mixed = cell;
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
    if (!together_) table_.next_block = 0;
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
  bool decimal_ = false;                     // points are decimal marks
  std::set<std::string> block_words_{};      // of the comments above all numbers
  std::string parted_{};                     // what stands above the next line of numbers
  bool together_ = false;                    // two lines of numbers have nothing between them
  std::size_t line_, most_;                  // most_: numbers
};

}  // namespace

char character_of(Separator separator) {
  return separator == Separator::tab ? '\t' : separator == Separator::comma ? ',' : ';';
}

std::vector<std::string_view> cells_of(std::string_view line, Dialect dialect) {
  std::vector<std::string_view> out;
  for (std::string_view rest = line; rest.data() != nullptr;)
    out.push_back(take_cell(rest, dialect.separator, dialect.quotes));
  return out;
}

bool is_comment(std::string_view line, Separator separator, const std::vector<std::string>& missing) {
  const bool semicolon = line.starts_with(';') && separator != Separator::semicolon;
  if (!line.starts_with('#') && !line.starts_with('%') && !semicolon) return false;
  std::string_view rest = line;
  const std::string_view first = take_cell(rest, separator, false);
  const bool blank = separator == Separator::blank;
  if (std::ranges::find(missing, first) != missing.end() && (first.size() > 1 || !blank)) return false;
  const auto is_number = [](std::string_view cell) {
    return number_of(cell) || number_of(cell, Comma::decimal_and_points);
  };
  if (first == "%") return blank || rest.data() == nullptr || !is_number(take_cell(rest, separator, false));
  if (!number_of(first)) return true;
  if (first.find_first_not_of('#') != first.npos) return false;
  bool number = false;
  while (rest.data() != nullptr) {
    const std::string_view cell = take_cell(rest, separator, false);
    if (!cell.empty() && !is_number(cell)) return true;
    number |= !cell.empty() && cell.front() != '#';
  }
  return !number;
}

std::vector<HeadLine> numbered_lines(std::string_view text) {
  std::vector<HeadLine> out;
  for (std::size_t number = 1; !text.empty(); ++number) out.push_back({number, take_line(text)});
  return out;
}

Table read_table(std::string_view text, Dialect dialect, const Asked& asked) {
  return TableReader(text, dialect, asked).read();
}

}  // namespace asperity
