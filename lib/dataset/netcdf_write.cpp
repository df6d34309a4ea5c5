#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "dataset/classic_head.hpp"
#include "dataset/netcdf.hpp"
#include "dataset/unread.hpp"

namespace asperity {
namespace {

using namespace classic;

std::size_t places_of(const Dataset& dataset, const Variable& variable) {
  std::size_t places = 1;
  for (const std::string& name : variable.dimensions) {
    const Index length = dataset.length(name);
    if (length < 0) throw DataError(variable.name, "its dimension " + name + " is unknown");
    places *= static_cast<std::size_t>(length);
  }
  return places;
}

bool needs_cdf5(const Dataset& dataset) {
  auto any = [](const Attributes& attributes) {
    return std::ranges::any_of(attributes, [](const Attribute& a) { return classic::needs_cdf5(a.values); });
  };
  constexpr std::size_t cdf2_limit = 0xFFFFFFFFu - 3;
  constexpr Index cdf2_length = 0x7FFFFFFF - 3;
  for (const Dimension& d : dataset.dimensions)
    if (d.length > cdf2_length) return true;
  for (std::size_t v = 0; v < dataset.variables.size(); ++v) {
    const Variable& variable = dataset.variables[v];
    const bool last = v + 1 == dataset.variables.size();
    if (classic::needs_cdf5(variable.values) || any(variable.attributes)) return true;
    if (!last && places_of(dataset, variable) * element_size(variable.values) > cdf2_limit) return true;
  }
  return any(dataset.attributes);
}

// As the format defines names: printable, without /, and no blank at the end.
void check_name(const std::string& name) {
  const auto byte = [](char c) { return static_cast<unsigned char>(c); };
  const bool illegal =
      std::ranges::any_of(name, [&](char c) { return byte(c) < ' ' || c == '/' || c == 127; });
  const unsigned char first = name.empty() ? 0 : byte(name[0]);
  if (illegal || !(std::isalnum(first) || first == '_' || first > 127) || name.back() == ' ')
    throw DataError(name, "is no name that a NetCDF file may have in it");
  if (name.size() > longest_name)
    throw DataError("dataset", "a name of " + std::to_string(name.size()) + " bytes is too long");
}

// A header in the making.
class HeadWriter {
 public:
  HeadWriter(const Dataset& dataset, std::size_t least) : dataset_(dataset), wide_(needs_cdf5(dataset)) {
    bytes_ = wide_ ? "CDF\005" : "CDF\002";
    count(0);  // records
    dimensions_part();
    attributes_part(dataset.attributes);
    begin(variables, dataset.variables.size());
    std::set<std::string_view> names;
    for (const Variable& v : dataset.variables) {
      if (!names.insert(v.name).second) throw DataError(v.name, "is twice in the dataset");
      variable_part(v);
    }
    bytes_.resize(std::max(bytes_.size(), padded(least)));
    place_values();
  }
  std::string bytes() && { return std::move(bytes_); }

 private:
  void word(std::uint32_t number) { append_big_endian(bytes_, std::span<const std::uint32_t>(&number, 1)); }
  void wide_word(std::uint64_t number) {
    append_big_endian(bytes_, std::span<const std::uint64_t>(&number, 1));
  }
  void count(std::uint64_t number) { wide_ ? wide_word(number) : word(static_cast<std::uint32_t>(number)); }
  void pad() { bytes_.resize(padded(bytes_.size())); }
  void name(const std::string& text) {
    check_name(text);
    count(text.size());
    bytes_ += text;
    pad();
  }
  void begin(Tag tag, std::size_t n) {
    if (n > longest_list)
      throw DataError("dataset", "it has " + std::to_string(n) + kind_of(tag) + ", more than " +
                                     std::to_string(longest_list));
    word(n > 0 ? tag : absent);
    count(n);
  }

