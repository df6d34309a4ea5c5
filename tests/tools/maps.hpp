/// Measured maps for the tests of tools that read them.
#pragma once

#include "dataset/layout.hpp"
#include "formats/map.hpp"
#include "tools/files.hpp"

namespace asperity::test {

/// As a file with these heights [m].
inline void write_map(const Field& z, const Grid& grid, const std::string& name) {
  write_dataset(
      dataset_of({.values = z, .spacing = {grid.dx, grid.dy}, .units = "m", .periodic = grid.periodic}),
      name);
}

inline Field heights_in(const std::string& name) {
  return field_of(read_dataset(name), "heights", Missing::not_a_number);
}

/// NaN beside NaN counts as equal.
inline bool same_bits(const Field& a, const Field& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && (a == b || (a.isNaN() && b.isNaN())).all();
}

/// The first entry of the history, its steps a line each.
inline std::string last_run(const std::string& name) {
  const std::string all = read_dataset(name).attributes.text("history");
  std::size_t end = all.find('\n');
  while (end != all.npos && all.compare(end + 1, 1, " ") == 0) end = all.find('\n', end + 1);
  return all.substr(0, end);
}

}  // namespace asperity::test
