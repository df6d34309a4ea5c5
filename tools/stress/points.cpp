#include "stress/points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

#include <fmt/format.h>

#include "core/parallel.hpp"
#include "core/words.hpp"
#include "tools/cli/plain_text.hpp"
#include "tools/cli/quantity.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/table.hpp"
#include "tools/stress/writer.hpp"

namespace asperity::cli {
namespace {

using Places = std::vector<std::array<double, 3>>;  // x, y and depth [m]

// The columns of x, y and depth, with their units; without a header the first three, without units.
using Columns = std::array<std::pair<std::size_t, std::string>, 3>;

// Of a comment that names all three.
std::optional<Columns> headed(std::string_view comment) {
  const std::vector<HeadedColumn> names = columns_of(comment);
  const auto x = place(names, "x"), y = place(names, "y"), z = place(names, "z");
  const auto depth = z ? z : place(names, "depth");
  if (!x || !y || !depth) return std::nullopt;
  return Columns{{{*x, names[*x].unit}, {*y, names[*y].unit}, {*depth, names[*depth].unit}}};
}

// A length with its unit, or that of its column; 0 needs none. Other programs write a plus before a number.
double parse_place(std::string_view word, const std::string& unit, int line) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  const auto bare = leading_number<double>(word);
  const bool alone = bare.found && bare.rest.empty();
  if (alone && unit.empty() && bare.number != 0)
    throw DataError("points",
                    fmt::format("line {}: '{}' has no unit: write {}um, or a header '# x [um] y [um] depth "
                                "[um]'",
                                line, word, word));
  return parse_quantity("points", std::string(word) + (alone ? " " + (unit.empty() ? "m" : unit) : ""), "m");
}

Places parse_points(std::string_view text, const MemoryBound& memory) {
  constexpr double bytes_a_row = 1000;  // of the table, with all components
  Places points;
  Columns columns{{{0, ""}, {1, ""}, {2, ""}}};
  std::istringstream lines{std::string(text)};
  int number = 0;
  bool has_header = false;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::size_t comment = std::min(line.find('#'), line.size());
    const std::vector<std::string_view> words = words_of(std::string_view(line).substr(0, comment));
    if (words.empty() && comment < line.size())
      if (const auto found = headed(std::string_view(line).substr(comment + 1)))
        columns = *found, has_header = true;
    if (words.empty()) continue;
    std::array<double, 3> at{};
    const bool whole = has_header
                           ? words.size() > std::max({columns[0].first, columns[1].first, columns[2].first})
                           : words.size() == 3;
    for (std::size_t k = 0; whole && k < 3; ++k)
      at[k] = parse_place(words[columns[k].first], columns[k].second, number);
    if (!whole || !(at[2] >= 0) ||
        std::ranges::any_of(at, [](double v) { return !(std::abs(v) <= farthest); }))
      throw DataError("points", fmt::format("line {}: '{}' is not x, y and a depth, 0 or more, to {:g} m",
                                            number, line, farthest));
    points.push_back(at);
    memory.require(bytes_a_row * static_cast<double>(points.size()), "points");
  }
  return points;
}

// The tensor at each point: a row a component.
Field stress_at(const StressPoints& below, const ResidualStress* residual, const Places& points,
                int threads) {
  const auto count = static_cast<Index>(points.size());
  Field out(6, count);
  parallel_ranges(count, threads, [&](Index begin, Index end, int) {
    for (Index k = begin; k < end; ++k) {
      const auto [x, y, z] = points[static_cast<std::size_t>(k)];
      const stress::Tensor s = below.at(x, y, z), left = residual ? residual->at(x, y, z) : stress::Tensor{};
      for (stress::Component c : stress::components) out(static_cast<Index>(c), k) = s[c] + left[c];
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

Table stress_table(const StressPoints& below, const ResidualStress* residual,
                   const StressSelection& selection, const Places& points, int threads) {
  Table table{{{"x", "m"}, {"y", "m"}, {"z", "m"}}, {}};
  for (const auto& output : selection.outputs()) table.columns.push_back({output.name, output.units});
  const Field components = stress_at(below, residual, points, threads);
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

// What else is to be said of points on the sides of cells; of a stress without friction only corners count.
std::string infinite(const StressScene& scene, const StressPoints& below, const Places& points) {
  auto singular = [&](const auto& p) { return below.singular(p[0], p[1], p[2]); };
  const auto first = std::ranges::find_if(points, singular);
  if (first == points.end()) return {};
  const bool slides = scene.body.friction.coefficient > 0;
  return fmt::format(
      "; at {} of them, the first at ({:.6g}, {:.6g}) um, on a {} of a cell at the surface, {} infinite, and "
      "the finite value here that of a smooth load: move them to a cell's centre or below the surface",
      std::ranges::count_if(points, singular), (*first)[0] * 1e6, (*first)[1] * 1e6,
      slides ? "side" : "corner", slides ? "stress_xx, stress_yy or stress_xy is" : "stress_xy is");
}

void warn_if_shallow(const Tool& tool, const StressScene& scene, const StressPoints& below,
                     const Places& points) {
  const double accurate = accurate_depth(scene.body.grid);
  const auto shallow = std::ranges::count_if(points, [&](const auto& p) { return p[2] < accurate; });
  if (shallow == 0) return;
  tool.warn(fmt::format(
      "{} of {} points {} less than {:.4g} um deep, the stress_accurate_depth: their stress is that of "
      "single cells, off by up to {:.0f} % of the maximum pressure below a cell's centre, and unbounded at "
      "the surface towards its edges and corners{}",
      shallow, points.size(), shallow == 1 ? "lies" : "lie", accurate * 1e6,
      100 * shallow_error(scene.body.poisson, scene.body.friction), infinite(scene, below, points)));
}

}  // namespace

void print_points(const Tool& tool, StressOptions& options, const StressSelection& selection) {
  tool.reads(options.points);
  const Bytes text = read_all(options.points, tool.memory_bound());
  const Places points = parse_points(text, tool.memory_bound(2 * text.size()));
  const StressScene scene = read_scene(tool, options);
  const StressPoints below(scene.body, tool.thread_count());
  const Table table = stress_table(below, scene.residual.get(), selection, points, tool.thread_count());
  warn_if_shallow(tool, scene, below, points);
  warn_of_yield(tool, scene, largest_in(table, "von_mises"));
  print(tool, table);
}

}  // namespace asperity::cli
