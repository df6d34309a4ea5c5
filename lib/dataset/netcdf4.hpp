/// NetCDF-4, which is HDF5, by the NetCDF library; no other code calls that. For dataset/netcdf.cpp. The
/// library is loaded when it is needed (core/module.hpp).
#pragma once

#include <string_view>

#include "dataset/dataset.hpp"
#include "dataset/memory_bound.hpp"

namespace asperity::netcdf {

struct Extent {
  MemoryBound memory = {};
  int times = 1;  // copies of the values in memory
};

// Sizes in the header are checked: the values are limited by the expansion of deflate, and all together by
// the allowed memory.
Dataset read_netcdf4(std::string_view bytes, const Extent& extent);
/// Loads the library, which a process with little address space left could not.
void load_netcdf4();

// Throws DataError where the values, of so many bytes, and the largest variable as doubles take more memory
// than is allowed.
void require_memory(double values, double largest, const MemoryBound& memory);

// NetCDF-4 compresses, and may omit values never written: the limit is the expansion of deflate.
std::size_t most_made_of(std::size_t bytes);

}  // namespace asperity::netcdf

extern "C" void asperity_read_netcdf4(std::string_view bytes, const asperity::netcdf::Extent& extent,
                                      asperity::Dataset& out);
