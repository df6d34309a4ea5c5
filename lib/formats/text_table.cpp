#include "formats/text_table.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "formats/raster.hpp"
#include "formats/refuse.hpp"
#include "formats/text_head.hpp"

namespace asperity {
namespace {

bool has(std::string_view text, char c) { return text.find(c) != text.npos; }

// All that neither the user nor the characters of the text exclude. Where commas separate, others may stand
// in quotes.
std::vector<Dialect> dialects_of(std::string_view text, const Reading& reading) {
  const bool commas = has(text, ','), points = has(text, '.'), quotes = has(text, '"'),
             given = reading.decimal != DecimalMark::any;
  std::vector<Dialect> out;
  for (const Separator s : {Separator::semicolon, Separator::tab, Separator::comma, Separator::blank}) {
    const bool asked = reading.separator == s;
    if (reading.separator != Separator::any && !asked) continue;
    if (!asked && s != Separator::blank && !has(text, character_of(s))) continue;
    for (const Comma c : {Comma::none, Comma::decimal, Comma::thousands, Comma::decimal_and_points}) {
      const bool decimal = c == Comma::decimal || c == Comma::decimal_and_points;
      if (given && decimal != (reading.decimal == DecimalMark::comma)) continue;
      if (s == Separator::comma && c != Comma::none && !quotes) continue;
      if (c == Comma::decimal_and_points && !points) continue;
      if (c != Comma::none && !commas && !(given && decimal)) continue;
      out.push_back({s, c, quotes});
    }
  }
  if (out.empty()) throw ParameterError("decimal", "a comma cannot be both decimal mark and separator");
  return out;
}

bool same(const Table& a, const Table& b) {
  const auto equal = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  return a.columns == b.columns && std::ranges::equal(a.values, b.values, equal);
}

// The same cells separated by tabs, and by any blanks.
bool tabs_for_blanks(Dialect a, Dialect b) {
  return a.separator == Separator::tab && b.separator == Separator::blank && a.comma == b.comma;
}

// Tabs used only for alignment would leave a column empty if each of them ended a cell.
bool tabs_decide(const Table& a, const Table& b) {
  return tabs_for_blanks(a.dialect, b.dialect) && !a.spaced &&
         static_cast<Index>(a.values.size()) == a.lines * a.columns &&
         !a.field().isNaN().colwise().all().any();
}

std::string table_words(const Table& table) {
  return fmt::format("{}, {} per line, {}", counted(static_cast<Index>(table.values.size()), "number"),
                     table.columns, described(table.dialect));
}

// The text with semicolons for commas next to a blank, if other commas have no blank: these may be decimal
// marks, as in "1,5, 2,5". Nothing if all commas are alike.
std::string commas_apart(std::string_view text) {
  std::string out;
  bool alone = false;
  for (std::size_t i = text.find(','); i != text.npos; i = text.find(',', i + 1)) {
    const bool blank = text.substr(i + 1).starts_with(' ') || text.substr(0, i).ends_with(' ');
    alone |= !blank;
    if (blank && out.empty()) out = text;
    if (blank) out[i] = ';';
  }
  return alone ? out : "";
}

// All ways to read a text that fit; of the others, the one whose fault is furthest on.
class Search {
 public:
  Search(const Asked& asked, const Reading& reading) : asked_(asked), reading_(reading) {}

  Table best(std::string_view text) {
    const bool spaces = text.find_first_of(" \f\v") != text.npos;
    for (const Dialect dialect : dialects_of(text, reading_)) {
      const bool alike = found_ && !spaces && !found_->holes && tabs_for_blanks(found_->dialect, dialect);
      if (!alike) add(read_table(text, dialect, asked_));
    }
    check_faults();
    if (reading_.decimal == DecimalMark::any) check_marks();
    check_commas(text);
    return *std::move(found_);
  }

 private:
  [[noreturn]] void refuse_text(const std::string& what) const { throw DataError(asked_.variable, what); }
  [[noreturn]] void refuse_ambiguous(const std::string& what) const {
    refuse_text("the text is ambiguous: " + what);
  }

