/// Zip archives in memory; no other code calls libzip, which is loaded when it is needed (core/module.hpp).
///
/// Reading does not trust the sizes in the archive: an entry must be stored or deflated, may claim at most
/// 1032 times its bytes (the limit of deflate), is inflated in pieces, and must end where it claims to.
/// Writing stores entries uncompressed, all dated 1980-01-01: the same entries give the same bytes. Strokes
/// between folders may lean either way.
///
/// Memory    of reading, the inflated bytes; of writing, a copy of the entries.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

class ZipArchive {
 public:
  /// Names are those from the folder of the entry `top` on, which many programs put into the archive. The
  /// bytes must outlive the archive. Throws DataError("map", …) when they are not an archive, or hold `top`
  /// twice.
  static std::unique_ptr<ZipArchive> open(std::string_view bytes, std::string_view top);
  virtual ~ZipArchive() = default;
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;

  const std::vector<std::string>& names() const { return names_; }  ///< "" of what is not in the folder
  bool has(const std::string& name) const { return std::ranges::find(names_, name) != names_.end(); }
  struct Entry {
    std::size_t index, size, stored;  ///< claimed size when inflated, and size in the archive
  };
  /// Throws DataError when the entry is missing, is there twice or claims an impossible size.
  virtual Entry entry(const std::string& name) const = 0;
  /// The whole entry; throws DataError when its size or checksum is wrong.
  virtual std::string read(const std::string& name) const = 0;

 protected:
  ZipArchive() = default;
  std::vector<std::string> names_;
};

struct ZipEntry {
  std::string name;
  std::string_view bytes;
};

std::string zip_of(std::span<const ZipEntry> entries);

}  // namespace asperity

extern "C" void asperity_open_zip(std::string_view bytes, std::string_view top,
                                  std::unique_ptr<asperity::ZipArchive>& out);
extern "C" void asperity_make_zip(std::span<const asperity::ZipEntry> entries, std::string& out);
