/// What the name of a file leads to, by what is there and not by how it is spelt.
///
/// Symbolic links are followed to their end, but for those of /proc: each stands for an open file, as
/// /dev/stdout and /dev/fd/63 of a process substitution do, and what they say of its name may be none.
#pragma once

#include <string>

namespace asperity::cli {

struct Place {
  enum class Kind {
    file,        ///< a regular file, or none yet: it can be replaced
    descriptor,  ///< a file that this process has open
    other        ///< a device, a pipe, a folder, a file that another process has open
  };
  Kind kind = Kind::file;
  std::string path;     ///< at the end of the links
  int descriptor = -1;  ///< of Kind::descriptor, and "-" of an output
};

/// Of an output: "-" is standard output.
Place place_of(const std::string& name);

/// Of a regular file or a pipe, the same for all its names; empty for devices and an input that is not there.
using Identity = std::string;
Identity identity_of_output(const Place& place);
Identity identity_of_input(const std::string& name);  ///< "-" is standard input

}  // namespace asperity::cli
