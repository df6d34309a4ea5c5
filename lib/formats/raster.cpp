#include "formats/raster.hpp"

#include <cmath>
#include <limits>
#include <type_traits>

#include "dataset/bytes.hpp"
#include "formats/refuse.hpp"

namespace asperity {
namespace {

constexpr Index block = 32;

// Calls at(i, j, place) for all cells, with place in the file's order, in cache-friendly blocks.
template <class At>
void for_each_cell(Shape shape, Order order, At at) {
  if (order == Order::xy) {
    for (Index i = 0; i < shape.nx; ++i)
      for (Index j = 0; j < shape.ny; ++j) at(i, j, i * shape.ny + j);
    return;
  }
  for (Index first_i = 0; first_i < shape.nx; first_i += block)
    for (Index first_j = 0; first_j < shape.ny; first_j += block)
      for (Index i = first_i; i < std::min(first_i + block, shape.nx); ++i)
        for (Index j = first_j; j < std::min(first_j + block, shape.ny); ++j) at(i, j, j * shape.nx + i);
}

template <class T>
T whole(double value) {
  const double rounded = std::nearbyint(value);
  const double least = static_cast<double>(std::numeric_limits<T>::min()),
               beyond = std::ldexp(1.0, std::numeric_limits<T>::digits);
  if (!(rounded >= least && rounded < beyond))
    throw DataError("values",
                    fmt::format("value {} does not fit into {} bits", shortest(value), 8 * sizeof(T)));
  return static_cast<T>(rounded);
}

template <class T>
T converted(double value) {
  if constexpr (std::is_integral_v<T>) return whole<T>(value);
  if constexpr (std::is_same_v<T, float>)
    if (std::abs(value) > std::numeric_limits<float>::max())
      throw DataError("values", "value " + shortest(value) + " does not fit into single precision");
  return static_cast<T>(value);
}

}  // namespace

std::size_t size_of(NumberType type) {
  return with_type(type, [](auto number) { return sizeof number; });
}

void check_shape(Shape shape, std::size_t cells) {
  const std::string size = fmt::format("{} x {}", shape.nx, shape.ny);
  if (shape.nx < 1 || shape.ny < 1) refuse("the map has no points: its size is {}", size);
  if (static_cast<std::size_t>(shape.nx) > cells / static_cast<std::size_t>(shape.ny))
    refuse("the file is cut short: it holds {} points of {}", cells, size);
}

Field field_from(std::string_view bytes, Shape shape, const Raster& raster, const MemoryBound& memory) {
  check_shape(shape, bytes.size() / size_of(raster.type));
  refuse_rest(bytes.substr(static_cast<std::size_t>(shape.cells()) * size_of(raster.type)), "map");
  memory.require_map(shape, "map");
  Field out(shape.nx, shape.ny);
  with_type(raster.type, [&](auto number) {
    using T = decltype(number);
    for_each_cell(shape, raster.order, [&](Index i, Index j, Index place) {
      const char* at = bytes.data() + static_cast<std::size_t>(place) * sizeof(T);
      out(i, j) = static_cast<double>(number_from<T>(at, raster.endian));
    });
  });
  return out;
}

std::string bytes_of(const Field& field, const Raster& raster) {
  std::string out(static_cast<std::size_t>(field.size()) * size_of(raster.type), '\0');
  with_type(raster.type, [&](auto kind) {
    using T = decltype(kind);
    for_each_cell(shape_of(field), raster.order, [&](Index i, Index j, Index place) {
      const auto raw = bytes_of(converted<T>(field(i, j)), raster.endian);
      std::ranges::copy(raw, out.data() + static_cast<std::size_t>(place) * sizeof(T));
    });
  });
  return out;
}

}  // namespace asperity
