/// Memory limit for reading a file, checked from its header before allocation.
///
/// A map takes at most three doubles per point, plus its file: the numbers of the file and of the map, or of
/// the map and of its dataset, and work space.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "core/field.hpp"

namespace asperity {

struct MemoryBound {
  std::size_t bytes = std::numeric_limits<std::size_t>::max();  ///< in all
  std::size_t taken = 0;                                        ///< of them, already in use

  std::size_t left() const { return bytes > taken ? bytes - taken : 0; }
  /// With `held` more bytes in use.
  MemoryBound beside(std::size_t held) const { return {bytes, taken + held}; }

  /// Throws DataError(variable, …) unless `more` bytes are left.
  void require(double more, const std::string& variable) const {
    if (more <= static_cast<double>(left())) return;
    const auto megabytes = [](double size) {
      return std::to_string(std::llround(std::ceil(size / 1e6))) + "MB";
    };
    throw DataError(variable, "reading needs " + megabytes(static_cast<double>(taken) + more) +
                                  ", the memory limit is " + megabytes(static_cast<double>(bytes)) +
                                  ": raise `memory`");
  }
  static constexpr double per_point = 3 * sizeof(double);
  std::size_t most_points() const { return left() / static_cast<std::size_t>(per_point); }
  void require_map(double points, const std::string& variable) const {
    require(per_point * points, variable);
  }
  void require_map(Shape shape, const std::string& variable) const {
    require_map(static_cast<double>(shape.nx) * static_cast<double>(shape.ny), variable);
  }
};

}  // namespace asperity
