/// Bytes in and out: a file by name, or "-" for standard input and output.
///
/// A named file is written to a temporary name beside it and renamed when it is whole, so that nobody ever
/// sees half of it. Every write is checked, the last flush too; failures are std::system_error with the
/// file's name.
#pragma once

#include <string>
#include <string_view>

namespace asperity::cli {

std::string read_all(const std::string& name);
void write_all(const std::string& name, std::string_view bytes);

bool stdin_is_terminal();
bool stdout_is_terminal();

}  // namespace asperity::cli
