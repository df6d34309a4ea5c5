/// A parameter by its name.
#pragma once

#include <algorithm>

#include "stats/measure.hpp"
#include "support.hpp"

namespace asperity::test {

inline const Parameter& named(const Parameters& parameters, const std::string& name) {
  const auto found = std::ranges::find(parameters, name, &Parameter::name);
  REQUIRE(found != parameters.end());
  return *found;
}

}  // namespace asperity::test
