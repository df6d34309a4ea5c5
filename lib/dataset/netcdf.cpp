#include "dataset/netcdf.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>

#include <netcdf.h>
#include <netcdf_mem.h>

#include "dataset/axis_order.hpp"
#include "dataset/classic_head.hpp"
#include "dataset/netcdf_types.hpp"

namespace asperity {

using namespace netcdf;

namespace {

bool is_netcdf4(std::string_view bytes) { return bytes.starts_with("\x89HDF\r\n\x1a\n"); }

// The end of an HDF5 file by its superblock (HDF5 File Format Specification 3.0, II.A). For an unknown
// superblock, all bytes: the library refuses the file.
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

// Checks what the library does not check.
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

// In memory the library reads a header in pieces, and returns EPERM for a file that ends within a piece, even
// if the header is complete: then zeros are appended.
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
  check(status, "the file cannot be read");
  extent.bytes = bytes.size();
  return read_dataset(file.id, extent);
}

std::atomic<DoneApart> apart = nullptr;

// The dataset in a classic format, converted in a separate process; it needs its memory twice, as here.
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
  if (bytes.empty()) refuse("the file is empty");
  if (!looks_like_netcdf(bytes)) refuse("the file is not NetCDF");
  check_extent(bytes);
  const DoneApart done_apart = apart;
  if (is_netcdf4(bytes) && done_apart != nullptr) {
    const Bytes classic = classic_from(bytes, done_apart, memory, true);
    return decode_netcdf(classic, memory.beside(classic.size()));
  }
  return to_native_axes(with_plain_values(decode_here(bytes, {.memory = memory})));
}

NetcdfFile::NetcdfFile(const std::string& path, const MemoryBound& memory) {
  const Bytes mapped = Bytes::mapped(path);
  check_extent(mapped);
  if (const DoneApart done_apart = apart; done_apart != nullptr && is_netcdf4(mapped))
    classic_ = classic_from(mapped, done_apart, memory, false);
  const bool in_memory = classic_.size() > 0;
  Handle file;
  const int status =
      in_memory ? open_in_memory(with_room(classic_), file) : nc_open(path.c_str(), NC_NOWRITE, &file.id);
  check(status, path + " cannot be read");
  file.open = true;
  dataset_ = read_dataset(file.id, {.bytes = in_memory ? classic_.size() : mapped.size(),
                                    .memory = memory.beside(classic_.size()),
                                    .fields_stay = true});
  for (const Variable& variable : dataset_.variables) conventions_.emplace_back(variable);
  dataset_ = with_plain_values(std::move(dataset_));
  id_ = file.id;
  file.open = false;
}

NetcdfFile::~NetcdfFile() { nc_close(id_); }

Values NetcdfFile::part(std::string_view variable, std::string_view along, Index first, Index count) const {
  int id = -1;
  nc_type type = 0;
  const std::string name(variable);
  check(nc_inq_varid(id_, name.c_str(), &id), name);
  check(nc_inq_vartype(id_, id, &type), name);
  std::vector<std::size_t> start, counts;
  std::size_t elements = 1;
  for (const std::string& dimension : dataset_.at(variable).dimensions) {
    const bool here = dimension == along;
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
