/// Zip archives in memory; no other code calls libzip.
///
/// Reading does not trust the sizes in the archive: an entry must be stored or deflated, may claim at most
/// 1032 times its bytes (the limit of deflate), is inflated in pieces, and must end where it claims to.
/// Writing stores entries uncompressed, all dated 1980-01-01: the same entries give the same bytes.
///
/// Memory    of reading, the inflated bytes; of writing, a copy of the entries.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

struct zip;

namespace asperity {

class ZipArchive {
 public:
  /// The bytes must outlive the archive. Throws DataError("map", …) when they are not an archive.
  explicit ZipArchive(std::string_view bytes);

  bool has(const std::string& name) const;
  struct Entry {
    std::size_t index, size, stored;  ///< claimed size when inflated, and size in the archive
  };
  /// Throws DataError when the entry is missing or claims an impossible size.
  Entry entry(const std::string& name) const;
  /// The whole entry; throws DataError when its size or checksum is wrong.
  std::string read(const std::string& name) const;

 private:
  struct Close {
    void operator()(zip* archive) const;
  };
  std::unique_ptr<zip, Close> archive_;
};

struct ZipEntry {
  std::string name;
  std::string_view bytes;
};

std::string zip_of(std::span<const ZipEntry> entries);

}  // namespace asperity
