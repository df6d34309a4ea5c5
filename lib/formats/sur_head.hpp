/// Places of the fields in the head of a SUR file (lib/formats/sur.cpp), and its writer.
#pragma once

#include <bit>
#include <cstddef>
#include <string>
#include <string_view>

#include "formats/map.hpp"

namespace asperity {

namespace sur {

inline constexpr std::string_view plain = "DIGITAL SURF", deflated = "DSCOMPRESSED";
inline constexpr std::size_t head_size = 512, name_size = 30, unit_size = 16;
inline constexpr std::endian order = std::endian::little;

enum Place : std::size_t {
  byte_order = 12,
  objects = 14,
  version = 16,
  object_type = 18,
  object_name = 20,
  channels_of_each = 80,
  special = 86,
  absolute = 88,
  numbers_per_point = 94,
  bits = 98,
  least = 100,
  greatest = 104,
  points_per_line = 108,
  lines = 112,
  points = 116,
  steps = 120,
  axis_names = 132,
  step_units = 180,
  axis_units = 228,
  unit_ratios = 276,
  comment_size = 334,
  private_size = 336,
  zero_height = 474
};

}  // namespace sur

/// The bytes of a file. Throws DataError for a map that it cannot hold.
std::string encode_sur(const Map& map, Order order_of_matrix);

}  // namespace asperity
