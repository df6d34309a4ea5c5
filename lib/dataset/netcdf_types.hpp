/// NetCDF's types and statuses as the program's own, and an open file; for dataset/netcdf.cpp and
/// dataset/netcdf_write.cpp alone.
#pragma once

#include <cerrno>
#include <new>
#include <string>
#include <type_traits>

#include <netcdf.h>

#include "core/error.hpp"
#include "core/large_pages.hpp"
#include "dataset/dataset.hpp"

namespace asperity::netcdf {

[[noreturn]] inline void refuse(const std::string& message) { throw DataError("dataset", message); }

inline void check_for_want_of_memory(int status) {
  if (status == NC_ENOMEM || status == ENOMEM) throw std::bad_alloc();
}

inline void check(int status, const std::string& what) {
  check_for_want_of_memory(status);
  if (status != NC_NOERR) refuse(what + ": " + nc_strerror(status));
}

// An open dataset, closed without a word when an exception passes.
class Handle {
 public:
  Handle() = default;
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (open) nc_abort(id);
  }
  int id = -1;
  bool open = false;
};

template <class T>
constexpr nc_type external_type() {
  if constexpr (std::is_same_v<T, char>) return NC_CHAR;
  if constexpr (std::is_same_v<T, std::int8_t>) return NC_BYTE;
  if constexpr (std::is_same_v<T, std::uint8_t>) return NC_UBYTE;
  if constexpr (std::is_same_v<T, std::int16_t>) return NC_SHORT;
  if constexpr (std::is_same_v<T, std::uint16_t>) return NC_USHORT;
  if constexpr (std::is_same_v<T, std::int32_t>) return NC_INT;
  if constexpr (std::is_same_v<T, std::uint32_t>) return NC_UINT;
  if constexpr (std::is_same_v<T, std::int64_t>) return NC_INT64;
  if constexpr (std::is_same_v<T, std::uint64_t>) return NC_UINT64;
  if constexpr (std::is_same_v<T, float>) return NC_FLOAT;
  if constexpr (std::is_same_v<T, double>) return NC_DOUBLE;
}

inline nc_type type_of(const Values& values) {
  return std::visit([]<class V>(const V&) { return external_type<typename V::value_type>(); }, values);
}

inline std::size_t element_size(const Values& values) {
  return std::visit([]<class V>(const V&) { return sizeof(typename V::value_type); }, values);
}

template <class Element>
std::vector<Element> room_for(std::size_t n) {
  std::vector<Element> out;
  out.reserve(n);
  prefer_large_pages(out.data(), n * sizeof(Element));
  out.resize(n);
  return out;
}

// Room for n elements of an external type.
inline Values allocate(nc_type type, std::size_t n, const std::string& name) {
  switch (type) {
    case NC_CHAR:
      return std::string(n, '\0');
    case NC_BYTE:
      return room_for<std::int8_t>(n);
    case NC_UBYTE:
      return room_for<std::uint8_t>(n);
    case NC_SHORT:
      return room_for<std::int16_t>(n);
    case NC_USHORT:
      return room_for<std::uint16_t>(n);
    case NC_INT:
      return room_for<std::int32_t>(n);
    case NC_UINT:
      return room_for<std::uint32_t>(n);
    case NC_INT64:
      return room_for<std::int64_t>(n);
    case NC_UINT64:
      return room_for<std::uint64_t>(n);
    case NC_FLOAT:
      return room_for<float>(n);
    case NC_DOUBLE:
      return room_for<double>(n);
    default:
      refuse(name + " is of a type that only NetCDF-4 has");
  }
}

inline void* data(Values& values) {
  return std::visit([](auto& v) { return static_cast<void*>(v.data()); }, values);
}
inline const void* data(const Values& values) {
  return std::visit([](const auto& v) { return static_cast<const void*>(v.data()); }, values);
}

}  // namespace asperity::netcdf
