/// Datasets as NetCDF, the only door to that library.
///
/// Written is CDF-2 (64-bit offset), which every reader opens, or CDF-5 when a variable other than the last
/// exceeds 4 GiB or a type needs it. Read is every format that the installed library knows.
///
/// A NetCDF-4 file is an HDF5 file, of which a hostile one makes the HDF5 library hang, crash or take all
/// memory. It is read in the process that asks, unless that has said how to read it apart
/// (read_netcdf4_apart), as Asperity's tools do. Then it comes back in a classic format, whole, and is
/// refused when that takes more than 2 s of processor time and 1 s for each 5 MB of it, or more memory than
/// 64 MiB and the lesser of what is allowed and twice what deflating can make of its bytes (1032 times as
/// many).
///
/// Memory    of reading, the values, those of NetCDF-4 twice, and the largest variable once more as doubles;
///           the file's bytes come on top where they are not on disk. The head tells it, before it is taken.
///
/// R. Rew, G. Davis, NetCDF: an interface for scientific data access, IEEE CG&A 10 (1990) 76-82.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/bytes.hpp"
#include "dataset/conventions.hpp"
#include "dataset/dataset.hpp"
#include "dataset/memory_bound.hpp"

namespace asperity {

/// Work that hands bytes to its sink.
using WorkOfBytes = std::function<void(const std::function<void(std::string_view)>& sink)>;

/// Bounds of work that is done apart.
struct WorkLimits {
  unsigned seconds = 1;    ///< of processor time
  std::size_t memory = 0;  ///< bytes beyond those of the process that asks
};

/// The bytes of work done where it can do no harm; throws DataError(variable, …) with the work's own words
/// where it threw one, and where it broke a limit.
using DoneApart = Bytes (*)(const WorkOfBytes& work, WorkLimits limits, const std::string& variable);

/// How NetCDF-4 is read from now on, in all threads. Null, as at first: in this process.
void read_netcdf4_apart(DoneApart apart);

/// Whether bytes begin as a NetCDF file does.
bool looks_like_netcdf(std::string_view bytes);

/// In Asperity's order of axes (dataset/axis_order.hpp), its values plain (dataset/conventions.hpp). Throws
/// DataError ("dataset") when the bytes are no NetCDF, are cut short, more than one dataset, hold a type that
/// CDF-5 cannot, or take more memory than is allowed.
Dataset decode_netcdf(std::string_view bytes, const MemoryBound& memory = {});

/// A file on disk, its axes as they are and its values plain, of which variables on both x and y are read by
/// parts; of NetCDF-4 read apart they all are in memory.
class NetcdfFile {
 public:
  /// Reads all else; throws DataError as decode_netcdf does.
  explicit NetcdfFile(const std::string& path, const MemoryBound& memory = {});
  ~NetcdfFile();
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;

  const Dataset& dataset() const { return dataset_; }
  /// The values of a variable at `count` indices from `first` on of the dimension `along`.
  Values part(std::string_view variable, std::string_view along, Index first, Index count) const;

 private:
  Bytes classic_;  ///< what a NetCDF-4 file held
  int id_ = -1;
  Dataset dataset_;
  std::vector<Conventions> conventions_;  ///< of its variables as the file has them
};

/// Of a dataset too large for memory, piece by piece: the bytes before the values of its last `deferred`
/// variables, which are of doubles and hold none yet. In the file these values follow as encode_values makes
/// them, variable by variable, and nothing else. The length depends on names, types and numbers of values
/// alone, so that a head with other values of attributes may replace an earlier one.
std::string encode_netcdf(const Dataset& dataset, std::size_t deferred = 0);
/// The same bytes, handed to `sink` piece by piece: the values are never there twice.
void write_netcdf(const Dataset& dataset, const std::function<void(std::string_view)>& sink,
                  std::size_t deferred = 0);
/// Doubles as the file holds them, big-endian.
std::string encode_values(std::span<const double> values);

/// The library's name and version.
std::string netcdf_version();

}  // namespace asperity
