/// One contact, and the stress below it, which several tests of asperity-stress share.
#pragma once

#include <string>
#include <vector>

#include "dataset/conventions.hpp"
#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

namespace asperity::test {

inline constexpr double fill = default_fill;

// 64 × 48 cells, so that x and y cannot be mistaken for each other; the contact is solved once.
inline const std::string& pressed() {
  static const std::string name = [] {
    const Outcome run = shell(
        "asperity-generate --shape 64x48 --size 3mm,2.4mm --rq 0.4um --length 9px,4px --seed 7 | "
        "asperity-contact --radius 50mm --young 208GPa --poisson 0.3 --load 2000N -o pressed.nc");
    INFO(run.error);
    REQUIRE(run.exit == 0);
    return std::string("pressed.nc ");
  }();
  return name;
}

inline Dataset below(const std::string& options) {
  const Outcome run = shell("asperity-stress " + pressed() + options + " -o below.nc");
  INFO(run.error);
  REQUIRE(run.exit == 0);
  CHECK((run.error.empty() ||
         (lines(run.error) == 1 && run.error.find("stress_accurate_depth") != std::string::npos)));
  return read_dataset("below.nc");
}

inline std::vector<double> values(const Dataset& data, const std::string& name) {
  return numbers(data.at(name).values);
}

inline double largest(const std::vector<double>& v) {
  return std::abs(*std::ranges::max_element(v, {}, [](double x) { return std::abs(x); }));
}

}  // namespace asperity::test