  void add(Table table) {
    if (table.first_line > 0) first_ = std::min(first_, table.first_line);
    if (table.fault) {
      if (table.fault->doubtful && !doubtful_) doubtful_ = table;
      if (further(table)) refused_ = std::move(table);
    } else if (!found_ || found_->first_line > table.first_line) {
      found_ = std::move(table);
    } else if (found_->first_line == table.first_line && !same(*found_, table) &&
               !tabs_decide(*found_, table)) {
      choose(std::move(table));
    }
  }

  bool further(const Table& a) const {
    if (!refused_ || a.fault->line != refused_->fault->line)
      return !refused_ || a.fault->line > refused_->fault->line;
    return a.dialect.separator == refused_->dialect.separator && a.fault->at > refused_->fault->at;
  }

  // Of two ways, labels for all columns decide.
  void choose(Table table) {
    const bool mine = names_points(*found_), other = names_points(table);
    if (mine == other)
      refuse_ambiguous(fmt::format("{}; or {}: give the `separator` or the `decimal` mark",
                                   table_words(*found_), table_words(table)));
    if (other) found_ = std::move(table);
  }

  // Where numbers above the table fit another way only, that way is meant and has a fault.
  void check_faults() const {
    if (!found_ || (refused_ && asked_.head && first_ < found_->first_line))
      refuse_text(refused_->fault->what);
    if (doubtful_ && (doubtful_->columns != found_->columns || found_->dialect.separator == Separator::blank))
      refuse_text(doubtful_->fault->what);
  }

  // Where the decimal mark is not given.
  void check_marks() const {
    const Comma comma = found_->dialect.comma;
    const bool commas = comma == Comma::thousands;
    if ((commas || comma == Comma::decimal_and_points) && (!found_->proved || found_->contradicted))
      refuse_ambiguous(
          fmt::format("a {} is a decimal mark, as {}s are, or stands between thousands: write "
                      "one decimal mark, or give the `decimal` mark",
                      commas ? "comma" : "point", commas ? "point" : "comma"));
    if (!found_->mixed.empty())
      refuse_ambiguous(
          fmt::format("the point of {} is a decimal mark, or between thousands, for its column "
                      "has numbers of three digits without one: give the `decimal` mark",
                      quoted(found_->mixed)));
  }

  void check_commas(std::string_view text) const {
    const bool given = reading_.separator != Separator::any || reading_.decimal != DecimalMark::any;
    if (found_->dialect.separator != Separator::comma || given || found_->dialect.quotes) return;
    const std::string apart = commas_apart(text);
    if (!apart.empty() && !read_table(apart, {Separator::semicolon, Comma::decimal}, asked_).fault)
      refuse_ambiguous(table_words(*found_) +
                       "; or separated by comma and blank, with decimal commas: say that "
                       "the comma is the separator (`separator`), or write semicolons");
  }

  const Asked& asked_;
  const Reading& reading_;
  std::optional<Table> found_, refused_, doubtful_;
  std::size_t first_ = std::string::npos;  // line of a number in any of them
};

Table table_of(std::string_view text, Asked asked, const Reading& reading) {
  if (is_utf16(text)) throw DataError(asked.variable, "the text is in UTF-16: save it as UTF-8");
  refuse_without_mark(text, asked.variable);
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  asked.missing = reading.missing;
  return Search(asked, reading).best(text);
}

}  // namespace

Field matrix_of(std::string_view text, const std::string& variable, std::size_t first_line,
                const Reading& reading) {
  return table_of(text, {first_line, {}, variable, reading.memory}, reading).field();
}

Field field_of_lines(std::string_view text, Shape shape, std::size_t first_line, const Reading& reading) {
  check_shape(shape, text.size() + 1);
  reading.memory.require_map(shape, "map");
  const Table table = table_of(text, {first_line, shape, "map", reading.memory}, reading);
  return Eigen::Map<const Field>(table.values.data(), shape.ny, shape.nx).transpose();
}

Table table_with_head(std::string_view text, const Reading& reading) {
  return table_of(text, {1, {}, "map", reading.memory, true}, reading);
}

std::string described(Dialect dialect) {
  constexpr std::string_view separators[] = {"", "blanks", "tabs", "commas", "semicolons"};
  constexpr std::string_view commas[] = {"", " and decimal commas", " and commas between thousands",
                                         " and decimal commas, points between thousands"};
  return fmt::format("separated by {}{}", separators[static_cast<std::size_t>(dialect.separator)],
                     commas[static_cast<std::size_t>(dialect.comma)]);
}

}  // namespace asperity
