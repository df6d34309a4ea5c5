/// Contacts as asperity-contact is typed, and the rows of its sweeps.
#pragma once

#include <sstream>

#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/files.hpp"

namespace asperity::test {

inline const std::string elastic = " --young 208GPa --poisson 0.3 ";
inline const std::string smooth = "asperity-contact --smooth --shape 64x64 --size 3mm" + elastic;
inline const std::string surface = "asperity-generate --shape 64x64 --size 3mm --rq 0.4um --length 8px";

inline Attributes attributes(const std::string& line) {
  require(line + " -o attributes.nc");
  return read_dataset("attributes.nc").attributes;
}

struct Row {
  double load, approach, area, area_corrected, plastic_area, mean_gap, stiffness, max_pressure, residual,
      convolutions, converged;
};

inline std::vector<Row> rows(const std::string& tsv) {
  std::vector<Row> out;
  std::istringstream in(tsv);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream numbers(line);
    Row r{};
    for (double* value : {&r.load, &r.approach, &r.area, &r.area_corrected, &r.plastic_area, &r.mean_gap,
                          &r.stiffness, &r.max_pressure, &r.residual, &r.convolutions, &r.converged}) {
      std::string text;
      numbers >> text;
      *value = std::stod(text);
    }
    out.push_back(r);
  }
  return out;
}

// ε leaves pressures and approaches some ten times itself (contact/problem.hpp), of the default 1e-6.
constexpr double tolerance = 1e-5;

}  // namespace asperity::test
