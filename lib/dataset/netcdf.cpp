#include "dataset/netcdf.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "core/error.hpp"
#include "core/module.hpp"
#include "dataset/axis_order.hpp"
#include "dataset/classic_head.hpp"
#include "dataset/conventions.hpp"
#include "dataset/netcdf4.hpp"
#include "dataset/unread.hpp"

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

[[noreturn]] void refuse_file(const std::string& message) { throw DataError("dataset", message); }

std::atomic<DoneApart> apart = nullptr;

auto netcdf4_reader() {
  static const auto read = ASPERITY_FROM_MODULE("asperity_netcdf4", asperity_read_netcdf4);
  return read;
}

// The dataset in a classic format, converted in a separate process; it needs its memory twice, as here.
Bytes classic_from(std::string_view netcdf4, DoneApart done_apart, const MemoryBound& memory) {
  load_netcdf4();
  constexpr std::size_t bytes_a_second = 5'000'000, library = 64 << 20;
  const WorkLimits limits{.seconds = static_cast<unsigned>(2 + netcdf4.size() / bytes_a_second),
                          .memory = library + std::min(2 * most_made_of(netcdf4.size()), memory.left())};
  Bytes out = done_apart(
      [&](const auto& sink) { write_netcdf(read_netcdf4(netcdf4, {.memory = memory, .times = 2}), sink); },
      limits, "dataset");
  memory.require(static_cast<double>(out.size()), "dataset");
  return out;
}

void require_room_for(const Dataset& data, const MemoryBound& memory) {
  double values = 0, most = 0;
  for (const Variable& v : data.variables) {
    values += static_cast<double>(size_in_memory(v));
    most = std::max(most, static_cast<double>(count(v)));
  }
  require_memory(values, most, memory);
}

void check_kind(std::string_view bytes) {
  if (bytes.empty()) refuse_file("the file is empty");
  if (!looks_like_netcdf(bytes)) refuse_file("the file is not NetCDF");
  if (is_netcdf4(bytes)) refuse_rest(bytes.substr(end_of_hdf5(bytes)), "dataset");
}

Dataset unread(Bytes classic) {
  const std::string_view bytes = classic;
  return read_classic_head(bytes, source_of(std::move(classic)));
}

// As in the file; a classic one unread. The memory that NetCDF-4 takes is checked here.
Dataset in_file(const std::string& path, MemoryBound& memory) {
  const std::shared_ptr<const Source> source = source_on_disk(path);
  const Bytes mapped = Bytes::mapped(path);
  check_kind(mapped);
  if (!is_netcdf4(mapped)) return read_classic_head(mapped, source);
  const DoneApart done_apart = apart;
  if (done_apart == nullptr) return read_netcdf4(mapped, {.memory = memory});
  Bytes classic = classic_from(mapped, done_apart, memory);
  memory = memory.beside(classic.size());
  return unread(std::move(classic));
}

// Axes are needed by all, and what is not plain by those who copy it.
Dataset settled(Dataset data) {
  for (Variable& v : data.variables)
    if (v.dimensions.size() < 2) load(v);
  return to_native_axes(with_plain_values(std::move(data)));
}

}  // namespace

void netcdf::load_netcdf4() { netcdf4_reader(); }

Dataset netcdf::read_netcdf4(std::string_view bytes, const Extent& extent) {
  Dataset out;
  netcdf4_reader()(bytes, extent, out);
  return out;
}

void netcdf::require_memory(double values, double largest, const MemoryBound& memory) {
  memory.require(values + sizeof(double) * largest, "dataset");
}

std::size_t netcdf::most_made_of(std::size_t bytes) {
  constexpr std::size_t most_inflated = 1032;
  return std::min(bytes, SIZE_MAX / 4 / most_inflated) * most_inflated;
}

void read_netcdf4_apart(DoneApart done_apart) { apart = done_apart; }

bool looks_like_netcdf(std::string_view bytes) {
  return bytes.starts_with("CDF\001") || bytes.starts_with("CDF\002") || bytes.starts_with("CDF\005") ||
         is_netcdf4(bytes);
}

Dataset decode_netcdf(std::string_view bytes, const MemoryBound& memory) {
  check_kind(bytes);
  const DoneApart done_apart = apart;
  if (is_netcdf4(bytes) && done_apart != nullptr) {
    const Bytes classic = classic_from(bytes, done_apart, memory);
    return decode_netcdf(classic, memory.beside(classic.size()));
  }
  Dataset out = is_netcdf4(bytes) ? read_netcdf4(bytes, {.memory = memory})
                                  : read_classic_head(bytes, source_of(bytes));
  require_room_for(out, memory);
  load(out);
  return to_native_axes(with_plain_values(std::move(out)));
}

Dataset open_netcdf(const std::string& path, const MemoryBound& memory) {
  MemoryBound left = memory;
  Dataset out = in_file(path, left);
  require_room_for(out, left);
  return settled(std::move(out));
}

Dataset open_netcdf(Bytes bytes, const MemoryBound& memory) {
  check_kind(bytes);
  if (is_netcdf4(bytes)) return decode_netcdf(bytes, memory);
  Dataset out = unread(std::move(bytes));
  require_room_for(out, memory);
  return settled(std::move(out));
}

std::string netcdf_version() { return "NetCDF " ASPERITY_NETCDF_VERSION; }

}  // namespace asperity
