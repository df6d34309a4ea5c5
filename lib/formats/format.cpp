#include "formats/format.hpp"

#include <algorithm>

#include "formats/refuse.hpp"
#include "formats/text_encoding.hpp"
#include "formats/text_numbers.hpp"

namespace asperity {
namespace {

bool has_extension(const Format& format, std::string_view extension) {
  return !extension.empty() &&
         fmt::format(" {} ", format.extensions).find(fmt::format(" {} ", extension)) != std::string::npos;
}

// No text has them, unless it is UTF-16 with its mark.
bool has_zeros(std::string_view bytes) {
  return !is_utf16(bytes) && bytes.substr(0, 4096).find('\0') != std::string_view::npos;
}

}  // namespace

std::span<const Format> formats() {
  using namespace format;
  // Formats recognised by their first bytes come first.
  static const Format all[] = {gwyddion_text, gsf, gwy,  nrrd, npy,         sdf,
                               sdf_ascii,     sur, esri, x3p,  format::text};
  return all;
}

bool is_text(std::string_view bytes) {
  if (is_utf16(bytes) || lacks_mark(bytes)) return true;
  return std::ranges::none_of(bytes.substr(0, 4096), [](unsigned char c) {
    return c < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f';
  });
}

const Format& format_named(std::string_view name, const std::string& option) {
  std::string names;
  for (const Format& format : formats()) {
    if (format.name == name) return format;
    names += fmt::format("{}{}", names.empty() ? "" : "|", format.name);
  }
  throw ParameterError(option, fmt::format("'{}' is none of {}", name, names));
}

const Format* format_by_extension(std::string_view file_name) {
  const std::string_view name = file_name.substr(file_name.find_last_of('/') + 1);
  const std::size_t dot = name.find_last_of('.');
  const std::string extension = dot == name.npos ? "" : lower(name.substr(dot + 1));
  for (const Format& format : formats())
    if (has_extension(format, extension)) return &format;
  return nullptr;
}

const Format* known_format(std::string_view bytes, std::string_view file_name) {
  for (const Format& format : formats())
    if (format.recognises && format.recognises(bytes)) return &format;
  if (const Format* format = format_by_extension(file_name);
      format && !format->recognises && !has_zeros(bytes))
    return format;
  return is_text(bytes) ? &format::text : nullptr;
}

const Format& format_of(std::string_view bytes, std::string_view file_name) {
  if (bytes.empty()) refuse("the file is empty");
  if (const Format* format = known_format(bytes, file_name)) return *format;
  refuse("unknown format: neither the first bytes nor the file extension identifies it");
}

}  // namespace asperity
