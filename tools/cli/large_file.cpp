#include "tools/cli/large_file.hpp"

#include <filesystem>
#include <system_error>

#include "core/error.hpp"
#include "dataset/netcdf.hpp"
#include "tools/cli/stream.hpp"

namespace asperity::cli {

namespace fs = std::filesystem;

bool larger_than_memory(const std::string& path, std::size_t memory) {
  std::error_code none;
  if (!fs::is_regular_file(path, none) || fs::file_size(path, none) <= memory / 8) return false;
  return looks_like_netcdf(first_bytes(path));
}

void refuse_strips(const std::string& path, const std::string& what) {
  throw ParameterError("memory", "the file's " + std::to_string(fs::file_size(path)) +
                                     " bytes are more than an eighth of it, but " + what +
                                     " needs the whole field; allow more");
}

}  // namespace asperity::cli
