#include "tools/stress/record.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "core/parallel.hpp"
#include "stress/points.hpp"

namespace asperity::cli {
namespace {

// A number alone counts metres, as in every table.
double parse_place(const std::string& word) {
  char* end = nullptr;
  const double metres = std::strtod(word.c_str(), &end);
  return *end == '\0' ? metres : parse_quantity("points", word, "m");
}

}  // namespace

void record_parameters(StressScene& scene, const StressOptions& options) {
  Attributes& a = scene.data.attributes;
  a.set("stress_poisson", scene.poisson);
  a.set("stress_resolution", options.resolution);
  a.set("stress_accurate_depth", accurate_depth(scene.grid));
  a.set("stress_friction", scene.friction.coefficient);
  if (scene.friction.coefficient > 0) a.set("stress_friction_angle", scene.friction.angle);
  if (scene.least > 0) a.set("stress_above", scene.least);
  if (scene.plane)
    a.set(scene.plane->along_x ? "stress_section_y" : "stress_section_x", place_of(*scene.plane, scene.grid));
}

void record_maximum(Attributes& a, const StressMaximum& m) {
  a.set("stress_max_von_mises", m.von_mises);
  a.set("stress_max_x", m.x);
  a.set("stress_max_y", m.y);
  a.set("stress_max_depth", m.depth);
}

std::vector<std::array<double, 3>> parse_points(std::string_view text, const MemoryBound& memory) {
  constexpr double bytes_a_row = 1000;  // of the table, with all components
  std::vector<std::array<double, 3>> points;
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

Table stress_table(const StressScene& scene, const StressSelection& selection,
                   const std::vector<std::array<double, 3>>& points, int threads) {
  const auto count = static_cast<Index>(points.size());
  Field components(6, count);
  const StressPoints below(scene.grid, scene.pressure, scene.friction, scene.poisson, threads);
  parallel_ranges(count, threads, [&](Index begin, Index end, int) {
    for (Index k = begin; k < end; ++k) {
      const auto [x, y, z] = points[static_cast<std::size_t>(k)];
      const stress::Tensor s = below.at(x, y, z);
      for (stress::Component c : stress::components) components(static_cast<Index>(c), k) = s[c];
    }
  });

  Table table{{{"x", "m"}, {"y", "m"}, {"z", "m"}}, {}};
  const auto outputs = selection.outputs();
  Field values(static_cast<Index>(outputs.size()), count);
  StressRow row{};
  for (stress::Component c : stress::components) row[c] = components.row(static_cast<Index>(c)).data();
  std::vector<double*> out;
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    table.columns.push_back({outputs[k].name, outputs[k].units});
    out.push_back(values.row(static_cast<Index>(k)).data());
  }
  selection.compute(row, count, out.data());
  for (Index k = 0; k < count; ++k) {
    const auto [x, y, z] = points[static_cast<std::size_t>(k)];
    table.rows.push_back({x, y, z});
    for (Index q = 0; q < values.rows(); ++q) table.rows.back().push_back(values(q, k));
  }
  return table;
}

}  // namespace asperity::cli
