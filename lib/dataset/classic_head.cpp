#include "dataset/classic_head.hpp"

#include <algorithm>
#include <cstring>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "dataset/bytes.hpp"
#include "dataset/unread.hpp"

namespace asperity {
namespace {

using namespace classic;

[[noreturn]] void refuse(const std::string& message) { throw DataError("dataset", message); }
[[noreturn]] void refuse_damaged(const std::string& what = "") { refuse("the header is damaged" + what); }

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
  /// The number of records in a file written as a stream.
  std::uint64_t greatest_count() const { return ~std::uint64_t{0} >> (64 - 8 * count_width_); }

  std::uint64_t count() { return number(count_width_); }
  std::uint32_t word() { return static_cast<std::uint32_t>(number(4)); }
  std::uint64_t offset() { return number(offset_width_); }
  /// n things of `size` bytes, padded to four.
  std::string_view padded_bytes(std::uint64_t n, std::uint64_t size) {
    if (n > left() / size) refuse_cut_short();
    const std::string_view out = bytes_.substr(place_, n * size);
    skip(padded(n * size));
    return out;
  }
  std::string name() {
    const std::uint64_t length = count();
    if (length > longest_name)
      refuse("the header has a name of " + std::to_string(length) + " bytes, more than " +
             std::to_string(longest_name));
    return std::string(padded_bytes(length, 1));
  }
  /// The number of elements of a list, each of which has at least `least` words.
  std::uint64_t list(Tag tag, std::uint64_t least) {
    const std::uint32_t found = word();
    const std::uint64_t n = count();
    if (found != tag && (found != absent || n != 0)) refuse_damaged();
    if (n > left() / (4 * least)) refuse_cut_short();
    if (n > longest_list)
      refuse("the header has " + std::to_string(n) + kind_of(tag) + ", more than " +
             std::to_string(longest_list));
    return n;
  }

