#include "core/module.hpp"
#include "formats/archive.hpp"

namespace asperity {

std::unique_ptr<ZipArchive> ZipArchive::open(std::string_view bytes, std::string_view top) {
  static const auto open_zip = ASPERITY_FROM_MODULE("asperity_zip", asperity_open_zip);
  std::unique_ptr<ZipArchive> out;
  open_zip(bytes, top, out);
  return out;
}

std::string zip_of(std::span<const ZipEntry> entries) {
  static const auto make_zip = ASPERITY_FROM_MODULE("asperity_zip", asperity_make_zip);
  std::string out;
  make_zip(entries, out);
  return out;
}

}  // namespace asperity
