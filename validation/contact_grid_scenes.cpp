#include "contact_grid_scenes.hpp"

#include <fstream>
#include <iterator>
#include <string>

#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "formats/format.hpp"

namespace asperity::grid_scenes {

Field measured_map(const std::string& name) {
  std::ifstream in(ASPERITY_TEST_DATA "/" + name, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  if (name.ends_with(".nc")) return field_of(decode_netcdf(bytes), "heights");
  return format_of(bytes, name).decode(bytes, {}).values;
}

}  // namespace asperity::grid_scenes
