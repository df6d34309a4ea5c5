#include "tools/cli/input_format.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "dataset/netcdf.hpp"
#include "formats/format.hpp"
#include "tools/cli/gwyddion.hpp"

namespace asperity::cli {

namespace {

bool has_channels(std::string_view format) {
  return format == through_gwyddion || (format != "netcdf" && format_named(format, "from").channels);
}

// Its content is unpacked when it is read.
std::string without_gz(const std::string& name) {
  return name.ends_with(".gz") ? name.substr(0, name.size() - 3) : name;
}

std::string names_of_formats() {
  std::string out = "netcdf";
  for (const Format& format : formats())
    if (format.recognises) out.append(", ").append(format.name);
  return out;
}

}  // namespace

std::vector<std::string> InputFormat::names() {
  std::vector<std::string> out{"auto", "netcdf"};
  for (const Format& format : formats()) out.emplace_back(format.name);
  out.emplace_back(through_gwyddion);
  return out;
}

bool InputFormat::netcdf(std::string_view bytes) const {
  return format == "netcdf" || (format == "auto" && (bytes.empty() || looks_like_netcdf(bytes)));
}

std::string_view InputFormat::found(std::string_view bytes, const std::string& name) const {
  std::string_view out = format;
  if (netcdf(bytes)) {
    out = "netcdf";
  } else if (format == "auto") {
    const Format* known = known_format(bytes, without_gz(name));
    out = known != nullptr ? known->name : through_gwyddion;
  }
  if (!channel.empty() && !has_channels(out))
    throw ParameterError("channel", "applies to files of several maps only, and the input is " +
                                        std::string(out) + ": omit it");
  return out;
}

std::string InputFormat::reason(std::string_view bytes, const std::string& name) const {
  const std::string_view out = found(bytes, name);
  const std::string file = (name == "-" ? "standard input" : name) + " is read as " + std::string(out) + ": ";
  if (format != "auto") return file + "--from says so";
  if (out == "netcdf" || (out != through_gwyddion && format_named(out, "from").recognises))
    return file + "its first bytes are of that format";
  const std::string none = "its first bytes are of none of " + names_of_formats();
  if (out == through_gwyddion) return file + none + ", its extension is of no format, and it is no text";
  if (const Format* other = format_by_extension(without_gz(name)); other != nullptr && other->name == out)
    return file + none + ", its extension is of that format";
  return file + none + ", its extension is of no format, and it is text; Gwyddion is not asked";
}

Map InputFormat::map(std::string_view bytes, const std::string& name, const MemoryBound& memory) const {
  const std::string_view from = found(bytes, name);
  Reading options = reading;
  options.memory = memory.beside(bytes.size());
  options.order = order_of_matrix();
  options.channel = channel;
  if (from == through_gwyddion) return map_through_gwyddion(bytes, name, options);
  return format_named(from, "from").decode(bytes, options);
}

Dataset InputFormat::dataset(std::string_view bytes, const std::string& name,
                             const MemoryBound& memory) const {
  return found(bytes, name) == "netcdf" ? decode_netcdf(bytes, memory.beside(bytes.size()))
                                        : dataset_of(map(bytes, name, memory));
}

}  // namespace asperity::cli
