/// The file behind a name, whatever its spelling.
///
/// Symbolic links are followed to their end, except those of /proc: each is an open file, as in /dev/stdout
/// or /dev/fd/63 of a process substitution, and its target need not be a file name.
#pragma once

#include <string>

namespace asperity::cli {

/// Where the bytes of an output go.
struct OutputTarget {
  enum class Kind {
    file,        ///< a regular file, or none yet: it can be replaced
    descriptor,  ///< a file that this process has open
    other        ///< a device, a pipe, a folder, a file that another process has open
  };
  Kind kind = Kind::file;
  std::string path;     ///< at the end of the links
  int descriptor = -1;  ///< of Kind::descriptor
};
OutputTarget output_target(const std::string& name);  ///< "-" is standard output
inline bool replaces_file(const std::string& output) {
  return output_target(output).kind == OutputTarget::Kind::file;
}

/// The same for all names of a regular file or a pipe; empty for devices and for a missing input.
using Identity = std::string;
Identity identity_of_output(const std::string& name);
Identity identity_of_input(const std::string& name);  ///< "-" is standard input

}  // namespace asperity::cli
