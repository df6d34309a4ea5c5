#include "tools/plot/table.hpp"

#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "core/words.hpp"
#include "dataset/units.hpp"
#include "formats/text_numbers.hpp"
#include "stats/measure/parameter.hpp"
#include "stats/sample/quantiles.hpp"
#include "tools/cli/plain_text.hpp"

namespace asperity::plot {
namespace {

constexpr const char* dimension = "row";

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> out;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find('\t', begin), line.size());
    out.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return out;
}

// NaN for words, which a table may have beside its numbers.
double number_in(std::string_view cell) { return to_number<double>(cell).value_or(NAN); }

}  // namespace

Dataset dataset_of_table(std::string_view text) {
  const std::string_view header = take_line(text);
  if (!header.starts_with("# ") || header.find('\t') == header.npos)
    throw DataError(
        "table",
        "is none that a tool printed: its first line must begin with # and name the columns, with "
        "tabs between");
  const std::vector<cli::HeadedColumn> columns = cli::columns_of(header.substr(2));
  if (columns.empty()) throw DataError("table", "has no columns");
  std::vector<std::vector<double>> values(columns.size());
  for (std::size_t line = 2; !text.empty(); ++line) {
    const std::string_view row = take_line(text);
    if (row.empty()) continue;
    const std::vector<std::string_view> cells = cells_of(row);
    if (cells.size() != columns.size())
      throw DataError("table", "line " + std::to_string(line) + " has " + counted(std::ssize(cells), "cell") +
                                   " for " + counted(std::ssize(columns), "column"));
    for (std::size_t c = 0; c < cells.size(); ++c) values[c].push_back(number_in(cells[c]));
  }
  if (values[0].empty()) throw DataError("table", "has no rows");
  Dataset out;
  out.set_dimension(dimension, std::ssize(values[0]));
  for (std::size_t c = 0; c < columns.size(); ++c) {
    Variable& v = out.put({columns[c].name, {dimension}, std::move(values[c]), {}});
    v.attributes.set("units", columns[c].unit.empty() ? "1" : columns[c].unit);
  }
  return out;
}

bool is_table(const Dataset& data) { return data.length(dimension) > 0; }

Eigen::ArrayXd column(const Dataset& table, std::string_view name) {
  const Variable* v = table.find(name);
  if (!v) return Eigen::ArrayXd::Constant(table.length(dimension), NAN);
  const std::vector<double> values = numbers(v->values);
  const double factor = factor_to(si_unit_of(*v), *v);
  return factor * Eigen::Map<const Eigen::ArrayXd>(values.data(), std::ssize(values));
}

Eigen::ArrayXd half_intervals(const Dataset& table, std::string_view error) {
  const Eigen::ArrayXd surfaces = column(table, "surfaces");
  return column(table, error) * surfaces.unaryExpr([&](double n) {
    return table.has("surfaces") ? student_quantile(0.025, n - 1) : half_width_95;
  });
}

}  // namespace asperity::plot
