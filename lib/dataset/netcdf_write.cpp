#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <system_error>

#include <netcdf.h>

#include "dataset/netcdf.hpp"
#include "dataset/netcdf_types.hpp"
#include "dataset/sparse_file.hpp"

namespace asperity {

using namespace netcdf;

namespace {

// A positive status is the system's own: no room, or a limit.
void write_checked(int status, const std::string& what) {
  check_for_want_of_memory(status);
  if (status > 0) throw std::system_error(status, std::generic_category(), what);
  check(status, what);
}

bool needs_cdf5_type(const Values& values) {
  switch (type_of(values)) {
    case NC_UBYTE:
    case NC_USHORT:
    case NC_UINT:
    case NC_INT64:
    case NC_UINT64:
      return true;
    default:
      return false;
  }
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
  for (std::size_t v = 0; v < dataset.variables.size(); ++v) {
    const Variable& variable = dataset.variables[v];
    const bool last = v + 1 == dataset.variables.size();
    if (needs_cdf5_type(variable.values) || any(variable.attributes)) return true;
    if (!last && places_of(dataset, variable) * element_size(variable.values) > cdf2_limit) return true;
  }
  return any(dataset.attributes);
}

void write_attributes(int file, int variable, const Attributes& attributes) {
  for (const auto& [name, values] : attributes) {
    const void* p = data(values);
    write_checked(nc_put_att(file, variable, name.c_str(), type_of(values), count(values), p), name);
  }
}

void refuse_wrong_count(const Dataset& dataset, const Variable& variable) {
  const std::size_t places = places_of(dataset, variable);
  if (places != count(variable.values))
    throw std::logic_error(variable.name + " has " + std::to_string(count(variable.values)) + " values for " +
                           std::to_string(places) + " places");
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

int format_of(const Dataset& dataset) { return needs_cdf5(dataset) ? NC_64BIT_DATA : NC_64BIT_OFFSET; }

// A new file as large as it will be, of which only the header is there. Ids count from 0.
void write_header(int file, const Dataset& dataset) {
  write_checked(nc_set_fill(file, NC_NOFILL, nullptr), "fill");
  for (const Dimension& d : dataset.dimensions) {
    int id = -1;
    write_checked(nc_def_dim(file, d.name.c_str(), static_cast<std::size_t>(d.length), &id),
                  "dimension " + d.name);
  }
  for (const Variable& v : dataset.variables) define(file, v);
  write_attributes(file, NC_GLOBAL, dataset.attributes);
  write_checked(nc_enddef(file), "header");
}

std::size_t padded(std::size_t bytes) { return (bytes + 3) / 4 * 4; }

// Variables follow the header in order, each padded to four bytes, the last one perhaps not.
std::string header_of(const Dataset& dataset) {
  const SparseFile sparse;
  Handle file;
  std::size_t buffer = 1 << 20;
  write_checked(nc__create(sparse.name().c_str(), NC_CLOBBER | format_of(dataset), 0, &buffer, &file.id),
                "create");
  file.open = true;
  write_header(file.id, dataset);
  file.open = false;
  write_checked(nc_close(file.id), "close");
  std::size_t values = 0, last = 0;
  for (const Variable& variable : dataset.variables) {
    values += padded(last);
    last = places_of(dataset, variable) * element_size(variable.values);
  }
  return sparse.first((sparse.size() - values - last) / 4 * 4);
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

// Piece by piece, so that what is on its way stays in the cache.
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
  sink(std::string_view("\0\0\0", padded(bytes) - bytes));
}

// The header and the values of all variables but the last `deferred`.
void write_part(const Dataset& dataset, std::size_t deferred,
                const std::function<void(std::string_view)>& sink) {
  for (std::size_t v = 0; v + deferred < dataset.variables.size(); ++v)
    refuse_wrong_count(dataset, dataset.variables[v]);
  sink(header_of(dataset));
  for (std::size_t v = 0; v + deferred < dataset.variables.size(); ++v)
    write_values(dataset.variables[v].values, sink);
}

}  // namespace

void write_netcdf(const Dataset& dataset, const std::function<void(std::string_view)>& sink) {
  write_part(dataset, 0, sink);
}

std::string encode_netcdf(const Dataset& dataset) { return encode_netcdf_head(dataset, 0); }

std::string encode_netcdf_head(const Dataset& dataset, std::size_t deferred) {
  std::string bytes;
  write_part(dataset, deferred, [&](std::string_view piece) { bytes += piece; });
  return bytes;
}

std::string encode_values(std::span<const double> values) {
  std::string bytes;
  append_big_endian(bytes, values);
  return bytes;
}

}  // namespace asperity
