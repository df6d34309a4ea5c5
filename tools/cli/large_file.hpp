/// Files that are too large to be read whole.
#pragma once

#include <string>

namespace asperity::cli {

/// Whether this is a NetCDF file of more than an eighth of `memory`. Other formats are read whole.
bool larger_than_memory(const std::string& path, std::size_t memory);

/// ParameterError("memory", …) of such a file where `what`, "--lambda-c", needs the whole field.
[[noreturn]] void refuse_strips(const std::string& path, const std::string& what);

}  // namespace asperity::cli
