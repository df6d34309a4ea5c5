/// Files that were installed in the folder of this library.
///
/// The wheel and the tarball bring there what other installations find in the system: the units of UDUNITS,
/// and gnuplot with its font.
#pragma once

#include <string>

namespace asperity {

/// The path of a file in the folder of the library asperity_io, or of the program into which that is linked;
/// "" where there is no such file. One look at the disk.
std::string beside_library(const std::string& name);

}  // namespace asperity
