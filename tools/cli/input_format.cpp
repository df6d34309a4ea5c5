#include "tools/cli/input_format.hpp"

#include <algorithm>

#include "dataset/netcdf.hpp"
#include "formats/format.hpp"

namespace asperity::cli {

std::vector<std::string> InputFormat::names() {
  std::vector<std::string> out{"auto", "netcdf"};
  for (const Format& format : formats()) out.emplace_back(format.name);
  return out;
}

bool InputFormat::netcdf(std::string_view bytes) const {
  return format == "netcdf" || (format == "auto" && (bytes.empty() || looks_like_netcdf(bytes)));
}

bool InputFormat::known(std::string_view bytes) const {
  return format != "auto" || looks_like_netcdf(bytes) ||
         std::ranges::any_of(formats(), [&](const Format& f) { return f.recognises && f.recognises(bytes); });
}

std::string_view InputFormat::found(std::string_view bytes, const std::string& name) const {
  if (netcdf(bytes)) return "netcdf";
  return format == "auto" ? format_of(bytes, name).name : format_named(format, "from").name;
}

Map InputFormat::map(std::string_view bytes, const std::string& name, const MemoryBound& memory) const {
  Reading told = reading;
  told.memory = memory.beside(bytes.size());
  told.order = order == "yx" ? Order::yx : Order::xy;
  return format_named(found(bytes, name), "from").decode(bytes, told);
}

Dataset InputFormat::dataset(std::string_view bytes, const std::string& name,
                             const MemoryBound& memory) const {
  return netcdf(bytes) ? decode_netcdf(bytes, memory.beside(bytes.size()))
                       : dataset_of(map(bytes, name, memory));
}

}  // namespace asperity::cli
