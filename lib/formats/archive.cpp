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

std::string with_strokes(std::string name) {
  std::ranges::replace(name, '\\', '/');
  return name.starts_with("./") ? name.substr(2) : name;
}

std::vector<std::string> names_in(zip_t* archive) {
  std::vector<std::string> out(static_cast<std::size_t>(zip_get_num_entries(archive, 0)));
  for (std::size_t i = 0; i < out.size(); ++i)
    if (const char* name = zip_get_name(archive, i, 0)) out[i] = with_strokes(name);
  return out;
}

// Of the one entry with that name, with its stroke; "" if there is none.
std::string folder_of(std::string_view top, const std::vector<std::string>& names) {
  const std::string end = fmt::format("/{}", top);
  const auto is_top = [&](const std::string& name) { return ("/" + name).ends_with(end); };
  const auto found = std::ranges::find_if(names, is_top);
  if (found == names.end()) return "";
  const auto other = std::find_if(found + 1, names.end(), is_top);
  if (other != names.end())
    refuse("the archive holds '{:.64}' and '{:.64}': put each map into its own", *found, *other);
  return found->substr(0, found->size() - top.size());
}

class LibzipArchive : public ZipArchive {
 public:
  LibzipArchive(std::string_view bytes, std::string_view top) {
    const Source source = owned(zip_source_buffer_create(bytes.data(), bytes.size(), 0, nullptr));
    archive_.reset(opened(source.get(), ZIP_RDONLY));
    refuse_more(bytes);
    if (!archive_) refuse("the file is not a zip archive, or is cut short");
    names_ = names_in(archive_.get());
    const std::string folder = folder_of(top, names_);
    for (std::string& name : names_) name = name.starts_with(folder) ? name.substr(folder.size()) : "";
  }
  Entry entry(const std::string& name) const override;
  std::string read(const std::string& name) const override;

 private:
  std::unique_ptr<zip_t, Release<zip_discard>> archive_;
};

ZipArchive::Entry LibzipArchive::entry(const std::string& name) const {
  const std::string own = with_strokes(name);
  const auto found = std::ranges::find(names_, own);
  if (own.empty() || found == names_.end()) refuse("{} is missing", named(name));
  if (std::find(found + 1, names_.end(), own) != names_.end())
    refuse("{} is there twice: nothing says which counts, write it once", named(name));
  zip_stat_t stat;
  const auto place = static_cast<zip_uint64_t>(found - names_.begin());
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

void asperity_open_zip(std::string_view bytes, std::string_view top, std::unique_ptr<ZipArchive>& out) {
  out = std::make_unique<LibzipArchive>(bytes, top);
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
