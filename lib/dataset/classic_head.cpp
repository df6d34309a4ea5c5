#include "dataset/classic_head.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "dataset/bytes.hpp"

namespace asperity {
namespace {

enum Tag : std::uint32_t { absent = 0, dimensions = 10, variables = 11, attributes = 12 };

[[noreturn]] void refuse(const std::string& message) { throw DataError("dataset", message); }

// NC_MAX_NAME and NC_MAX_VAR_DIMS: sizes of libnetcdf's buffers, which it overruns.
constexpr std::uint64_t longest_name = 256, highest_rank = 1024;
// NC_MAX_VARS and NC_MAX_ATTRS: libnetcdf compares each name with all before it.
constexpr std::uint64_t longest_list = 8192;

std::uint64_t padded(std::uint64_t bytes) { return (bytes + 3) / 4 * 4; }

// Reads bytes in order, and never beyond their end.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {
    skip(4);
    count_width_ = bytes[3] == 5 ? 8 : 4;
    offset_width_ = bytes[3] == 1 ? 4 : 8;
  }

  std::size_t size() const { return bytes_.size(); }
  std::size_t place() const { return place_; }
  std::size_t count_width() const { return count_width_; }
  /// The number of records in a file written as a stream.
  std::uint64_t greatest_count() const { return ~std::uint64_t{0} >> (64 - 8 * count_width_); }

  std::uint64_t count() { return number(count_width_); }
  std::uint32_t word() { return static_cast<std::uint32_t>(number(4)); }
  std::uint64_t offset() { return number(offset_width_); }
  /// n things of `size` bytes, padded to four.
  void skip_padded(std::uint64_t n, std::uint64_t size) {
    if (n > left() / size) refuse_cut_short();
    skip(padded(n * size));
  }
  void skip_name() {
    const std::uint64_t length = count();
    if (length > longest_name)
      refuse("the header has a name of " + std::to_string(length) + " bytes, more than " +
             std::to_string(longest_name));
    skip_padded(length, 1);
  }
  /// The number of elements of a list, each of which has at least `least` words.
  std::uint64_t list(Tag tag, std::uint64_t least) {
    const std::uint32_t found = word();
    const std::uint64_t n = count();
    if (found != tag && (found != absent || n != 0)) refuse("the header is damaged");
    if (n > left() / (4 * least)) refuse_cut_short();
    if (n > longest_list)
      refuse("the header has " + std::to_string(n) +
             (tag == dimensions  ? " dimensions"
              : tag == variables ? " variables"
                                 : " attributes") +
             ", more than " + std::to_string(longest_list));
    return n;
  }

  /// a b bytes, and the end of bytes that begin at `first`; both must be within the file.
  std::uint64_t product(std::uint64_t a, std::uint64_t b) const {
    if (a != 0 && b > size() / a) refuse_cut_short();
    return a * b;
  }
  std::uint64_t end_of(std::uint64_t first, std::uint64_t bytes) const {
    if (first > size() || bytes > size() - first) refuse_cut_short();
    return first + bytes;
  }

 private:
  [[noreturn]] void refuse_cut_short() const {
    refuse("the file is cut short: its header needs more than " + std::to_string(size()) + " bytes");
  }
  std::size_t left() const { return size() - place_; }
  void skip(std::uint64_t bytes) {
    if (bytes > left()) refuse_cut_short();
    place_ += bytes;
  }
  std::uint64_t number(std::size_t width) {
    skip(width);
    std::uint64_t out = 0;
    for (const char byte : bytes_.substr(place_ - width, width))
      out = out << 8 | static_cast<unsigned char>(byte);
    return out;
  }

  std::string_view bytes_;
  std::size_t place_ = 0, count_width_ = 4, offset_width_ = 8;
};

