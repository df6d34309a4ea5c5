#include "tools/stress/points.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "core/parallel.hpp"
#include "core/words.hpp"
#include "stress/points.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/table.hpp"

namespace asperity::cli {
namespace {

using Places = std::vector<std::array<double, 3>>;  // x, y and depth [m]

// A number alone counts metres, as in every table; other programs write a plus before it.
double parse_place(const std::string& word) {
  const auto metres = leading_number<double>(std::string_view(word).substr(word.starts_with('+')));
  return metres.found && metres.rest.empty() ? metres.number : parse_quantity("points", word, "m");
}

Places parse_points(std::string_view text, const MemoryBound& memory) {
  constexpr double bytes_a_row = 1000;  // of the table, with all components
  Places points;
  std::istringstream lines{std::string(text)};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::istringstream words(line.substr(0, line.find('#')));
    std::vector<double> values;
    for (std::string word; words >> word;) values.push_back(parse_place(word));
    if (values.empty()) continue;
    const bool sound = values.size() == 3 && values[2] >= 0 &&
                       std::ranges::all_of(values, [](double v) { return std::abs(v) <= farthest; });
    if (!sound)
      throw DataError("points", fmt::format("line {}: '{}' is not x, y and a depth, 0 or more, to {:g} m",
                                            number, line, farthest));
    points.push_back({values[0], values[1], values[2]});
    memory.require(bytes_a_row * static_cast<double>(points.size()), "points");
  }
  return points;
}

// The tensor at each point: a row a component.
Field stress_at(const StressScene& scene, const Places& points, int threads) {
  const auto count = static_cast<Index>(points.size());
  Field out(6, count);
  const StressPoints below(scene.body, threads);
  parallel_ranges(count, threads, [&](Index begin, Index end, int) {
    for (Index k = begin; k < end; ++k) {
      const auto [x, y, z] = points[static_cast<std::size_t>(k)];
      const stress::Tensor s = below.at(x, y, z);
      for (stress::Component c : stress::components) out(static_cast<Index>(c), k) = s[c];
    }
  });
  return out;
}

// 0 where the table has no such column.
double largest_in(const Table& table, std::string_view name) {
  double top = 0;
  for (std::size_t k = 0; k < table.columns.size(); ++k)
    for (const auto& row : table.rows)
      if (table.columns[k].name == name) top = std::max(top, std::get<double>(row[k]));
  return top;
}

Table stress_table(const StressScene& scene, const StressSelection& selection, const Places& points,
                   int threads) {
  Table table{{{"x", "m"}, {"y", "m"}, {"z", "m"}}, {}};
  for (const auto& output : selection.outputs()) table.columns.push_back({output.name, output.units});
  const Field components = stress_at(scene, points, threads);
  std::vector<std::vector<double>> values(selection.outputs().size(), std::vector<double>(points.size()));
  StressRow row{};
  for (stress::Component c : stress::components)
    row[c] = {components.row(static_cast<Index>(c)).data(), points.size()};
  const std::vector<std::span<double>> out(values.begin(), values.end());
  selection.compute(row, out);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto [x, y, z] = points[k];
    table.rows.push_back({x, y, z});
    for (const auto& output : values) table.rows.back().push_back(output[k]);
  }
  return table;
}

void warn_if_shallow(const Tool& tool, const StressScene& scene, const Places& points) {
  const double accurate = accurate_depth(scene.body.grid);
  const auto shallow = std::ranges::count_if(points, [&](const auto& p) { return p[2] < accurate; });
  if (shallow == 0) return;
  tool.warn(fmt::format(
      "{} of {} points lie less than {:.4g} um deep, which is stress_accurate_depth: their stress is that "
      "of single cells, off by up to {:.0f} % of the largest pressure below a cell's centre, and without a "
      "bound at the surface towards its edges and corners",
      shallow, points.size(), accurate * 1e6, 100 * shallow_error(scene.body.poisson, scene.body.friction)));
}

}  // namespace

void print_points(const Tool& tool, const StressOptions& options, const StressSelection& selection) {
  tool.reads(options.points);
  const Bytes text = read_all(options.points, tool.memory_bound());
  const Places points = parse_points(text, tool.memory_bound(2 * text.size()));
  const StressScene scene = read_scene(tool, options);
  const Table table = stress_table(scene, selection, points, tool.thread_count());
  print(tool, table);
  warn_if_shallow(tool, scene, points);
  warn_of_yield(tool, scene, largest_in(table, "von_mises"));
}

}  // namespace asperity::cli
