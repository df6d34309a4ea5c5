#include "formats/archive.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include <zip.h>

#include "dataset/bytes.hpp"
#include "formats/gzip.hpp"
#include "formats/raster.hpp"
#include "formats/refuse.hpp"

namespace asperity {
namespace {

constexpr std::uint16_t day = 0x21;  // 1980-01-01, the earliest date of the format

template <auto release>
struct Release {
  void operator()(auto* owned) const { release(owned); }
};
using Source = std::unique_ptr<zip_source_t, Release<zip_source_free>>;
using EntryFile = std::unique_ptr<zip_file_t, Release<zip_fclose>>;

Source owned(zip_source_t* source) {
  if (!source) throw std::bad_alloc();
  return Source(source);
}

// The record that ends an archive is searched from the end of the file. It gives the length and the start of
// the list before it; other bytes around them are refused (APPNOTE.TXT 4.3.16). ZIP64 uses another record.
void refuse_more(std::string_view bytes) {
  constexpr std::size_t record = 22, locator = 20;
  const std::size_t at = bytes.rfind(std::string_view("PK\5\6", 4));
  if (at == bytes.npos || bytes.size() - at < record) return;
  const char* const end = bytes.data() + at;
  const auto number = [&]<class T>(T, std::size_t place) -> std::size_t {
    return number_from<T>(end + place, std::endian::little);
  };
  refuse_rest(bytes.substr(std::min(at + record + number(std::uint16_t{}, 20), bytes.size())), "map");
  const std::size_t listed = number(std::uint32_t{}, 12) + number(std::uint32_t{}, 16);
  const bool wide = at >= locator && bytes.substr(at - locator, 4) == std::string_view("PK\6\7", 4);
  if (listed < at && !wide)
    refuse("{} bytes do not belong to the archive, perhaps to a second one: put each in its own file",
           at - listed);
}

// The archive shares ownership of the source.
zip_t* opened(zip_source_t* source, int flags) {
  zip_t* out = zip_open_from_source(source, flags, nullptr);
  if (out) zip_source_keep(source);
  return out;
}

void require(bool done, zip_t* archive) {
  if (!done) throw std::runtime_error(std::string("cannot write a zip archive: ") + zip_strerror(archive));
}

void add(zip_t* archive, const ZipEntry& entry) {
  zip_source_t* source = zip_source_buffer(archive, entry.bytes.data(), entry.bytes.size(), 0);
  require(source != nullptr, archive);
  const zip_int64_t index = zip_file_add(archive, entry.name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) zip_source_free(source);
  require(index >= 0, archive);
  const auto place = static_cast<zip_uint64_t>(index);
  require(zip_set_file_compression(archive, place, ZIP_CM_STORE, 0) == 0, archive);
  require(zip_file_set_dostime(archive, place, 0, day, 0) == 0, archive);
}

// A string to write an archive into; the library's own buffer would be a second copy. It has room for the
// whole archive, so that no exception passes through the library.
struct Sink {
  std::string bytes;
  std::size_t at = 0;

  zip_int64_t write(const void* data, std::size_t length) {
    bytes.replace(at, length, static_cast<const char*>(data), length);
    at += length;
    return static_cast<zip_int64_t>(length);
  }
  zip_int64_t seek(void* data, zip_uint64_t length) {
    const zip_int64_t to = zip_source_seek_compute_offset(at, bytes.size(), data, length, nullptr);
    if (to >= 0) at = static_cast<std::size_t>(to);
    return std::min<zip_int64_t>(to, 0);
  }
  static zip_int64_t stat(void* data) {
    zip_stat_t& empty = *static_cast<zip_stat_t*>(data);
    zip_stat_init(&empty);
    empty.size = 0;
    empty.valid = ZIP_STAT_SIZE;
    return sizeof empty;
  }
};

zip_int64_t answer(void* sink, void* data, zip_uint64_t length, zip_source_cmd_t command) {
  Sink& target = *static_cast<Sink*>(sink);
  switch (command) {
    case ZIP_SOURCE_SUPPORTS:
      return ZIP_SOURCE_SUPPORTS_WRITABLE;
    case ZIP_SOURCE_STAT:
      return Sink::stat(data);
    case ZIP_SOURCE_WRITE:
      return target.write(data, length);
    case ZIP_SOURCE_SEEK_WRITE:
      return target.seek(data, length);
    case ZIP_SOURCE_TELL_WRITE:
      return static_cast<zip_int64_t>(target.at);
    default:
      return 0;
  }
}

std::string named(const std::string& name) { return fmt::format("'{:.64}' in the archive", name); }

class LibzipArchive : public ZipArchive {
 public:
  explicit LibzipArchive(std::string_view bytes) {
    const Source source = owned(zip_source_buffer_create(bytes.data(), bytes.size(), 0, nullptr));
    archive_.reset(opened(source.get(), ZIP_RDONLY));
    refuse_more(bytes);
    if (!archive_) refuse("the file is not a zip archive, or is cut short");
  }
  bool has(const std::string& name) const override;
  Entry entry(const std::string& name) const override;
  std::string read(const std::string& name) const override;

