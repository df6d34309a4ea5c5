#include "dataset/beside.hpp"

#include <dlfcn.h>
#include <filesystem>
#include <system_error>

namespace asperity {

std::string beside_library(const std::string& name) {
  Dl_info own{};
  if (::dladdr(reinterpret_cast<const void*>(&beside_library), &own) == 0) return "";
  const std::filesystem::path library = own.dli_fname;
  if (!library.has_parent_path()) return "";  // a program that was found on PATH
  const std::filesystem::path path = library.parent_path() / name;
  std::error_code none;
  return std::filesystem::exists(path, none) ? path.string() : "";
}

}  // namespace asperity
