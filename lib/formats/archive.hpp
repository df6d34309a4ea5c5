/// Zip archives in memory, the only door to libzip.
///
/// Reading trusts no number that the archive states: an entry must be stored or deflated, may claim no more than
/// deflating can yield of its bytes (1032 times as many), is inflated piece by piece, and must end where it claims to.
/// Names are looked up in the archive and nowhere else.
/// Writing stores entries as they are, all dated 1980-01-01: the same entries make the same bytes.
///
/// Memory    of reading, what has been inflated; of writing, the entries once more.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

struct zip;

namespace asperity {

class ZipArchive {
 public:
  /// The bytes must outlive the archive. Throws DataError(variable, …) when they are no archive.
  ZipArchive(std::string_view bytes, std::string variable);

  bool has(const std::string& name) const;
  /// The size that an entry claims, inflated; throws DataError when there is none or it cannot be so large.
  std::size_t size(const std::string& name) const;
  /// The size that it has in the archive.
  std::size_t stored_size(const std::string& name) const;
  /// All of an entry; throws DataError when it is not as size() and its own checksum say.
  std::string read(const std::string& name) const;

 private:
  struct Close {
    void operator()(zip* archive) const;
  };
  struct Entry {
    std::size_t index, size, stored;
  };
  Entry entry(const std::string& name) const;

  std::string variable_;
  std::unique_ptr<zip, Close> archive_;
};

struct ZipEntry {
  std::string name;
  std::string_view bytes;
};

std::string zip_of(std::span<const ZipEntry> entries);

}  // namespace asperity
