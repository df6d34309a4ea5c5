/// The formats of maps, and how the format of a file is found.
///
/// The first bytes decide. If they do not, the extension of the name decides among the formats without
/// typical first bytes, unless there are zeros among them, in the middle or at the end. Any other text is
/// read as a matrix of numbers.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/field.hpp"
#include "formats/map.hpp"

namespace asperity {

/// What a format keeps of a number: all of it, 24 bits, or the nearest of 2^31 steps from the least value to
/// the greatest.
enum class Numbers { doubles, singles, steps };

struct Format {
  std::string_view name;                       ///< as on the command line
  std::string_view extensions;                 ///< lower case, separated by blanks
  std::string_view title;                      ///< in words
  bool (*recognises)(std::string_view bytes);  ///< by the first bytes; null if the format has no typical ones
  /// Throws DataError("map", …) for malformed bytes, in time and memory proportional to their number, and
  /// before allocation for a map that needs more memory than `reading` allows.
  Map (*decode)(std::string_view bytes, const Reading& reading);
  /// Throws DataError for a map that the format cannot hold.
  std::string (*encode)(const Map& map, Order order);
  Numbers numbers = Numbers::doubles;  ///< as they are written
  bool channels = false;               ///< a file may hold several maps (chosen_channel)
};

/// All formats, those that are recognised by their first bytes first. Each is defined in the source file of
/// its name, which begins with a description of what it supports; `sdf_ascii` in that of `sdf`.
#define ASPERITY_FORMATS(format)                                                                       \
  format(gwyddion_text) format(gsf) format(gwy) format(nrrd) format(npy) format(sdf) format(sdf_ascii) \
      format(sur) format(esri) format(x3p) format(text)

namespace format {
#define ASPERITY_DECLARED(name) extern const Format name;
ASPERITY_FORMATS(ASPERITY_DECLARED)
#undef ASPERITY_DECLARED
}  // namespace format

std::span<const Format> formats();

/// One of several maps in a file.
struct Channel {
  Index number = 0;
  std::string title = {};      ///< one line, or ""
  std::string_view unit = {};  ///< of the values, as the file spells it
};

/// The place in `channels` of the one that is meant: by its name or its number in the file; without a name,
/// the only one, or the only one whose unit is a length: the heights. Throws DataError("map", …) with the
/// numbers and names of all when none or several are meant.
std::size_t chosen_channel(std::span<const Channel> channels, std::string_view name);

/// Whether bytes are text: no control characters except white space at the beginning, in the middle and at
/// the end.
bool is_text(std::string_view bytes);

/// A format that no reader here knows, in words: "a file of Nanoscope (Bruker, Veeco)", by the first bytes,
/// or of NanoFocus, which has no typical ones, by the name; "" of others. No text but Nanoscope's is one.
std::string_view foreign_format(std::string_view bytes, std::string_view file_name);

/// Throws ParameterError(option, …) with the list of names.
const Format& format_named(std::string_view name, const std::string& option);
/// The format with the extension of the name; null when there is none.
const Format* format_by_extension(std::string_view file_name);
/// The format of a file with these bytes and this name; null when it is unknown.
const Format* known_format(std::string_view bytes, std::string_view file_name);
/// The same. Throws DataError("map", …) when it is unknown, or the file is empty.
const Format& format_of(std::string_view bytes, std::string_view file_name);

// ---- datasets for ParaView, formats/vti.cpp ----

/// Throw DataError for a dataset without fields and volumes, with coordinates not in ascending order, or, for
/// image data, with unevenly spaced depths.
std::string encode_vti(const Dataset& dataset);
std::string encode_vtr(const Dataset& dataset);

}  // namespace asperity
