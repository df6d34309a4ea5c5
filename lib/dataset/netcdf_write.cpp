#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <system_error>

#include <netcdf.h>
#include <netcdf_mem.h>

#include "dataset/classic_head.hpp"
#include "dataset/netcdf.hpp"
#include "dataset/netcdf_types.hpp"

namespace asperity {

using namespace netcdf;

namespace {

// A positive status is an error of the system: no space, or a limit.
void write_checked(int status, const std::string& what) {
  check_for_want_of_memory(status);
  if (status > 0) throw std::system_error(status, std::generic_category(), what);
  check(status, what);
}

bool needs_cdf5_type(const Values& values) {
  constexpr nc_type newer[] = {NC_UBYTE, NC_USHORT, NC_UINT, NC_INT64, NC_UINT64};
  return std::ranges::find(newer, type_of(values)) != std::end(newer);
}

std::size_t places_of(const Dataset& dataset, const Variable& variable) {
  std::size_t places = 1;
  for (const std::string& name : variable.dimensions)
    places *= static_cast<std::size_t>(dataset.length(name));
  return places;
}

bool needs_cdf5(const Dataset& dataset) {
  auto any = [](const Attributes& attributes) {
    return std::ranges::any_of(attributes, [](const Attribute& a) { return needs_cdf5_type(a.values); });
  };
  constexpr std::size_t cdf2_limit = 0xFFFFFFFFu - 3;
  constexpr Index cdf2_length = 0x7FFFFFFF - 3;
  for (const Dimension& d : dataset.dimensions)
    if (d.length > cdf2_length) return true;
  for (std::size_t v = 0; v < dataset.variables.size(); ++v) {
    const Variable& variable = dataset.variables[v];
    const bool last = v + 1 == dataset.variables.size();
    if (needs_cdf5_type(variable.values) || any(variable.attributes)) return true;
    if (!last && places_of(dataset, variable) * element_size(variable.values) > cdf2_limit) return true;
  }
  return any(dataset.attributes);
}

void write_attributes(int file, int variable, const Attributes& attributes) {
  for (const auto& [name, values] : attributes)
    write_checked(nc_put_att(file, variable, name.c_str(), type_of(values), count(values), data(values)),
                  name);
}

void define(int file, const Variable& variable) {
  std::vector<int> dims;
  for (const std::string& name : variable.dimensions) {
    dims.emplace_back();
    write_checked(nc_inq_dimid(file, name.c_str(), &dims.back()), variable.name + ", dimension " + name);
  }
  int id = -1;
  write_checked(nc_def_var(file, variable.name.c_str(), type_of(variable.values),
                           static_cast<int>(dims.size()), dims.data(), &id),
                variable.name);
  write_attributes(file, id, variable.attributes);
}

// The library would write a file of full size, on disk or in memory. So it writes a small one, with room for
// one value of each variable, or none if there are no records.
std::string small_file_of(const Dataset& dataset) {
  Handle file;
  const int format = needs_cdf5(dataset) ? NC_64BIT_DATA : NC_64BIT_OFFSET;
  write_checked(nc_create_mem("dataset", NC_CLOBBER | format, 1 << 16, &file.id), "create");
  file.open = true;
  write_checked(nc_set_fill(file.id, NC_NOFILL, nullptr), "fill");
  for (const Dimension& d : dataset.dimensions) {
    int id = -1;
    const std::size_t length = d.length > 0 ? 1 : NC_UNLIMITED;
    write_checked(nc_def_dim(file.id, d.name.c_str(), length, &id), "dimension " + d.name);
  }
  for (const Variable& v : dataset.variables) define(file.id, v);
  write_attributes(file.id, NC_GLOBAL, dataset.attributes);
  write_checked(nc_enddef(file.id), "header");
  file.open = false;
  NC_memio bytes{};
  write_checked(nc_close_memio(file.id, &bytes), "close");
  const std::unique_ptr<void, void (*)(void*)> owned(bytes.memory, &std::free);
  return {static_cast<const char*>(bytes.memory), bytes.size};
}

std::string header_of(const Dataset& dataset) {
  std::vector<std::uint64_t> lengths, bytes;
  for (const Dimension& d : dataset.dimensions) lengths.push_back(static_cast<std::uint64_t>(d.length));
  for (const Variable& v : dataset.variables) {
    bytes.push_back(element_size(v.values));
    for (const std::string& name : v.dimensions)
      bytes.back() *= static_cast<std::uint64_t>(std::max<Index>(dataset.length(name), 1));
  }
  return resized_head(small_file_of(dataset), lengths, bytes);
}

template <class Element>
void append_big_endian(std::string& bytes, std::span<const Element> values) {
  const std::size_t before = bytes.size();
  bytes.resize(before + values.size_bytes());
  for (char* at = bytes.data() + before; Element value : values) {
    auto raw = std::bit_cast<std::array<char, sizeof(Element)>>(value);
    if constexpr (std::endian::native == std::endian::little) std::ranges::reverse(raw);
    std::memcpy(at, raw.data(), raw.size());
    at += raw.size();
  }
}

// In pieces that stay in the cache.
void write_values(const Values& values, const std::function<void(std::string_view)>& sink) {
  constexpr std::size_t piece = 1 << 15;
  std::size_t bytes = 0;
  std::visit(
      [&]<class List>(const List& list) {
        using Element = typename List::value_type;
        std::string buffer;
        for (std::size_t first = 0; first < list.size(); first += piece) {
          buffer.clear();
          append_big_endian(
              buffer, std::span<const Element>(list).subspan(first, std::min(piece, list.size() - first)));
          sink(buffer);
        }
        bytes = list.size() * sizeof(Element);
      },
      values);
  sink(std::string_view("\0\0\0", (4 - bytes % 4) % 4));
}

}  // namespace

void write_netcdf(const Dataset& dataset, const std::function<void(std::string_view)>& sink,
                  std::size_t deferred) {
  const std::span variables(dataset.variables.begin(), dataset.variables.size() - deferred);
  for (const Variable& v : variables)
    if (const std::size_t places = places_of(dataset, v); places != count(v.values))
      throw std::logic_error(v.name + " has " + std::to_string(count(v.values)) + " values for " +
                             std::to_string(places) + " places");
  sink(header_of(dataset));
  for (const Variable& v : variables) write_values(v.values, sink);
}

std::string encode_netcdf(const Dataset& dataset, std::size_t deferred) {
  std::string bytes;
  write_netcdf(
      dataset, [&](std::string_view piece) { bytes += piece; }, deferred);
  return bytes;
}

std::string encode_values(std::span<const double> values) {
  std::string bytes;
  append_big_endian(bytes, values);
  return bytes;
}

}  // namespace asperity
