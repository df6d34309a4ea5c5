/// Converts numbers from and to bytes, in any type and byte order, and matrices in either order of indices.
///
/// Accuracy  exact, except that 64-bit integers are rounded to the 53 bits of a double.
/// Cost      one pass, transposed in blocks that stay in the cache.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "core/field.hpp"
#include "formats/map.hpp"

namespace asperity {

enum class NumberType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

std::size_t size_of(NumberType type);

/// Calls visit(T{}) with a number of the type.
template <class Visit>
auto with_type(NumberType type, Visit visit) {
  using std::int32_t, std::uint32_t, std::int64_t, std::uint64_t;
  using std::int8_t, std::uint8_t, std::int16_t, std::uint16_t;
  constexpr std::variant<int8_t, uint8_t, int16_t, uint16_t, int32_t, uint32_t, int64_t, uint64_t, float,
                         double>
      numbers[] = {int8_t{},   uint8_t{}, int16_t{},  uint16_t{}, int32_t{},
                   uint32_t{}, int64_t{}, uint64_t{}, 0.f,        0.};
  return std::visit(visit, numbers[static_cast<std::size_t>(type)]);
}

/// The number of type T with these bytes.
template <class T>
T number_from(const char* bytes, std::endian order) {
  std::array<char, sizeof(T)> raw;
  std::copy_n(bytes, sizeof(T), raw.begin());
  if (order != std::endian::native) std::ranges::reverse(raw);
  return std::bit_cast<T>(raw);
}
/// The bytes of a number.
template <class T>
std::array<char, sizeof(T)> bytes_of(T number, std::endian order) {
  auto raw = std::bit_cast<std::array<char, sizeof(T)>>(number);
  if (order != std::endian::native) std::ranges::reverse(raw);
  return raw;
}

/// Appends a number, least significant byte first.
template <class T>
void append_bytes(std::string& bytes, T number) {
  const auto raw = bytes_of(number, std::endian::little);
  bytes.append(raw.data(), raw.size());
}

/// Layout of a block of numbers in a file.
struct Raster {
  NumberType type = NumberType::float64;
  std::endian endian = std::endian::little;
  Order order = Order::yx;  ///< the slower index first
};

/// The field stored in `bytes`. Throws DataError("map", …) before allocation when there are fewer bytes than
/// the shape needs, or more (dataset/bytes.hpp), the shape is empty or impossible, or the map needs more
/// memory than allowed.
Field field_from(std::string_view bytes, Shape shape, const Raster& raster, const MemoryBound& memory = {});
/// Values are rounded to whole numbers for an integer type; values outside its range throw DataError.
std::string bytes_of(const Field& field, const Raster& raster = {});

/// Throws DataError("map", …) unless the shape has 1 to `cells` cells.
void check_shape(Shape shape, std::size_t cells);

}  // namespace asperity
