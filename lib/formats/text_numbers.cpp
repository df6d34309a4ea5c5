#include "formats/text_numbers.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "formats/raster.hpp"
#include "grid/error.hpp"

namespace asperity {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";

// The next word of a line, taken off it.
std::string_view take_word(std::string_view& line, std::string_view separators) {
  const std::size_t begin = std::min(line.find_first_not_of(separators), line.size());
  const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

bool is_missing(std::string_view word) {
  if (word.size() > 3) return false;
  const std::string name = lower(word);
  return name == "nan" || name == "bad" || name == "--";
}

double number_in_line(std::string_view word, bool decimal_comma, const std::string& variable,
                      std::size_t line) {
  const auto value = number_of(word, decimal_comma);
  const std::string where = "line " + std::to_string(line) + ", '" + std::string(word.substr(0, 24)) + "', ";
  if (!value) throw DataError(variable, where + "is no number");
  if (std::isinf(*value)) throw DataError(variable, where + "is infinite");
  return *value;
}

// Calls number(value) for each word and line(number of line) after each line that has any.
template <class Number, class Line>
void for_each_number(std::string_view text, const std::string& variable, std::size_t first_line,
                     Number number, Line line) {
  const bool comma = has_decimal_commas(text);
  const std::string_view separators = comma ? " \t\r\f\v;" : " \t\r\f\v;,";
  for (std::size_t at = first_line; !text.empty(); ++at) {
    std::string_view rest = take_line(text);
    bool any = false;
    for (std::string_view word; !(word = take_word(rest, separators)).empty(); any = true)
      number(number_in_line(word, comma, variable, at));
    if (any) line(at);
  }
}

}  // namespace

std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  text.remove_prefix(begin);
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

// The first line that has a comma decides: "1,5 2,5" or "1,5;2,5", where "1,5" or "1, 5" separate.
bool has_decimal_commas(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = trimmed(take_line(text));
    const std::size_t comma = line.find(',');
    if (comma == line.npos) continue;
    const bool within = comma > 0 && comma + 1 < line.size() &&
                        std::isdigit(static_cast<unsigned char>(line[comma - 1])) != 0 &&
                        std::isdigit(static_cast<unsigned char>(line[comma + 1])) != 0;
    return within && line.find_first_of(" \t;") != line.npos && line.find('.') == line.npos;
  }
  return false;
}

std::optional<double> number_of(std::string_view word, bool decimal_comma) {
  if (is_missing(word)) return std::numeric_limits<double>::quiet_NaN();
  char copy[64];
  if (decimal_comma && word.find(',') != word.npos) {
    if (word.size() > sizeof copy || word.find('.') != word.npos) return std::nullopt;
    std::ranges::replace_copy(word, copy, ',', '.');
    word = {copy, word.size()};
  }
  if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
  double value = 0;
  const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (rest != word.data() + word.size() || error == std::errc::invalid_argument) return std::nullopt;
  return error == std::errc() ? std::optional(value) : std::strtod(std::string(word).c_str(), nullptr);
}

std::optional<Index> whole_number_of(std::string_view word) {
  Index value = 0;
  const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (rest != word.data() + word.size() || error != std::errc() || value < 0) return std::nullopt;
  return value;
}

Field matrix_of(std::string_view text, const std::string& variable, std::size_t first_line) {
  std::vector<double> values;
  Index rows = 0, columns = 0;
  for_each_number(
      text, variable, first_line, [&](double value) { values.push_back(value); },
      [&](std::size_t line) {
        const Index here = static_cast<Index>(values.size()) - rows * columns;
        if (rows == 0) columns = here;
        if (here != columns)
          throw DataError(variable, "line " + std::to_string(line) + " has " + std::to_string(here) +
                                        " numbers, the first one " + std::to_string(columns));
        ++rows;
      });
  if (rows == 0) throw DataError(variable, "there are no numbers in it");
  return Eigen::Map<const Field>(values.data(), rows, columns);
}

std::vector<double> numbers_of(std::string_view text, const std::string& variable, std::size_t first_line) {
  std::vector<double> values;
  for_each_number(
      text, variable, first_line, [&](double value) { values.push_back(value); }, [](std::size_t) {});
  return values;
}

Field field_of_lines(std::string_view text, Shape shape, const std::string& variable,
                     std::size_t first_line) {
  check_shape(shape, text.size() / 2 + 1, variable);
  const std::vector<double> values = numbers_of(text, variable, first_line);
  if (values.size() != static_cast<std::size_t>(shape.cells()))
    throw DataError(variable, "it holds " + std::to_string(values.size()) + " numbers where its head says " +
                                  std::to_string(shape.nx) + " x " + std::to_string(shape.ny));
  return Eigen::Map<const Field>(values.data(), shape.ny, shape.nx).transpose();
}

void append_number(std::string& text, double value) {
  if (std::isnan(value)) {
    text += "nan";
    return;
  }
  char digits[32];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
  text.append(digits, end);
}

std::string text_of(const Field& rows, char separator, std::string_view missing) {
  std::string out;
  out.reserve(static_cast<std::size_t>(rows.size()) * 20);
  for (Index i = 0; i < rows.rows(); ++i)
    for (Index j = 0; j < rows.cols(); ++j) {
      if (std::isnan(rows(i, j)))
        out += missing;
      else
        append_number(out, rows(i, j));
      out += j + 1 < rows.cols() ? separator : '\n';
    }
  return out;
}

}  // namespace asperity
