/// Files that Gwyddion reads, over a hundred formats, through the program itself where it is installed.
///
/// `gwyddion --convert-to-gwy` runs without a display, confined as tools/cli/program.hpp says; its output is
/// read as .gwy. Missing points, units and channels are those that it finds. It gets the name of a file, for
/// some formats are of several files or known by their extension, and the bytes of anything else.
///
/// Scope     what Gwyddion unpacks into temporary files (some of JPK's and Keyence's) it cannot read here.
/// Cost      0.2 s; time is limited to 30 s and 10 MB of the file a second, address space to 512 MiB and the
///           memory limit of reading.
#pragma once

#include <string>
#include <string_view>

#include "formats/map.hpp"

namespace asperity::cli {

/// The name of this way of reading, as --from has it.
inline constexpr std::string_view through_gwyddion = "gwyddion";

/// The map of the file `name` with these bytes. Throws DataError("map", …) in one line where Gwyddion is not
/// installed or cannot read it.
Map map_through_gwyddion(std::string_view bytes, const std::string& name, const Reading& reading);

}  // namespace asperity::cli
