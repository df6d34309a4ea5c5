#include "dataset/netcdf4.hpp"

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <new>
#include <string>
#include <type_traits>

#include <netcdf.h>
#include <netcdf_mem.h>

#include "core/error.hpp"
#include "core/memory.hpp"

namespace asperity::netcdf {
namespace {

[[noreturn]] void refuse(const std::string& message) { throw DataError("dataset", message); }

void check_for_want_of_memory(int status) {
  if (status == NC_ENOMEM || status == ENOMEM) throw std::bad_alloc();
}

void check(int status, const std::string& what) {
  check_for_want_of_memory(status);
  if (status != NC_NOERR) refuse(what + ": " + nc_strerror(status));
}

// An open dataset, closed when an exception passes.
class Handle {
 public:
  Handle() = default;
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (open) nc_abort(id);
  }
  int id = -1;
  bool open = false;
};

// One for each alternative of Values, in their order.
constexpr nc_type external_types[] = {NC_CHAR, NC_BYTE,  NC_UBYTE,  NC_SHORT, NC_USHORT, NC_INT,
                                      NC_UINT, NC_INT64, NC_UINT64, NC_FLOAT, NC_DOUBLE};
static_assert(std::size(external_types) == std::variant_size_v<Values>);

// n elements of an external type; searches the alternatives of Values from `alternative`.
template <std::size_t alternative = 0>
Values allocate(nc_type type, std::size_t n, const std::string& name) {
  if constexpr (alternative == std::variant_size_v<Values>) {
    refuse(name + " is of a type that only NetCDF-4 has");
  } else {
    using List = std::variant_alternative_t<alternative, Values>;
    if (type != external_types[alternative]) return allocate<alternative + 1>(type, n, name);
    if constexpr (std::is_same_v<List, std::string>)
      return std::string(n, '\0');
    else
      return large_list<typename List::value_type>(n);
  }
}

void* data(Values& values) {
  return std::visit([](auto& v) { return static_cast<void*>(v.data()); }, values);
}

// Only NetCDF-4 has attributes of type string; a single one becomes plain text.
Values read_string_attribute(int file, int variable, const std::string& name, std::size_t n) {
  if (n != 1) refuse("attribute " + name + " is a list of strings, which is not supported");
  char* text = nullptr;
  check(nc_get_att_string(file, variable, name.c_str(), &text), name);
  std::string copy = text ? text : "";
  nc_free_string(1, &text);
  return copy;
}

Attributes read_attributes(int file, int variable, int number) {
  Attributes out;
  for (int a = 0; a < number; ++a) {
    char name[NC_MAX_NAME + 1] = {};
    check(nc_inq_attname(file, variable, a, name), "attribute");
    nc_type type = 0;
    std::size_t n = 0;
    check(nc_inq_att(file, variable, name, &type, &n), name);
    if (type == NC_STRING) {
      out.set_values(name, read_string_attribute(file, variable, name, n));
      continue;
    }
    Values values = allocate(type, n, name);
    if (n > 0) check(nc_get_att(file, variable, name, data(values)), name);
    out.set_values(name, std::move(values));
  }
  return out;
}

std::vector<Dimension> read_dimensions(int file, int number) {
  std::vector<Dimension> out;
  for (int d = 0; d < number; ++d) {
    char name[NC_MAX_NAME + 1] = {};
    std::size_t length = 0;
    check(nc_inq_dim(file, d, name, &length), "dimension");
    out.push_back({name, static_cast<Index>(length)});
  }
  return out;
}

// Name, type, dimensions and attributes, without the values.
struct Header {
  Variable variable;
  nc_type type = 0;
  std::size_t elements = 1, bytes = 0;
};

Header read_header(int file, int id, const std::vector<Dimension>& dimensions) {
  Header out;
  char name[NC_MAX_NAME + 1] = {};
  int rank = 0, attributes = 0;
  int dims[NC_MAX_VAR_DIMS] = {};
  check(nc_inq_var(file, id, name, &out.type, &rank, dims, &attributes), "variable");
  out.variable.name = name;
  for (int d = 0; d < rank; ++d) {
    const Dimension& dimension = dimensions.at(static_cast<std::size_t>(dims[d]));
    const auto length = static_cast<std::size_t>(dimension.length);
    out.variable.dimensions.push_back(dimension.name);
    if (length > 0 && out.elements > SIZE_MAX / 16 / length)
      refuse(out.variable.name + " has an impossible size");
    out.elements *= length;
  }
  std::size_t size = 0;
  check(nc_inq_type(file, out.type, nullptr, &size), out.variable.name);
  out.bytes = out.elements * size;
  out.variable.attributes = read_attributes(file, id, attributes);
  return out;
}

// Wrong sizes in a header must not cause allocation.
void refuse_impossible_sizes(const std::vector<Header>& headers, std::size_t bytes) {
  std::size_t left = most_made_of(bytes);
  for (const Header& h : headers) {
    if (h.bytes > left)
      refuse(h.variable.name + " claims " + std::to_string(h.bytes) + " bytes, more than a file of " +
             std::to_string(bytes) + " bytes can hold");
    left -= h.bytes;
  }
}

void refuse_groups(int file) {
  int groups = 0;
  if (nc_inq_grps(file, &groups, nullptr) == NC_NOERR && groups > 0)
    refuse("groups of NetCDF-4 are not supported: move the variables to the root group");
}

void refuse_if_large(const std::vector<Header>& headers, const Extent& extent) {
  double values = 0, most = 0;
  for (const Header& h : headers) {
    values += static_cast<double>(h.bytes);
    most = std::max(most, static_cast<double>(h.elements));
  }
  require_memory(extent.times * values, most, extent.memory);
}

Dataset read_dataset(int file, const Extent& extent, std::size_t bytes) {
  refuse_groups(file);
  int dimensions = 0, variables = 0, attributes = 0;
  check(nc_inq(file, &dimensions, &variables, &attributes, nullptr), "the file cannot be read");
  Dataset out;
  out.dimensions = read_dimensions(file, dimensions);
  out.attributes = read_attributes(file, NC_GLOBAL, attributes);
  std::vector<Header> headers;
  headers.reserve(static_cast<std::size_t>(variables));
  for (int v = 0; v < variables; ++v) headers.push_back(read_header(file, v, out.dimensions));
  refuse_impossible_sizes(headers, bytes);
  refuse_if_large(headers, extent);
  for (int v = 0; v < variables; ++v) {
    Header& header = headers[static_cast<std::size_t>(v)];
    Values& values = header.variable.values;
    values = allocate(header.type, header.elements, header.variable.name);
    if (header.elements > 0)
      check(nc_get_var(file, v, data(values)), header.variable.name + " cannot be read");
    out.variables.push_back(std::move(header.variable));
  }
  return out;
}

}  // namespace

}  // namespace asperity::netcdf

using namespace asperity::netcdf;

void asperity_read_netcdf4(std::string_view bytes, const Extent& extent, asperity::Dataset& out) {
  Handle file;
  const int status =
      nc_open_mem("dataset", NC_NOWRITE, bytes.size(), const_cast<char*>(bytes.data()), &file.id);
  file.open = status == NC_NOERR;
  check(status, "the file cannot be read");
  out = read_dataset(file.id, extent, bytes.size());
}
