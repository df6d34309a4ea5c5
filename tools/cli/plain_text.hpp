/// Words in plain text, separated by blanks, tabs, commas or semicolons, and headers of columns (tables of
/// numbers: formats/text_table.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/words.hpp"

namespace asperity::cli {

inline std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view separators = " \t,;\r";
  std::vector<std::string_view> words;
  for (std::size_t begin = line.find_first_not_of(separators); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(separators, end);
  }
  return words;
}

/// A column of a text table, by its header.
struct HeadedColumn {
  std::string name, unit;
};

/// Of "lag_x [um]  wave_number [rad m-1]  acf": the columns with their units.
inline std::vector<HeadedColumn> columns_of(std::string_view header) {
  std::vector<HeadedColumn> columns;
  while (true) {
    const std::size_t open = header.find('['), close = header.find(']', std::min(open, header.size()));
    for (std::string_view word : words_of(header.substr(0, open))) columns.push_back({std::string(word), {}});
    if (close == std::string_view::npos) return columns;
    if (!columns.empty()) columns.back().unit = header.substr(open + 1, close - open - 1);
    header.remove_prefix(close + 1);
  }
}

inline std::optional<std::size_t> place(const std::vector<HeadedColumn>& columns, std::string_view name) {
  const auto found = std::ranges::find(columns, name, &HeadedColumn::name);
  if (found == columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns.begin());
}

/// Throws DataError(variable, …) that names the line where the word is no finite number.
inline double number_of(std::string_view word, std::size_t line, const std::string& variable) {
  const auto value = to_number<double>(word);
  if (!value || !std::isfinite(*value))
    throw DataError(variable, "line " + std::to_string(line) + " must hold finite numbers only");
  return *value;
}

}  // namespace asperity::cli
