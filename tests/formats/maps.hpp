/// Maps to be written and read again.
#pragma once

#include <cmath>
#include <fstream>
#include <sstream>

#include "formats/format.hpp"
#include "support.hpp"

namespace asperity::test {

/// 5 × 3 heights [m] of very different sizes and both signs; spacings that differ.
inline Map small_map() {
  Field z(5, 3);
  z << 1e-9, -2.5e-7, 3, 0.1, 1.0 / 3, -1e-12, 7e-9, 6e-9, 5e-9, 0, -0.5, 1e3, 2, 4, 8;
  return {.values = z, .spacing = {1.25e-7, 3e-6}, .units = "m", .title = "heights"};
}

/// The same with two points missing.
inline Map map_with_holes() {
  Map map = small_map();
  map.values(0, 0) = map.values(3, 2) = std::nan("");
  return map;
}

/// The bytes of one of the files in tests/data.
inline std::string data_file(const std::string& name) {
  std::ostringstream bytes;
  bytes << std::ifstream(ASPERITY_TEST_DATA "/" + name, std::ios::binary).rdbuf();
  return bytes.str();
}

/// Equal to the last bit, missing points where they are missing.
inline bool same(const Field& a, const Field& b) {
  return shape_of(a) == shape_of(b) && (a == b || (a.isNaN() && b.isNaN())).all();
}

}  // namespace asperity::test
