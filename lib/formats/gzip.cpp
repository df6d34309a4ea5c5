#include "formats/gzip.hpp"

#include <algorithm>
#include <limits>
#include <zlib.h>

#include "formats/refuse.hpp"

namespace asperity {
namespace {

constexpr std::size_t piece = 1 << 16;

class Inflater {
 public:
  Inflater(std::string_view bytes, Wrapper wrapper) : rest_(bytes) {
    constexpr int largest_window = 15, of_gzip = 16;
    const int kind = wrapper == Wrapper::gzip ? largest_window + of_gzip : largest_window;
    if (inflateInit2(&stream_, kind) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  // The number of bytes written to `out`; 0 at the end, or when the data are damaged.
  std::size_t take(char* out, std::size_t size) {
    stream_.next_out = reinterpret_cast<Bytef*>(out);
    stream_.avail_out = static_cast<uInt>(size);
    do {
      feed();
      state_ = inflate(&stream_, Z_NO_FLUSH);
    } while (state_ == Z_OK && stream_.avail_out == size);
    return state_ == Z_OK || state_ == Z_STREAM_END ? size - stream_.avail_out : 0;
  }

  // Whether the stream ends here with a correct checksum.
  bool ends() {
    char next;
    return take(&next, 1) == 0 && state_ == Z_STREAM_END;
  }
  // The bytes after the stream.
  std::string_view rest() const { return {rest_.data() - stream_.avail_in, rest_.size() + stream_.avail_in}; }

 private:
  // zlib counts bytes in 32 bits.
  void feed() {
    if (stream_.avail_in > 0) return;
    const std::size_t size = std::min<std::size_t>(rest_.size(), std::numeric_limits<uInt>::max());
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(rest_.data()));
    stream_.avail_in = static_cast<uInt>(size);
    rest_.remove_prefix(size);
  }

  std::string_view rest_;
  z_stream stream_{};
  int state_ = Z_OK;
};

}  // namespace

std::string inflated(std::string_view bytes, std::size_t size, Wrapper wrapper) {
  const std::string_view name = wrapper == Wrapper::gzip ? "gzip" : "zlib";
  if (size / most_inflated > bytes.size())
    refuse("the file is cut short: {} bytes of {} cannot hold {}", bytes.size(), name, size);
  Inflater inflater(bytes, wrapper);
  std::string out;
  out.reserve(size);  // address space only, until it is filled
  while (out.size() < size) {
    const std::size_t before = out.size();
    out.resize(std::min(size, before + piece));
    const std::size_t got = inflater.take(out.data() + before, out.size() - before);
    if (got == 0) refuse("the {} data are damaged or cut short", name);
    out.resize(before + got);
  }
  if (!inflater.ends()) refuse("the {} data are damaged, or hold more points than the header gives", name);
  refuse_rest(inflater.rest(), "map");
  return out;
}

Bytes gunzipped(Bytes bytes, const MemoryBound& memory) {
  const std::string_view all = bytes;
  if (!all.starts_with("\x1f\x8b\x08")) return bytes;
  if (all.size() < 18) refuse("the gzip data are damaged or cut short");
  std::size_t size = 0;  // in the last four bytes, the least significant first
  for (std::size_t k = 1; k <= 4; ++k) size = size << 8 | static_cast<unsigned char>(all[all.size() - k]);
  memory.beside(all.size()).require(2 * static_cast<double>(size), "map");
  const std::string content = inflated(all, size);
  Bytes out;
  std::ranges::copy(content, out.room(size));
  out.add(size);
  return out;
}

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  const int state =
      compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), Z_DEFAULT_COMPRESSION);
  if (state != Z_OK) throw std::bad_alloc();
  out.resize(size);
  return out;
}

}  // namespace asperity
