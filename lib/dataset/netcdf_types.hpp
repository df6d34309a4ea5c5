/// Conversion of NetCDF types and statuses; for dataset/netcdf4.cpp.
#pragma once

#include <cerrno>
#include <iterator>
#include <new>
#include <string>
#include <type_traits>

#include <netcdf.h>

#include "core/error.hpp"
#include "core/memory.hpp"
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
      return large_list<typename List::value_type>(n);
  }
}

inline void* data(Values& values) {
  return std::visit([](auto& v) { return static_cast<void*>(v.data()); }, values);
}

}  // namespace asperity::netcdf
