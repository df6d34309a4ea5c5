/// Names of files: the format that the name of an output implies, so that no file holds another one, and the
/// file behind a name, whatever its spelling.
///
/// A dataset needs a name without an extension, or with .nc, .cdf, .nc3 or .netcdf. A table takes any name
/// whose extension is not that of another format. Otherwise ParameterError(option, …) says what to do.
#pragma once

#include <string>

namespace asperity::cli {

/// After the last dot, in lower case: a letter and up to seven letters and digits; "nc" of "a.nc.part". Empty
/// otherwise, and for anything but a regular file: "-", "tmp.W2kXh0pQzR", "run_0.4um".
std::string extension_of(const std::string& name);

bool names_dataset(const std::string& extension);
void check_dataset_name(const std::string& name, const std::string& option = "output");
/// Refuses .json unless `json`.
void check_table_name(const std::string& name, bool json, const std::string& option = "output");
/// A page is HTML.
void check_page_name(const std::string& name);

// ---- the file behind a name ----
//
// Symbolic links are followed to their end, except those of /proc: each is an open file, as in /dev/stdout
// or /dev/fd/63 of a process substitution, and its target need not be a file name.

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
