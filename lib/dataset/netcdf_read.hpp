/// A dataset from a file that the library has opened; for dataset/netcdf.cpp alone.
///
/// No size that the head states is believed: the values of a classic file are bytes of it, those of NetCDF-4 no more than
/// deflating can make of its bytes, and together they take no more memory than is allowed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dataset/dataset.hpp"
#include "dataset/memory_bound.hpp"

namespace asperity::netcdf {

// How a file is read: the values of variables that lie on all of the deferred dimensions are not; all others are held
// so many times.
struct Extent {
  std::size_t bytes = 0;  // of the file
  std::vector<std::string> deferred = {};
  MemoryBound memory = {};
  int times = 1;
  bool whole = true;  // a variable will be taken out at once
};

Dataset read_dataset(int file, const Extent& extent);

// NetCDF-4 deflates, and need not hold what was never written: no more is made of its bytes than deflating could.
std::size_t most_made_of(std::size_t bytes);

[[noreturn]] void refuse_cut_short(const std::string& name, std::size_t bytes);

}  // namespace asperity::netcdf
