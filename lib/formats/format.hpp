/// The formats of maps that are read and written, and which one a file is in.
///
/// A file's first bytes tell, else its name's extension if that is of a format whose first bytes do not;
/// where neither does it is a matrix of text, if it is text at all.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "formats/map.hpp"

namespace asperity {

struct Format {
  std::string_view name;                       ///< as on the command line
  std::string_view extensions;                 ///< lower case, separated by blanks
  std::string_view title;                      ///< in words
  bool (*recognises)(std::string_view bytes);  ///< by the first bytes; null where they do not tell
  /// Throws DataError("map", …) for bytes that are not what they claim to be, in time and memory of the order
  /// of their number, and, before it is taken, for a map that takes more than `reading` allows.
  Map (*decode)(std::string_view bytes, const Reading& reading);
  /// Throws DataError for a map that the format cannot hold.
  std::string (*encode)(const Map& map, Order order);
  bool single = false;  ///< writes numbers of single precision, 24 bits
};

/// Each is defined in the source of its name, which begins with a page on what of it is understood.
namespace format {
extern const Format esri, gsf, gwyddion_text, npy, nrrd, sdf, sdf_ascii, text, x3p;
}

std::span<const Format> formats();

/// Whether bytes are text, by the first of them: no control characters but the white ones.
bool is_text(std::string_view bytes);

/// Throws ParameterError(option, …), with the names that there are.
const Format& format_named(std::string_view name, const std::string& option);
/// By the name's extension; null when there is none of it.
const Format* format_by_extension(std::string_view file_name);
/// Of a file's bytes and name. Throws DataError("map", …) when nothing knows them.
const Format& format_of(std::string_view bytes, std::string_view file_name);

}  // namespace asperity
