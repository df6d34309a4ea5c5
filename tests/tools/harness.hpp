/// What most tests of the tools need: bodies, maps in files, the fields, attributes and tables of what a line has left.
#pragma once

#include <string>
#include <vector>

#include "dataset/layout.hpp"
#include "formats/map.hpp"
#include "support.hpp"
#include "tools/files.hpp"

namespace asperity::test {

inline const std::string steel = " --young 208GPa --poisson 0.3 ";
inline const std::string sphere = "asperity-contact --smooth --shape 64x64 --size 3mm --radius 50mm" + steel;
inline const std::string rough = "asperity-generate --shape 64x64 --size 3mm --rq 0.4um --length 8px";

/// ε leaves pressures and approaches some ten times itself (contact/problem.hpp), of the default 1e-6.
constexpr double solver_error = 1e-5;

inline Printed printed(const std::string& line) { return Printed(require(line).out); }

inline Attributes attributes_in(const std::string& file) { return read_dataset(file).attributes; }
inline double attribute(const std::string& file, const std::string& name) {
  return attributes_in(file).number(name, NAN);
}
/// Of the dataset that the line writes with -o.
inline Attributes attributes_of(const std::string& line) {
  require(line + " -o attributes.nc");
  return attributes_in("attributes.nc");
}

/// Missing points are NaN.
inline Field field_in(const std::string& file, const std::string& name = "heights") {
  return field_of(read_dataset(file), name, Missing::not_a_number);
}
inline std::vector<double> values_in(const std::string& file, const std::string& name) {
  return numbers(read_dataset(file).at(name).values);
}

inline void write_text(const std::string& name, const std::string& text) {
  std::ofstream(scratch(name), std::ios::binary) << text;
}
inline std::string content_of(const std::string& name) {
  std::ifstream in(scratch(name), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}
/// As a dataset with these heights [m].
inline void write_map(const Field& z, const Grid& grid, const std::string& name) {
  write_dataset(
      dataset_of({.values = z, .spacing = {grid.dx, grid.dy}, .units = "m", .periodic = grid.periodic}),
      name);
}

/// NaN beside NaN counts as equal.
inline bool same_bits(const Field& a, const Field& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && (a == b || (a.isNaN() && b.isNaN())).all();
}
inline double greatest_difference(const Field& a, const Field& b) { return (a - b).abs().maxCoeff(); }

/// The value without its sign that is largest.
inline double largest(const std::vector<double>& values) {
  double out = 0;
  for (const double value : values) out = std::max(out, std::abs(value));
  return out;
}

// ---- one contact of 64 × 48 cells, so that x and y cannot be mistaken for each other, and the stress below it ----

inline const std::string& oblong() {
  static const std::string name = [] {
    require(
        "asperity-generate --shape 64x48 --size 3mm,2.4mm --rq 0.4um --length 9px,4px --seed 7 | "
        "asperity-contact --radius 50mm --load 2000N -o oblong.nc" +
        steel);
    return std::string("oblong.nc ");
  }();
  return name;
}

inline Dataset below(const std::string& options) {
  const Outcome run = require("asperity-stress " + oblong() + options + " -o below.nc");
  CHECK((run.error.empty() ||
         (lines(run.error) == 1 && run.error.find("stress_accurate_depth") != std::string::npos)));
  return read_dataset("below.nc");
}

inline std::vector<double> values(const Dataset& data, const std::string& name) {
  return numbers(data.at(name).values);
}

}  // namespace asperity::test
