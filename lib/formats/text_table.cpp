#include "formats/text_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "formats/raster.hpp"
#include "formats/refuse.hpp"
#include "formats/text_encoding.hpp"
#include "formats/text_labels.hpp"
#include "formats/text_lines.hpp"

namespace asperity {
namespace {

// The characters of a text that decide between dialects.
struct Characters {
  explicit Characters(std::string_view text)
      : comma(has(text, ',')),
        point(has(text, '.')),
        quotes(has(text, '"')),
        spaces(text.find_first_of(" \f\v") != text.npos) {
    for (const Separator s : {Separator::tab, Separator::comma, Separator::semicolon})
      separators[static_cast<std::size_t>(s)] = has(text, character_of(s));
  }
  static bool has(std::string_view text, char c) { return text.find(c) != text.npos; }

  bool comma, point, quotes, spaces;
  std::array<bool, 5> separators{};
};

// Whether the user, or the characters of the text, exclude a dialect. Where commas separate, others may stand
// in quotes.
bool excluded(const Characters& text, const Reading& reading, Dialect d) {
  const auto [separator, comma] = d;
  const bool asked = reading.separator == separator, told = reading.decimal != DecimalMark::any;
  const bool decimal = comma == Comma::decimal || comma == Comma::decimal_and_points;
  if (reading.separator != Separator::any && !asked) return true;
  if (told && decimal != (reading.decimal == DecimalMark::comma)) return true;
  if (separator == Separator::comma && comma != Comma::none && !text.quotes) return true;
  if (comma == Comma::decimal_and_points && !text.point) return true;
  if (comma != Comma::none && !text.comma && !(told && decimal)) return true;
  return !asked && separator != Separator::blank && !text.separators[static_cast<std::size_t>(separator)];
}

std::vector<Dialect> dialects_of(const Characters& text, const Reading& reading) {
  std::vector<Dialect> out;
  for (Separator s : {Separator::semicolon, Separator::tab, Separator::comma, Separator::blank})
    for (Comma c : {Comma::none, Comma::decimal, Comma::thousands, Comma::decimal_and_points})
      if (!excluded(text, reading, {s, c})) out.push_back({s, c});
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
  if (!tabs || a.spaced || static_cast<Index>(a.values.size()) != a.lines * a.columns) return false;
  return !lines_of(a).isNaN().colwise().all().any();
}

std::string words_of(const Table& table) {
  return fmt::format("{}, {} per line, {}", counted(static_cast<Index>(table.values.size()), "number"),
                     table.columns, described(table.dialect));
}

// Whether a table's fault is further on in the text.
bool further(const Table& a, const std::optional<Table>& b) {
  if (!b || a.fault->line != b->fault->line) return !b || a.fault->line > b->fault->line;
  return a.dialect.separator == b->dialect.separator && a.fault->at > b->fault->at;
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

// Tabs and no other blanks: both separate the same cells, unless one of them is empty.
bool alike(const Table& found, Dialect next, bool spaces) {
  return !spaces && !found.holes && found.dialect.separator == Separator::tab &&
         next.separator == Separator::blank && next.comma == found.dialect.comma;
}

// All ways to read a text that fit; of the others, the one whose fault is furthest on.
struct Search {
  std::optional<Table> found, refused, doubtful;
  std::size_t first = std::string::npos;  // line of a number in any of them

  // Of two ways, labels for all columns decide.
  void choose(Table table, const Asked& asked) {
    const bool mine = names_points(*found, asked.quotes), other = names_points(table, asked.quotes);
    if (mine == other)
      throw DataError(asked.variable,
                      fmt::format("the text is ambiguous: {}; or {}: give asperity-convert the "
                                  "`separator` or the `decimal` mark",
                                  words_of(*found), words_of(table)));
    if (other) found = std::move(table);
  }

  void add(Table table, const Asked& asked) {
    if (table.first_line > 0) first = std::min(first, table.first_line);
    if (table.fault) {
      if (table.doubtful && !doubtful) doubtful = table;
      if (further(table, refused)) refused = std::move(table);
    } else if (!found || found->first_line > table.first_line) {
      found = std::move(table);
    } else if (found->first_line == table.first_line && !same(*found, table) && !tabs_decide(*found, table)) {
      choose(std::move(table), asked);
    }
  }

  // Where numbers above the table fit another way only, that way is meant and has a fault.
  Table best(const Asked& asked, bool told) && {
    const std::string& variable = asked.variable;
    if (!found || (refused && asked.head && first < found->first_line))
      throw DataError(variable, refused->fault->what);
    if (doubtful && (doubtful->columns != found->columns || found->dialect.separator == Separator::blank))
      throw DataError(variable, doubtful->fault->what);
    const Comma comma = found->dialect.comma;
    const bool thousands = comma == Comma::thousands || comma == Comma::decimal_and_points;
    if (thousands && (!found->proved || found->contradicted) && !told)
      throw DataError(
          variable,
          fmt::format("the text is ambiguous: a {} is a decimal mark beside decimal {}, or between "
                      "thousands: write one decimal mark, or give asperity-convert the `decimal` mark",
                      comma == Comma::thousands ? "comma" : "point",
                      comma == Comma::thousands ? "points" : "commas"));
    if (!found->mixed.empty() && !told)
      throw DataError(variable,
                      fmt::format("the text is ambiguous: the point of {} is a decimal mark, or between "
                                  "thousands, for its column has numbers of three digits without one: "
                                  "give asperity-convert the `decimal` mark",
                                  quoted(found->mixed)));
    return *std::move(found);
  }
};

void check_commas(const Table& found, std::string_view text, const Asked& asked, const Reading& reading) {
  const bool told = reading.separator != Separator::any || reading.decimal != DecimalMark::any;
  if (found.dialect.separator != Separator::comma || told || asked.quotes) return;
  const std::string apart = commas_apart(text);
  if (!apart.empty() && !read_table(apart, {Separator::semicolon, Comma::decimal}, asked).fault)
    throw DataError(asked.variable,
                    "the text is ambiguous: " + words_of(found) +
                        "; or separated by comma and blank, with decimal commas: tell "
                        "asperity-convert that the comma is the separator, or write semicolons");
}

Table table_of(std::string_view text, Asked asked, const Reading& reading) {
  if (is_utf16(text)) throw DataError(asked.variable, "the text is in UTF-16: save it as UTF-8");
  refuse_without_mark(text, asked.variable);
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  const Characters characters(text);
  asked.quotes = characters.quotes;
  asked.missing = reading.missing;
  Search search;
  for (const Dialect dialect : dialects_of(characters, reading))
    if (!search.found || !alike(*search.found, dialect, characters.spaces))
      search.add(read_table(text, dialect, asked), asked);
  Table out = std::move(search).best(asked, reading.decimal != DecimalMark::any);
  check_commas(out, text, asked, reading);
  return out;
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
