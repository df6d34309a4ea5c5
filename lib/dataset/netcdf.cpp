#include "dataset/netcdf.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <netcdf.h>
#include <netcdf_mem.h>

#include "dataset/classic_head.hpp"
#include "dataset/mapped_file.hpp"
#include "dataset/netcdf_types.hpp"
#include "dataset/sparse_file.hpp"

namespace asperity {

using namespace netcdf;

namespace {

// An open dataset, closed without a word when an exception passes.
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

// ---- reading ----

std::string attribute_name(int file, int variable, int index) {
  char name[NC_MAX_NAME + 1] = {};
  check(nc_inq_attname(file, variable, index, name), "attribute");
  return name;
}

// NetCDF-4 alone has attributes of type string; one of them is plain text elsewhere.
Values read_string_attribute(int file, int variable, const std::string& name, std::size_t n) {
  if (n != 1) refuse(name + " is a list of strings, which only NetCDF-4 has");
  char* text = nullptr;
  check(nc_get_att_string(file, variable, name.c_str(), &text), name);
  std::string copy = text ? text : "";
  nc_free_string(1, &text);
  return copy;
}

Attributes read_attributes(int file, int variable, int number) {
  Attributes out;
  for (int a = 0; a < number; ++a) {
    const std::string name = attribute_name(file, variable, a);
    nc_type type = 0;
    std::size_t n = 0;
    check(nc_inq_att(file, variable, name.c_str(), &type, &n), name);
    if (type == NC_STRING) {
      out.set_values(name, read_string_attribute(file, variable, name, n));
      continue;
    }
    Values values = allocate(type, n, name);
    if (n > 0) check(nc_get_att(file, variable, name.c_str(), data(values)), name);
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

// Name, type, dimensions and attributes; the values stay in the file.
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
      refuse(out.variable.name + " claims an impossible size");
    out.elements *= length;
  }
  std::size_t size = 0;
  check(nc_inq_type(file, out.type, nullptr, &size), out.variable.name);
  out.bytes = out.elements * size;
  out.variable.attributes = read_attributes(file, id, attributes);
  return out;
}

bool classic(int file) {
  int format = 0;
  check(nc_inq_format(file, &format), "format");
  return format == NC_FORMAT_CLASSIC || format == NC_FORMAT_64BIT_OFFSET || format == NC_FORMAT_CDF5;
}

[[noreturn]] void refuse_cut_short(const std::string& name, std::size_t bytes) {
  refuse(name + " ends beyond the " + std::to_string(bytes) + " bytes that there are: the file is cut short");
}

// A classic file holds its values as they are: fewer bytes than values is a file cut short, and a header that
// lies about its sizes must not make us allocate them.
void refuse_if_cut_short(const std::vector<Header>& headers, std::size_t bytes) {
  std::size_t needed = 0;
  for (const Header& h : headers) {
    needed += h.bytes;
    if (h.bytes > bytes || needed > bytes)
      refuse(h.variable.name + " ends beyond the " + std::to_string(bytes) +
             " bytes that there are: it is cut short");
  }
}

// In memory the library answers EPERM where a variable reaches beyond the last byte.
void read_values(int file, int id, Variable& variable, std::size_t bytes) {
  const int status = nc_get_var(file, id, data(variable.values));
  if (status == EPERM) refuse_cut_short(variable.name, bytes);
  check(status, variable.name + " cannot be read");
}

void refuse_groups(int file) {
  int groups = 0;
  if (nc_inq_grps(file, &groups, nullptr) == NC_NOERR && groups > 0)
    refuse("it has groups, which only NetCDF-4 has");
}

// NetCDF-4 deflates, and need not hold what was never written: no more is made of its bytes than deflating could.
void refuse_if_thin(const std::vector<Header>& headers, std::size_t bytes) {
  constexpr std::size_t most_inflated = 1032;
  std::size_t left = bytes > SIZE_MAX / most_inflated ? SIZE_MAX : bytes * most_inflated;
  for (const Header& h : headers) {
    if (h.bytes > left)
      refuse(h.variable.name + " claims " + std::to_string(h.bytes) + " bytes, more than a file of " +
             std::to_string(bytes) + " can hold");
    left -= h.bytes;
  }
}

bool lies_on(const Variable& variable, const std::vector<std::string>& dimensions) {
  return !dimensions.empty() && std::ranges::all_of(dimensions, [&](const std::string& name) {
    return std::ranges::find(variable.dimensions, name) != variable.dimensions.end();
  });
}

// Of a file of `bytes`; the values of variables that lie on all of the deferred dimensions are not read.
Dataset read_dataset(int file, std::size_t bytes, const std::vector<std::string>& deferred) {
  refuse_groups(file);
  int dimensions = 0, variables = 0, attributes = 0;
  check(nc_inq(file, &dimensions, &variables, &attributes, nullptr), "it cannot be read");
  Dataset out;
  out.dimensions = read_dimensions(file, dimensions);
  out.attributes = read_attributes(file, NC_GLOBAL, attributes);
  std::vector<Header> headers;
  for (int v = 0; v < variables; ++v) headers.push_back(read_header(file, v, out.dimensions));
  classic(file) ? refuse_if_cut_short(headers, bytes) : refuse_if_thin(headers, bytes);
  for (int v = 0; v < variables; ++v) {
    Header& header = headers[static_cast<std::size_t>(v)];
    const bool stays = lies_on(header.variable, deferred);
    header.variable.values = allocate(header.type, stays ? 0 : header.elements, header.variable.name);
    if (!stays && header.elements > 0) read_values(file, v, header.variable, bytes);
    out.variables.push_back(std::move(header.variable));
  }
  return out;
}

// ---- writing ----

// A positive status is the system's own: no room, or a limit.
void write_checked(int status, const std::string& what) {
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

// What a classic file of this head has at least, for beyond its end the library reads zeros: laid out once more, without
// values, less what the last variable is padded by.
std::size_t laid_out_size(int file, const Dataset& dataset) {
  int format = 0;
  check(nc_inq_format(file, &format), "format");
  const int mode = format == NC_FORMAT_CDF5           ? NC_64BIT_DATA
                   : format == NC_FORMAT_64BIT_OFFSET ? NC_64BIT_OFFSET
                                                      : 0;
  const SparseFile sparse;
  Handle copy;
  write_checked(nc_create(sparse.name().c_str(), NC_CLOBBER | mode, &copy.id), "create");
  copy.open = true;
  write_header(copy.id, dataset);
  copy.open = false;
  write_checked(nc_close(copy.id), "close");
  return sparse.size() - 3;
}

}  // namespace

bool looks_like_netcdf(std::string_view bytes) {
  return bytes.starts_with("CDF\001") || bytes.starts_with("CDF\002") || bytes.starts_with("CDF\005") ||
         bytes.starts_with("\x89HDF\r\n\x1a\n");
}

Dataset decode_netcdf(std::string_view bytes) {
  if (bytes.empty()) refuse("it is empty");
  if (!looks_like_netcdf(bytes)) refuse("it is no NetCDF file");
  if (bytes.starts_with("CDF")) check_classic_head(bytes);
  Handle file;
  const int status =
      nc_open_mem("dataset", NC_NOWRITE, bytes.size(), const_cast<char*>(bytes.data()), &file.id);
  if (status == EPERM) refuse_cut_short("its header", bytes.size());
  check(status, "it cannot be read");
  file.open = true;
  return read_dataset(file.id, bytes.size(), {});
}

NetcdfFile::NetcdfFile(const std::string& path, const std::vector<std::string>& deferred) {
  if (const MappedFile mapped(path); mapped.bytes().starts_with("CDF")) check_classic_head(mapped.bytes());
  Handle file;
  check(nc_open(path.c_str(), NC_NOWRITE, &file.id), path + " cannot be read");
  file.open = true;
  const std::size_t bytes = std::filesystem::file_size(path);
  dataset_ = read_dataset(file.id, bytes, deferred);
  if (classic(file.id) && bytes < laid_out_size(file.id, dataset_))
    refuse_cut_short("its last variable", bytes);
  id_ = file.id;
  file.open = false;
}

NetcdfFile::~NetcdfFile() { nc_close(id_); }

Values NetcdfFile::rows(std::string_view variable, Index first, Index count) const {
  return part(variable, 0, first, count);
}

Values NetcdfFile::columns(std::string_view variable, Index first, Index count) const {
  return part(variable, dataset_.at(variable).dimensions.size() - 1, first, count);
}

Values NetcdfFile::part(std::string_view variable, std::size_t along, Index first, Index count) const {
  int id = -1;
  nc_type type = 0;
  const std::string name(variable);
  check(nc_inq_varid(id_, name.c_str(), &id), name);
  check(nc_inq_vartype(id_, id, &type), name);
  std::vector<std::size_t> start, counts;
  std::size_t elements = 1;
  for (const std::string& dimension : dataset_.at(variable).dimensions) {
    const bool here = counts.size() == along;
    start.push_back(here ? static_cast<std::size_t>(first) : 0);
    counts.push_back(static_cast<std::size_t>(here ? count : dataset_.length(dimension)));
    elements *= counts.back();
  }
  Values out = allocate(type, elements, name);
  check(nc_get_vara(id_, id, start.data(), counts.data(), data(out)), name + " cannot be read");
  return out;
}

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

std::string netcdf_version() {
  const std::string version = nc_inq_libvers();
  return "NetCDF " + version.substr(0, version.find(' '));
}

}  // namespace asperity
