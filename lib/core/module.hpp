/// Functions of a shared library that is loaded when the first of them is called.
///
/// NetCDF-4 and zip archives load forty libraries, for cryptography and the network among others, which took
/// more than half of a tool's start; FFTW in single precision takes a tenth. Few runs need them.
///
///     const auto read = ASPERITY_FROM_MODULE("asperity_netcdf4", asperity_read_netcdf4);
///
/// The library is in the folder of the one that loads it, or where the system looks. Where the libraries are
/// static its functions are linked like any other.
#pragma once

#ifdef ASPERITY_MODULES

#include <dlfcn.h>
#include <stdexcept>
#include <string>

namespace asperity {

/// Throws std::runtime_error where the library cannot be loaded.
inline void* function_of_module(const char* library, const char* name) {
  void* const module = ::dlopen(library, RTLD_NOW | RTLD_LOCAL);
  void* const found = module ? ::dlsym(module, name) : nullptr;
  if (!found) throw std::runtime_error(library + std::string(" cannot be loaded: ") + ::dlerror());
  return found;
}

}  // namespace asperity

#define ASPERITY_FROM_MODULE(module, function) \
  reinterpret_cast<decltype(&function)>(       \
      ::asperity::function_of_module("lib" module ".so" ASPERITY_MODULES, #function))

#else

#define ASPERITY_FROM_MODULE(module, function) (&function)

#endif
