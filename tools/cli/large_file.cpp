#include "tools/cli/large_file.hpp"

#include <filesystem>
#include <fstream>
#include <system_error>

#include "core/error.hpp"
#include "dataset/netcdf.hpp"

namespace asperity::cli {

namespace fs = std::filesystem;

bool larger_than_memory(const std::string& path, std::size_t memory) {
  std::error_code none;
  if (!fs::is_regular_file(path, none) || fs::file_size(path, none) <= memory / 8) return false;
  std::string first(8, '\0');
  std::ifstream(path, std::ios::binary).read(first.data(), static_cast<std::streamsize>(first.size()));
  return looks_like_netcdf(first);
}

void refuse_strips(const std::string& path, const std::string& what) {
  throw ParameterError("memory", "the file's " + std::to_string(fs::file_size(path)) +
                                     " bytes are more than an eighth of it, but " + what +
                                     " needs the whole field; allow more");
}

}  // namespace asperity::cli
