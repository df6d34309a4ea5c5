/// How much memory reading a file may take, which its head tells before it is taken.
///
/// A map of n points takes three doubles a point at the most: its numbers as the file has them and those of
/// the map, or those of the map and of its dataset, and what is worked with; its file comes on top.
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
  std::size_t taken = 0;                                        ///< of them, by what is held already

  std::size_t left() const { return bytes > taken ? bytes - taken : 0; }
  /// With so many bytes more taken.
  MemoryBound beside(std::size_t held) const { return {bytes, taken + held}; }

  /// Throws DataError(variable, …) unless `more` bytes are left.
  void require(double more, const std::string& variable) const {
    if (more <= static_cast<double>(left())) return;
    const auto megabytes = [](double size) {
      return std::to_string(std::llround(std::ceil(size / 1e6))) + "MB";
    };
    throw DataError(variable, "reading it takes " + megabytes(static_cast<double>(taken) + more) +
                                  " of memory, more than the " + megabytes(static_cast<double>(bytes)) +
                                  " that memory allows");
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
