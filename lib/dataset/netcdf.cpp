#include "dataset/netcdf.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>

#include <netcdf.h>
#include <netcdf_mem.h>

#include "dataset/axis_order.hpp"
#include "dataset/classic_head.hpp"
#include "dataset/conventions.hpp"
#include "dataset/mapped_file.hpp"
#include "dataset/netcdf_types.hpp"
#include "dataset/rest.hpp"

namespace asperity {

using namespace netcdf;

namespace {

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
std::size_t most_made_of(std::size_t bytes) {
  constexpr std::size_t most_inflated = 1032;
  return std::min(bytes, SIZE_MAX / 4 / most_inflated) * most_inflated;
}

void refuse_if_thin(const std::vector<Header>& headers, std::size_t bytes) {
  std::size_t left = most_made_of(bytes);
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

// How a file is read: the values of variables that lie on all of the deferred dimensions are not; all others are held
// so many times.
struct Extent {
  std::size_t bytes = 0;  // of the file
  std::vector<std::string> deferred = {};
  MemoryBound memory = {};
  int times = 1;
  bool whole = true;  // a variable will be taken out at once
};

// The values so many times, and the largest variable as doubles where a whole one will be taken out.
void refuse_if_large(const std::vector<Header>& headers, const Extent& extent) {
  double values = 0, most = 0;
  for (const Header& h : headers) {
    if (lies_on(h.variable, extent.deferred)) continue;
    values += static_cast<double>(h.bytes);
    most = std::max(most, static_cast<double>(h.elements));
  }
  const double doubles = extent.whole ? sizeof(double) * most : 0;
  extent.memory.require(extent.times * values + doubles, "dataset");
}

Dataset read_dataset(int file, const Extent& extent) {
  refuse_groups(file);
  int dimensions = 0, variables = 0, attributes = 0;
  check(nc_inq(file, &dimensions, &variables, &attributes, nullptr), "it cannot be read");
  Dataset out;
  out.dimensions = read_dimensions(file, dimensions);
  out.attributes = read_attributes(file, NC_GLOBAL, attributes);
  std::vector<Header> headers;
  headers.reserve(static_cast<std::size_t>(variables));
  for (int v = 0; v < variables; ++v) headers.push_back(read_header(file, v, out.dimensions));
  classic(file) ? refuse_if_cut_short(headers, extent.bytes) : refuse_if_thin(headers, extent.bytes);
  refuse_if_large(headers, extent);
  for (int v = 0; v < variables; ++v) {
    Header& header = headers[static_cast<std::size_t>(v)];
    const bool stays = lies_on(header.variable, extent.deferred);
    header.variable.values = allocate(header.type, stays ? 0 : header.elements, header.variable.name);
    if (!stays && header.elements > 0) read_values(file, v, header.variable, extent.bytes);
    out.variables.push_back(std::move(header.variable));
  }
  return out;
}

bool is_netcdf4(std::string_view bytes) { return bytes.starts_with("\x89HDF\r\n\x1a\n"); }

// Where the superblock of an HDF5 file says that it ends (HDF5 File Format Specification 3.0, II.A); of one that is not
// understood, all of it: the library refuses it.
std::size_t end_of_hdf5(std::string_view bytes) {
  const auto byte = [&](std::size_t i) {
    return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u;
  };
  const unsigned version = byte(8), width = byte(version < 2 ? 13 : 9);
  const std::size_t base = version == 0 ? 24 : version == 1 ? 28 : 12, at = base + 2 * width;
  if (version > 3 || (width != 4 && width != 8) || at + width > bytes.size()) return bytes.size();
  std::uint64_t end = 0;
  for (std::size_t i = width; i-- > 0;) end = end << 8 | byte(at + i);
  return std::min<std::uint64_t>(end, bytes.size());
}

// What the library would take on trust, or not look at.
void check_extent(std::string_view bytes) {
  if (bytes.starts_with("CDF")) return check_classic_head(bytes);
  if (is_netcdf4(bytes)) refuse_rest(bytes.substr(end_of_hdf5(bytes)), "dataset");
}

int open_in_memory(std::string_view bytes, Handle& file) {
  const int status =
      nc_open_mem("dataset", NC_NOWRITE, bytes.size(), const_cast<char*>(bytes.data()), &file.id);
  file.open = status == NC_NOERR;
  return status;
}

int open_on_disk(const std::string& path, Handle& file) {
  const int status = nc_open(path.c_str(), NC_NOWRITE, &file.id);
  file.open = status == NC_NOERR;
  return status;
}

// In memory the library reads a head by pieces, and answers EPERM for a file that ends within one, though the head does
// not: then there is more to read of zeros.
constexpr std::size_t piece = 1 << 14;

std::string_view with_room(Bytes& bytes) { return {bytes.room(piece) - bytes.size(), bytes.size() + piece}; }

Dataset decode_here(std::string_view bytes, Extent extent) {
  std::string longer;
  Handle file;
  int status = open_in_memory(bytes, file);
  if (status == EPERM) {
    (longer = bytes).resize(bytes.size() + piece);
    status = open_in_memory(longer, file);
  }
  if (status == EPERM) refuse_cut_short("its header", bytes.size());
  check(status, "it cannot be read");
  extent.bytes = bytes.size();
  return read_dataset(file.id, extent);
}

std::atomic<DoneApart> apart = nullptr;

// The same dataset in a classic format, made where the HDF5 library does no harm: it is there twice, here as there.
Bytes classic_from(std::string_view netcdf4, DoneApart done_apart, const MemoryBound& memory, bool whole) {
  constexpr std::size_t bytes_a_second = 5'000'000, library = 64 << 20;
  const WorkLimits limits{.seconds = static_cast<unsigned>(2 + netcdf4.size() / bytes_a_second),
                          .memory = library + std::min(2 * most_made_of(netcdf4.size()), memory.left())};
  Bytes out = done_apart(
      [&](const auto& sink) {
        write_netcdf(decode_here(netcdf4, {.memory = memory, .times = 2, .whole = whole}), sink);
      },
      limits, "dataset");
  memory.require(static_cast<double>(out.size()), "dataset");
  return out;
}

}  // namespace

void read_netcdf4_apart(DoneApart done_apart) { apart = done_apart; }

bool looks_like_netcdf(std::string_view bytes) {
  return bytes.starts_with("CDF\001") || bytes.starts_with("CDF\002") || bytes.starts_with("CDF\005") ||
         is_netcdf4(bytes);
}

Dataset decode_netcdf(std::string_view bytes, const MemoryBound& memory) {
  if (bytes.empty()) refuse("it is empty");
  if (!looks_like_netcdf(bytes)) refuse("it is no NetCDF file");
  check_extent(bytes);
  const DoneApart done_apart = apart;
  if (is_netcdf4(bytes) && done_apart != nullptr) {
    const Bytes classic = classic_from(bytes, done_apart, memory, true);
    return decode_netcdf(classic, memory.beside(classic.size()));
  }
  return in_own_order(with_plain_values(decode_here(bytes, {.memory = memory})));
}

NetcdfFile::NetcdfFile(const std::string& path, const std::vector<std::string>& deferred,
                       const MemoryBound& memory) {
  const MappedFile mapped(path);
  check_extent(mapped.bytes());
  if (const DoneApart done_apart = apart; done_apart != nullptr && is_netcdf4(mapped.bytes()))
    classic_.emplace(classic_from(mapped.bytes(), done_apart, memory, false));
  Handle file;
  check(classic_ ? open_in_memory(with_room(*classic_), file) : open_on_disk(path, file),
        path + " cannot be read");
  const MemoryBound left = memory.beside(classic_ ? classic_->size() : 0);
  dataset_ = read_dataset(file.id, {classic_ ? classic_->size() : mapped.bytes().size(), deferred, left});
  for (const Variable& variable : dataset_.variables) conventions_.emplace_back(variable);
  dataset_ = with_plain_values(std::move(dataset_));
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
  return conventions_.at(static_cast<std::size_t>(id)).unpacked(std::move(out));
}

std::string netcdf_version() {
  const std::string version = nc_inq_libvers();
  return "NetCDF " + version.substr(0, version.find(' '));
}

}  // namespace asperity
