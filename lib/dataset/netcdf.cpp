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

[[noreturn]] void refuse(const std::string& message) { throw DataError("dataset", message); }

std::atomic<DoneApart> apart = nullptr;

auto netcdf4_reader() {
  static const auto read = ASPERITY_FROM_MODULE("asperity_netcdf4", asperity_read_netcdf4);
  return read;
}

// The dataset in a classic format, converted in a separate process; it needs its memory twice, as here.
Bytes classic_from(std::string_view netcdf4, DoneApart done_apart, const MemoryBound& memory, bool whole) {
  load_netcdf4();
  constexpr std::size_t bytes_a_second = 5'000'000, library = 64 << 20;
  const WorkLimits limits{.seconds = static_cast<unsigned>(2 + netcdf4.size() / bytes_a_second),
                          .memory = library + std::min(2 * most_made_of(netcdf4.size()), memory.left())};
  Bytes out = done_apart(
      [&](const auto& sink) {
        write_netcdf(read_netcdf4(netcdf4, {.memory = memory, .times = 2, .whole = whole}), sink);
      },
      limits, "dataset");
  memory.require(static_cast<double>(out.size()), "dataset");
  return out;
}

bool on_both_axes(const Variable& v) {
  return std::ranges::count(v.dimensions, "x") > 0 && std::ranges::count(v.dimensions, "y") > 0;
}

// Of the variables that are read, or may be.
template <class Which>
void require_room(const Dataset& data, const MemoryBound& memory, Which which) {
  double values = 0, most = 0;
  for (const Variable& v : data.variables)
    if (which(v)) {
      values += static_cast<double>(size_in_memory(v));
      most = std::max(most, static_cast<double>(count(v)));
    }
  require_memory(values, most, {.memory = memory});
}

constexpr auto every = [](const Variable&) { return true; };

void check_kind(std::string_view bytes) {
  if (bytes.empty()) refuse("the file is empty");
  if (!looks_like_netcdf(bytes)) refuse("the file is not NetCDF");
  if (is_netcdf4(bytes)) refuse_rest(bytes.substr(end_of_hdf5(bytes)), "dataset");
}

Dataset unread(Bytes classic) {
  const std::string_view bytes = classic;
  return read_classic_head(bytes, source_of(std::move(classic)));
}

// As in the file; a classic one unread. The memory that NetCDF-4 takes is checked here.
Dataset in_file(const std::string& path, MemoryBound& memory, bool whole) {
  const std::shared_ptr<const Source> source = source_on_disk(path);
  const Bytes mapped = Bytes::mapped(path);
  check_kind(mapped);
  if (!is_netcdf4(mapped)) return read_classic_head(mapped, source);
  const DoneApart done_apart = apart;
  if (done_apart == nullptr) return read_netcdf4(mapped, {.memory = memory, .whole = whole});
  Bytes classic = classic_from(mapped, done_apart, memory, whole);
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

void netcdf::require_memory(double values, double largest, const Extent& extent) {
  extent.memory.require(values + (extent.whole ? sizeof(double) * largest : 0), "dataset");
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
    const Bytes classic = classic_from(bytes, done_apart, memory, true);
    return decode_netcdf(classic, memory.beside(classic.size()));
  }
  Dataset out = is_netcdf4(bytes) ? read_netcdf4(bytes, {.memory = memory})
                                  : read_classic_head(bytes, source_of(bytes));
  require_room(out, memory, every);
  load(out);
  return to_native_axes(with_plain_values(std::move(out)));
}

Dataset open_netcdf(const std::string& path, const MemoryBound& memory) {
  MemoryBound left = memory;
  Dataset out = in_file(path, left, true);
  require_room(out, left, every);
  return settled(std::move(out));
}

Dataset open_netcdf(Bytes bytes, const MemoryBound& memory) {
  check_kind(bytes);
  if (is_netcdf4(bytes)) return decode_netcdf(bytes, memory);
  Dataset out = unread(std::move(bytes));
  require_room(out, memory, every);
  return settled(std::move(out));
}

NetcdfFile::NetcdfFile(const std::string& path, MemoryBound memory)
    : in_file_(in_file(path, memory, false)), dataset_(in_file_) {
  for (Variable& v : dataset_.variables)
    if (on_both_axes(v)) {
      std::visit([](auto& values) { values = {}; }, v.values);
      v.unread.reset();
    }
  require_room(in_file_, memory, [](const Variable& v) { return !on_both_axes(v); });
  load(dataset_);
  dataset_ = with_plain_values(std::move(dataset_));
}

Values NetcdfFile::part(std::string_view variable, std::string_view along, Index first, Index count) const {
  const Variable& v = in_file_.at(variable);
  Index before = 1, length = 0, behind = 1;
  for (const std::string& dimension : v.dimensions)
    if (dimension == along)
      length = in_file_.length(dimension);
    else
      (length > 0 ? behind : before) *= in_file_.length(dimension);
  if (length == 0) return Conventions(v).unpacked(values_of(v, 0, asperity::count(v)));
  Values out = values_of(v, 0, 0);
  std::visit(
      [&]<class List>(List& list) {
        for (Index i = 0; i < before; ++i) {
          const auto from = static_cast<std::size_t>((i * length + first) * behind);
          Values next = values_of(v, from, static_cast<std::size_t>(count * behind));
          const List& part = std::get<List>(next);
          if (before == 1)
            list = std::move(std::get<List>(next));
          else
            list.insert(list.end(), part.begin(), part.end());
        }
      },
      out);
  return Conventions(v).unpacked(std::move(out));
}

std::string netcdf_version() { return "NetCDF " ASPERITY_NETCDF_VERSION; }

}  // namespace asperity
