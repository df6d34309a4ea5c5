#include "formats/format.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "formats/esri.hpp"
#include "formats/gsf.hpp"
#include "formats/gwyddion_text.hpp"
#include "formats/npy.hpp"
#include "formats/nrrd.hpp"
#include "formats/sdf.hpp"
#include "formats/text_matrix.hpp"
#include "formats/text_numbers.hpp"
#include "formats/x3p.hpp"

namespace asperity {
namespace {

// What is recognised by its first bytes stands before what is not.
constexpr Format all[] = {
    {"gwyddion-text", "", "Gwyddion's text export, with its head", recognises_gwyddion_text,
     decode_gwyddion_text, encode_gwyddion_text},
    {"gsf", "gsf", "Gwyddion Simple Field, 32-bit floats", recognises_gsf, decode_gsf, encode_gsf, true},
    {"nrrd", "nrrd", "NRRD, nearly raw raster data", recognises_nrrd, decode_nrrd, encode_nrrd},
    {"npy", "npy", "NumPy's array", recognises_npy, decode_npy, encode_npy},
    {"sdf", "sdf", "SDF, ISO 25178-71, doubles", recognises_sdf, decode_sdf, encode_sdf},
    {"sdf-ascii", "", "SDF, ISO 25178-71, in text", recognises_sdf_text, decode_sdf, encode_sdf_text},
    {"esri", "asc", "ESRI's ASCII grid", recognises_esri, decode_esri, encode_esri},
    {"x3p", "x3p", "X3P, ISO 5436-2 and ISO 25178-72", recognises_x3p, decode_x3p, encode_x3p},
    {"text", "txt csv tsv dat asc xyz", "matrix of numbers in plain text", nullptr, decode_text_matrix,
     encode_text_matrix},
};

std::string extension_of(std::string_view file_name) {
  const std::string_view name = file_name.substr(file_name.find_last_of('/') + 1);
  const std::size_t dot = name.find_last_of('.');
  return dot == name.npos ? "" : lower(name.substr(dot + 1));
}

bool has_extension(const Format& format, std::string_view extension) {
  const std::string list = " " + std::string(format.extensions) + " ";
  return !extension.empty() && list.find(" " + std::string(extension) + " ") != list.npos;
}

}  // namespace

std::span<const Format> formats() { return all; }

bool is_text(std::string_view bytes) {
  return std::ranges::none_of(bytes.substr(0, 4096), [](unsigned char c) {
    return c < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f';
  });
}

const Format& format_named(std::string_view name, const std::string& option) {
  std::string names;
  for (const Format& format : all) {
    if (format.name == name) return format;
    names += (names.empty() ? "" : ", ") + std::string(format.name);
  }
  throw ParameterError(option, "'" + std::string(name) + "' is none of " + names);
}

const Format* format_by_extension(std::string_view file_name) {
  const std::string extension = extension_of(file_name);
  const auto found = std::ranges::find_if(all, [&](const Format& f) { return has_extension(f, extension); });
  return found == std::end(all) ? nullptr : found;
}

const Format& format_of(std::string_view bytes, std::string_view file_name) {
  if (bytes.empty()) throw DataError("map", "it is empty");
  for (const Format& format : all)
    if (format.recognises && format.recognises(bytes)) return format;
  if (const Format* format = format_by_extension(file_name); format && !format->recognises) return *format;
  if (is_text(bytes)) return format_named("text", "format");
  throw DataError("map", "it is in none of the formats that are known, by its first bytes or its name");
}

}  // namespace asperity