// The bytes of a number of an external type, NC_BYTE = 1 to NC_UINT64 = 11.
std::uint64_t size_of_type(std::uint32_t type) {
  constexpr std::array<std::uint64_t, 12> sizes{0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
  if (type == 0 || type >= sizes.size())
    refuse("number type " + std::to_string(type) + " in the header is not supported");
  return sizes[type];
}

void check_attributes(Reader& reader) {
  for (std::uint64_t n = reader.list(attributes, 3); n > 0; --n) {
    reader.skip_name();
    const std::uint64_t size = size_of_type(reader.word());
    reader.skip_padded(reader.count(), size);
  }
}

// The position of a variable's values (of one record, if it has records), and of that entry in the header.
struct Extent {
  std::uint64_t begin = 0, bytes = 0;
  bool records = false;
  std::size_t told = 0;
};

// The length of a dimension, 0 for records, and the position of that entry in the header.
struct Length {
  std::uint64_t points = 0;
  std::size_t told = 0;
};

struct Head {
  std::uint64_t records = 0;
  std::vector<Length> lengths;
  std::vector<Extent> extents;  // of the variables
};

Extent take_variable(Reader& reader, const std::vector<Length>& lengths) {
  Extent out;
  reader.skip_name();
  std::uint64_t cells = 1;
  const std::uint64_t rank = reader.count();
  if (rank > highest_rank)
    refuse("the header has a variable of " + std::to_string(rank) + " dimensions, more than " +
           std::to_string(highest_rank));
  for (std::uint64_t d = 0; d < rank; ++d) {
    const std::uint64_t id = reader.count();
    if (id >= lengths.size()) refuse("the header is damaged: a variable has an unknown dimension");
    if (d == 0 && lengths[id].points == 0)
      out.records = true;
    else
      cells = reader.product(cells, lengths[id].points);
  }
  check_attributes(reader);
  out.bytes = reader.product(cells, size_of_type(reader.word()));
  reader.count();
  out.told = reader.place();
  out.begin = reader.offset();
  return out;
}

Head take_head(Reader& reader) {
  Head out;
  out.records = reader.count();
  for (std::uint64_t n = reader.list(dimensions, 2); n > 0; --n) {
    reader.skip_name();
    const std::size_t told = reader.place();
    out.lengths.push_back({reader.count(), told});
  }
  check_attributes(reader);
  for (std::uint64_t n = reader.list(variables, 7); n > 0; --n)
    out.extents.push_back(take_variable(reader, out.lengths));
  return out;
}

// The end of all values. Each record holds all variables with records, padded if there are several. An
// unknown number of records reaches to the end of the file.
std::uint64_t end_of_values(const Reader& reader, const Head& head) {
  std::uint64_t end = 0, record = 0, last = 0, in_records = 0;
  for (const Extent& e : head.extents)
    if (e.records) {
      record += padded(last = e.bytes);
      ++in_records;
    } else {
      end = std::max(end, reader.end_of(e.begin, e.bytes));
    }
  if (head.records == 0 || in_records == 0) return end;
  if (head.records == reader.greatest_count()) return reader.size();
  const std::uint64_t before = reader.product(head.records - 1, in_records == 1 ? last : record);
  for (const Extent& e : head.extents)
    if (e.records) end = std::max(end, reader.end_of(e.begin, before + e.bytes));
  return end;
}

void put(std::string& file, std::size_t at, std::uint64_t number, std::size_t width) {
  for (std::size_t i = width; i > 0; --i, number >>= 8) file[at + i - 1] = static_cast<char>(number & 0xff);
}

}  // namespace

void check_classic_head(std::string_view bytes) {
  Reader reader(bytes);
  const std::uint64_t values = end_of_values(reader, take_head(reader));
  refuse_rest(bytes.substr(std::min(padded(std::max(values, reader.place())), bytes.size())), "dataset");
}

std::string resized_head(std::string file, const std::vector<std::uint64_t>& lengths,
                         const std::vector<std::uint64_t>& bytes) {
  Reader reader(file);
  const Head small = take_head(reader);
  const std::size_t width = reader.count_width();
  for (std::size_t d = 0; d < small.lengths.size(); ++d)
    put(file, small.lengths[d].told, lengths.at(d), width);
  std::uint64_t begin = reader.place();
  file.resize(begin);
  for (const bool records : {false, true})
    for (std::size_t v = 0; v < small.extents.size(); ++v) {
      const Extent& e = small.extents[v];
      if (e.records != records) continue;
      const std::uint64_t size = padded(bytes.at(v));
      put(file, e.told - width, std::min(size, reader.greatest_count()), width);
      put(file, e.told, begin, 8);
      begin += size;
    }
  return file;
}

}  // namespace asperity