  /// a b, or one more than the file has bytes.
  std::uint64_t product(std::uint64_t a, std::uint64_t b) const {
    return a != 0 && b > size() / a ? size() + 1 : a * b;
  }
  /// The end of bytes that begin at `first`, which must be within the file.
  std::uint64_t end_of(std::uint64_t first, std::uint64_t bytes, const std::string& variable) const {
    if (first > size() || bytes > size() - first)
      refuse("the file is cut short: " + variable + " ends beyond its " + std::to_string(size()) + " bytes");
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

// The names of a list, of which readers find one by its name.
class UniqueNames {
 public:
  std::string different(std::string name) {
    if (!names_.insert(name).second) refuse_damaged(": '" + name + "' is twice in it");
    return name;
  }

 private:
  std::set<std::string> names_;
};

// An empty list of the numbers of an external type.
template <std::size_t alternative = 0>
Values list_of(std::uint32_t type) {
  if constexpr (alternative == std::variant_size_v<Values>)
    refuse("number type " + std::to_string(type) + " in the header is not supported");
  else if (type == types[alternative])
    return std::variant_alternative_t<alternative, Values>();
  else
    return list_of<alternative + 1>(type);
}

Values take_values(Reader& reader) {
  Values out = list_of(reader.word());
  const std::uint64_t n = reader.count();
  const std::string_view bytes = reader.padded_bytes(n, element_size(out));
  std::visit(
      [&](auto& list) {
        list.resize(n);
        if (n > 0) std::memcpy(list.data(), bytes.data(), bytes.size());
        swap_bytes(std::span(list.data(), list.size()));
      },
      out);
  return out;
}

Attributes take_attributes(Reader& reader) {
  Attributes out;
  UniqueNames names;
  for (std::uint64_t n = reader.list(classic::attributes, 3); n > 0; --n) {
    std::string name = names.different(reader.name());
    out.add({std::move(name), take_values(reader)});
  }
  return out;
}

// A variable, and where its values are: those of one record, if it has records.
struct Head {
  Variable variable;
  Unread place;
  bool records = false;
};

Head take_variable(Reader& reader, UniqueNames& names, const std::vector<Dimension>& lengths) {
  Head out;
  out.variable.name = names.different(reader.name());
  std::uint64_t cells = 1;
  const std::uint64_t rank = reader.count();
  if (rank > highest_rank)
    refuse("the header has a variable of " + std::to_string(rank) + " dimensions, more than " +
           std::to_string(highest_rank));
  for (std::uint64_t d = 0; d < rank; ++d) {
    const std::uint64_t id = reader.count();
    if (id >= lengths.size()) refuse_damaged(": a variable has an unknown dimension");
    out.variable.dimensions.push_back(lengths[id].name);
    if (lengths[id].length > 0)
      cells = reader.product(cells, static_cast<std::uint64_t>(lengths[id].length));
    else if (d == 0)
      out.records = true;
    else
      refuse_damaged(": " + out.variable.name + " has records, but not along its first dimension");
  }
  out.variable.attributes = take_attributes(reader);
  out.variable.values = list_of(reader.word());
  out.place.slab = reader.product(cells, element_size(out.variable.values));
  out.place.count = cells;
  reader.count();
  out.place.begin = reader.offset();
  return out;
}

// The bytes of a record, in which all variables with records are, padded if there are several.
std::uint64_t bytes_of_record(const std::vector<Head>& heads) {
  std::uint64_t all = 0, last = 0, in_records = 0;
  for (const Head& h : heads)
    if (h.records) {
      all += padded(last = h.place.slab);
      ++in_records;
    }
  return in_records == 1 ? last : all;
}

// Of a file written as a stream, which does not tell their number: to its end.
std::uint64_t records_to_end(const Reader& reader, const std::vector<Head>& heads, std::uint64_t record) {
  std::uint64_t first = reader.size();
  for (const Head& h : heads)
    if (h.records) first = std::min(first, h.place.begin);
  return record > 0 ? (reader.size() - first) / record : 0;
}

// Sets where all records are; returns the end of all values.
std::uint64_t settle(const Reader& reader, std::vector<Head>& heads, std::uint64_t records,
                     std::uint64_t record) {
  std::uint64_t end = 0;
  for (Head& h : heads) {
    const std::uint64_t slabs = h.records ? records : 1;
    h.place.stride = h.records ? record : h.place.slab;
    h.place.count *= slabs;
    if (slabs == 0) continue;
    const std::uint64_t before = reader.product(slabs - 1, h.place.stride);
    end = std::max(end, reader.end_of(h.place.begin, before + h.place.slab, h.variable.name));
  }
  return end;
}

// Bytes of the file, and whose they are.
struct Part {
  std::uint64_t begin, end;
  std::string_view owner;
};

void refuse_shared_bytes(std::vector<Part> parts) {
  std::ranges::sort(parts, {}, &Part::begin);
  for (std::size_t i = 1; i < parts.size(); ++i)
    if (parts[i].begin < parts[i - 1].end)
      refuse_damaged(": " + std::string(parts[i - 1].owner) + " and " + std::string(parts[i].owner) +
                     " share bytes");
}

// No byte belongs to two, so that the values need no more memory than the file has bytes.
void refuse_shared_bytes(const Reader& reader, const std::vector<Head>& heads, std::uint64_t records,
                         std::uint64_t record) {
  std::vector<Part> parts{{0, reader.place(), "the header"}}, in_record;
  for (const Head& h : heads)
    if (const Unread& place = h.place; !h.records || records > 0)
      (h.records ? in_record : parts).push_back({place.begin, place.begin + place.slab, h.variable.name});
  if (!in_record.empty()) {
    const std::uint64_t first = std::ranges::min(in_record, {}, &Part::begin).begin,
                        end = std::ranges::max(in_record, {}, &Part::end).end;
    in_record.push_back({first + record, end + record, "the next record"});
    parts.push_back({first, end + (records - 1) * record, "records"});
    refuse_shared_bytes(std::move(in_record));
  }
  refuse_shared_bytes(std::move(parts));
}

}  // namespace

Dataset read_classic_head(std::string_view bytes, const std::shared_ptr<const Source>& source) {
  Reader reader(bytes);
  Dataset out;
  std::uint64_t records = reader.count();
  constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<Index>::max());
  const bool streamed = records == reader.greatest_count();
  if (records > most && !streamed) refuse_damaged();
  UniqueNames dimension_names, variable_names;
  for (std::uint64_t n = reader.list(classic::dimensions, 2); n > 0; --n) {
    std::string name = dimension_names.different(reader.name());
    const std::uint64_t length = reader.count();
    if (length > most) refuse_damaged();
    out.dimensions.push_back({std::move(name), static_cast<Index>(length)});
  }
  out.attributes = take_attributes(reader);
  std::vector<Head> heads;
  for (std::uint64_t n = reader.list(classic::variables, 7); n > 0; --n)
    heads.push_back(take_variable(reader, variable_names, out.dimensions));
  const std::uint64_t record = bytes_of_record(heads);
  if (streamed) records = records_to_end(reader, heads, record);
  std::uint64_t end = std::max<std::uint64_t>(settle(reader, heads, records, record), reader.place());
  if (streamed && record > 0) end = reader.size();
  refuse_shared_bytes(reader, heads, records, record);
  refuse_rest(bytes.substr(std::min(padded(end), bytes.size())), "dataset");
  for (Dimension& d : out.dimensions)
    if (d.length == 0) d.length = static_cast<Index>(std::min<std::uint64_t>(records, reader.size()));
  for (Head& h : heads) {
    h.place.source = source;
    h.variable.unread = std::make_shared<const Unread>(std::move(h.place));
    out.variables.push_back(std::move(h.variable));
  }
  return out;
}

}  // namespace asperity