  void dimensions_part() {
    begin(dimensions, dataset_.dimensions.size());
    std::set<std::string_view> names;
    for (const Dimension& d : dataset_.dimensions) {
      if (!names.insert(d.name).second) throw DataError(d.name, "is twice among the dimensions");
      name(d.name);
      count(static_cast<std::uint64_t>(d.length));
    }
    if (std::ranges::count(dataset_.dimensions, 0, &Dimension::length) > 1)
      throw DataError("dataset", "more than one dimension has the length 0");
  }
  void attributes_part(const Attributes& list) {
    begin(attributes, list.size());
    for (const auto& [key, values] : list) {
      name(key);
      word(type_of(values));
      count(asperity::count(values));
      std::visit([&](const auto& v) { append_big_endian(bytes_, std::span(v.data(), v.size())); }, values);
      pad();
    }
  }
  // The bytes of a variable, or of one of its records: there are none as yet.
  std::uint64_t size_of(const Variable& v) const {
    std::uint64_t out = element_size(v.values);
    for (const std::string& d : v.dimensions)
      out *= static_cast<std::uint64_t>(std::max<Index>(dataset_.length(d), 1));
    return out;
  }
  void variable_part(const Variable& v) {
    name(v.name);
    if (v.dimensions.size() > highest_rank) throw DataError(v.name, "has too many dimensions");
    count(v.dimensions.size());
    for (std::size_t d = 0; d < v.dimensions.size(); ++d) {
      if (d > 0 && dataset_.length(v.dimensions[d]) == 0)
        throw DataError("dataset", v.name + " has no values along " + v.dimensions[d] +
                                       ", which a classic format allows of a first dimension: remove it");
      count(number_of(v, v.dimensions[d]));
    }
    attributes_part(v.attributes);
    word(type_of(v.values));
    count(std::min(padded(size_of(v)), ~std::uint64_t{0} >> (wide_ ? 0 : 32)));
    begins_.push_back(bytes_.size());
    wide_word(0);
  }
  std::uint64_t number_of(const Variable& variable, const std::string& dimension) const {
    const auto at = std::ranges::find(dataset_.dimensions, dimension, &Dimension::name);
    if (at == dataset_.dimensions.end())
      throw DataError(variable.name, "its dimension " + dimension + " is unknown");
    return static_cast<std::uint64_t>(at - dataset_.dimensions.begin());
  }
  // In order, those with records last.
  void place_values() {
    std::uint64_t at = bytes_.size();
    for (const bool records : {false, true})
      for (std::size_t v = 0; v < begins_.size(); ++v) {
        const Variable& variable = dataset_.variables[v];
        const bool grows = !variable.dimensions.empty() && dataset_.length(variable.dimensions[0]) == 0;
        if (grows != records) continue;
        std::string place;
        append_big_endian(place, std::span<const std::uint64_t>(&at, 1));
        bytes_.replace(begins_[v], place.size(), place);
        at += padded(size_of(variable));
      }
  }

  const Dataset& dataset_;
  bool wide_;
  std::string bytes_;
  std::vector<std::size_t> begins_;  ///< where the header has them
};

using Sink = std::function<void(std::string_view)>;

// In pieces that stay in the cache.
std::size_t write_read(const Values& values, const Sink& sink) {
  constexpr std::size_t piece = 1 << 15;
  return std::visit(
      [&]<class List>(const List& list) {
        using Element = typename List::value_type;
        std::string buffer;
        for (std::size_t first = 0; first < list.size(); first += piece) {
          buffer.clear();
          append_big_endian(
              buffer, std::span<const Element>(list).subspan(first, std::min(piece, list.size() - first)));
          sink(buffer);
        }
        return list.size() * sizeof(Element);
      },
      values);
}

// As they are in the other file.
std::size_t write_unread(const Variable& variable, const Sink& sink) {
  constexpr std::size_t piece = 1 << 18;
  const std::size_t bytes = size_in_memory(variable);
  std::string buffer;
  for (std::size_t first = 0; first < bytes; first += piece) {
    buffer.resize(std::min(piece, bytes - first));
    variable.unread->read(first, std::span(buffer));
    sink(buffer);
  }
  return bytes;
}

}  // namespace

void write_netcdf(const Dataset& dataset, const Sink& sink, std::size_t deferred, std::size_t head_bytes) {
  const std::span all(dataset.variables.begin(), dataset.variables.size() - deferred);
  for (const Variable& v : all)
    if (const std::size_t places = places_of(dataset, v); places != count(v))
      throw std::logic_error(v.name + " has " + std::to_string(count(v)) + " values for " +
                             std::to_string(places) + " places");
  sink(HeadWriter(dataset, head_bytes).bytes());
  for (const Variable& v : all) {
    const std::size_t bytes = v.unread ? write_unread(v, sink) : write_read(v.values, sink);
    sink(std::string_view("\0\0\0", padded(bytes) - bytes));
  }
}

std::string encode_netcdf(const Dataset& dataset, std::size_t deferred, std::size_t head_bytes) {
  std::string bytes;
  write_netcdf(
      dataset, [&](std::string_view piece) { bytes += piece; }, deferred, head_bytes);
  return bytes;
}

std::string encode_values(std::span<const double> values) {
  std::string bytes;
  append_big_endian(bytes, values);
  return bytes;
}

}  // namespace asperity
