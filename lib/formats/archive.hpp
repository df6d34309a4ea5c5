/// Zip archives in memory, the only door to libzip.
///
/// Reading trusts no number that the archive states: an entry must be stored or deflated, may claim no more
/// than deflating can yield of its bytes (1032 times as many), is inflated piece by piece, and must end where
/// it claims to. Writing stores entries as they are, all dated 1980-01-01: the same entries make the same
/// bytes.
///
/// Memory    of reading, what has been inflated; of writing, the entries once more.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

struct zip;

namespace asperity {

class ZipArchive {
 public:
  /// The bytes must outlive the archive. Throws DataError("map", …) when they are no archive.
  explicit ZipArchive(std::string_view bytes);

  bool has(const std::string& name) const;
  struct Entry {
    std::size_t index, size,
        stored;  ///< the bytes that it claims, inflated, and those that it has in the archive
  };
  /// Throws DataError when there is none, or it cannot be so large.
  Entry entry(const std::string& name) const;
  /// All of an entry; throws DataError when it is not as its size and its checksum say.
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