 private:
  std::unique_ptr<zip_t, Release<zip_discard>> archive_;
};

bool LibzipArchive::has(const std::string& name) const {
  return zip_name_locate(archive_.get(), name.c_str(), 0) >= 0;
}

ZipArchive::Entry LibzipArchive::entry(const std::string& name) const {
  const zip_int64_t index = zip_name_locate(archive_.get(), name.c_str(), 0);
  if (index < 0) refuse("{} is missing", named(name));
  zip_stat_t stat;
  const auto place = static_cast<zip_uint64_t>(index);
  constexpr zip_uint64_t needed = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_COMP_METHOD;
  if (zip_stat_index(archive_.get(), place, 0, &stat) != 0 || (stat.valid & needed) != needed)
    refuse("{} has no size", named(name));
  if (stat.comp_method != ZIP_CM_STORE && stat.comp_method != ZIP_CM_DEFLATE)
    refuse("{} has an unsupported compression: write it stored or deflated", named(name));
  if (stat.size / most_inflated > stat.comp_size)
    refuse("{} claims {} bytes, more than its {} compressed bytes can hold", named(name), stat.size,
           stat.comp_size);
  return {place, stat.size, stat.comp_size};
}

std::string LibzipArchive::read(const std::string& name) const {
  const Entry found = entry(name);
  const EntryFile file(zip_fopen_index(archive_.get(), found.index, 0));
  if (!file) refuse("{} cannot be read: {}", named(name), zip_strerror(archive_.get()));
  constexpr std::size_t piece = 1 << 16;
  std::string out;
  out.reserve(found.size + 1);  // address space only, until it is filled
  while (out.size() <= found.size) {
    const std::size_t before = out.size(), room = std::min(piece, found.size - before + 1);
    out.resize(before + room);
    const zip_int64_t got = zip_fread(file.get(), out.data() + before, room);
    if (got < 0) refuse("{} is damaged", named(name));
    out.resize(before + static_cast<std::size_t>(got));
    if (got == 0) break;
  }
  if (out.size() != found.size)
    refuse("{} is {} than it claims", named(name), out.size() < found.size ? "smaller" : "larger");
  return out;
}

}  // namespace
}  // namespace asperity

using namespace asperity;

void asperity_open_zip(std::string_view bytes, std::unique_ptr<ZipArchive>& out) {
  out = std::make_unique<LibzipArchive>(bytes);
}

void asperity_make_zip(std::span<const ZipEntry> entries, std::string& out) {
  Sink sink;
  std::size_t bytes = 1024;
  for (const ZipEntry& entry : entries) bytes += entry.bytes.size() + 2 * entry.name.size() + 256;
  sink.bytes.reserve(bytes);
  const Source target = owned(zip_source_function_create(&answer, &sink, nullptr));
  zip_t* archive = opened(target.get(), ZIP_TRUNCATE);
  if (!archive) throw std::runtime_error("cannot create a zip archive");
  try {
    for (const ZipEntry& entry : entries) add(archive, entry);
    require(zip_close(archive) == 0, archive);
  } catch (...) {
    zip_discard(archive);
    throw;
  }
  out = std::move(sink.bytes);
}
