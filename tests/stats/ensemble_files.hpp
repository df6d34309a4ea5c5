/// Eight surfaces in files, and what plain sums make of the tables of each.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/files.hpp"

namespace asperity::test::eight {

using Json = nlohmann::json;

inline constexpr unsigned members = 8;

// f_0.nc … f_7.nc, oblong, with dx ≠ dy.
inline void draw() {
  static const bool drawn = shell(
                                "asperity-generate -q --shape 64x48 --size 1mm,0.5mm --rq 0.4um --length "
                                "60um,40um --seed 1 --count 8 -o f_%d.nc")
                                .exit == 0;
  REQUIRE(drawn);
}

inline Json json_of(const std::string& command) { return Json::parse(require(command + " --json -q").out); }

inline std::vector<double> column(const Json& table, const std::string& name) {
  std::vector<double> out;
  for (const Json& value : table[name]["values"]) out.push_back(value.is_null() ? NAN : value.get<double>());
  return out;
}

// The single tables' mean, spread and rms error of a row, by plain sums; of errors, those that are known.
struct Sums {
  double sum = 0, squares = 0, errors = 0, known = 0;
  void add(double value, double error) {
    sum += value;
    squares += value * value;
    if (!std::isnan(error)) errors += error * error, ++known;
  }
  double mean() const { return sum / members; }
  double rms() const { return std::sqrt(squares / members); }
  double spread() const { return std::sqrt(std::max(squares - sum * sum / members, 0.0) / (members - 1)); }
  double expected() const { return std::sqrt(errors / known); }
};

}  // namespace asperity::test::eight
