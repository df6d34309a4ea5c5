/// Conversion of NetCDF types and statuses, and reading of a dataset; for dataset/netcdf*.cpp.
#pragma once

#include <cerrno>
#include <iterator>
#include <new>
#include <string>
#include <type_traits>

#include <netcdf.h>

#include "core/error.hpp"
#include "core/large_pages.hpp"
#include "dataset/dataset.hpp"
#include "dataset/memory_bound.hpp"

namespace asperity::netcdf {

[[noreturn]] inline void refuse(const std::string& message) { throw DataError("dataset", message); }

inline void check_for_want_of_memory(int status) {
  if (status == NC_ENOMEM || status == ENOMEM) throw std::bad_alloc();
}

inline void check(int status, const std::string& what) {
  check_for_want_of_memory(status);
  if (status != NC_NOERR) refuse(what + ": " + nc_strerror(status));
}

// An open dataset, closed when an exception passes.
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

// One for each alternative of Values, in their order.
inline constexpr nc_type external_types[] = {NC_CHAR, NC_BYTE,  NC_UBYTE,  NC_SHORT, NC_USHORT, NC_INT,
                                             NC_UINT, NC_INT64, NC_UINT64, NC_FLOAT, NC_DOUBLE};
static_assert(std::size(external_types) == std::variant_size_v<Values>);

inline nc_type type_of(const Values& values) { return external_types[values.index()]; }

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

// n elements of an external type; searches the alternatives of Values from `alternative`.
template <std::size_t alternative = 0>
Values allocate(nc_type type, std::size_t n, const std::string& name) {
  if constexpr (alternative == std::variant_size_v<Values>) {
    refuse(name + " is of a type that only NetCDF-4 has");
  } else {
    using List = std::variant_alternative_t<alternative, Values>;
    if (type != external_types[alternative]) return allocate<alternative + 1>(type, n, name);
    if constexpr (std::is_same_v<List, std::string>)
      return std::string(n, '\0');
    else
      return room_for<typename List::value_type>(n);
  }
}

inline void* data(Values& values) {
  return std::visit([](auto& v) { return static_cast<void*>(v.data()); }, values);
}
inline const void* data(const Values& values) {
  return std::visit([](const auto& v) { return static_cast<const void*>(v.data()); }, values);
}

struct Extent {
  std::size_t bytes = 0;  // of the file
  MemoryBound memory = {};
  int times = 1;             // copies of the values in memory
  bool whole = true;         // a whole variable will be converted to doubles
  bool fields_stay = false;  // values of variables on both x and y are not read
};

// Sizes in the header are checked: the values of a classic file are part of its bytes, those of NetCDF-4 are
// limited by the expansion of deflate, and all together by the allowed memory.
Dataset read_dataset(int file, const Extent& extent);

// NetCDF-4 compresses, and may omit values never written: the limit is the expansion of deflate.
std::size_t most_made_of(std::size_t bytes);

[[noreturn]] void refuse_cut_short(const std::string& name, std::size_t bytes);

}  // namespace asperity::netcdf
