/// Datasets as NetCDF.
///
/// Files are written as CDF-2 (64-bit offset), which every reader opens, or as CDF-5 if a variable other than
/// the last exceeds 4 GiB or a type needs it. These classic formats are read and written here, NetCDF-4 is
/// read by the NetCDF library.
///
/// A NetCDF-4 file is an HDF5 file, and a malicious one can make the HDF5 library hang, crash or use up all
/// memory. Such files are read in the calling process, unless it sets another way with read_netcdf4_apart, as
/// Asperity's tools do: a separate process then returns the whole file in a classic format. It is refused if
/// it needs more than 2 s of processor time plus 1 s per 5 MB, or more memory than 64 MiB plus the smaller of
/// the limit and twice the largest inflated size of the file (1032 times its bytes).
///
/// Memory    of reading, the values (twice for NetCDF-4) and the largest variable once more as doubles, plus
///           the bytes of a file that is not on disk. The header gives this before allocation.
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

/// Work that passes bytes to its sink.
using WorkOfBytes = std::function<void(const std::function<void(std::string_view)>& sink)>;

/// Limits of work in a separate process.
struct WorkLimits {
  unsigned seconds = 1;    ///< of processor time
  std::size_t memory = 0;  ///< bytes beyond those of the calling process
};

/// Runs work in a sandbox and returns its bytes; throws DataError(variable, …) when the work threw one, with
/// its text, or exceeded a limit.
using DoneApart = Bytes (*)(const WorkOfBytes& work, WorkLimits limits, const std::string& variable);

/// Sets how NetCDF-4 is read from now on, in all threads. Null, the default: in this process.
void read_netcdf4_apart(DoneApart apart);

/// Whether bytes begin as a NetCDF file does.
bool looks_like_netcdf(std::string_view bytes);

/// The dataset with Asperity's order of axes (dataset/axis_order.hpp) and plain values
/// (dataset/conventions.hpp). Throws DataError ("dataset") when the bytes are not NetCDF, are cut short, hold
/// more than one dataset or a type unknown to CDF-5, or need more memory than allowed.
Dataset decode_netcdf(std::string_view bytes, const MemoryBound& memory = {});
/// The same of a file on disk, or of bytes that are kept: values of plain variables on two dimensions or more
/// stay there, unread (dataset/unread.hpp), but must fit the memory. No such file: std::system_error.
Dataset open_netcdf(const std::string& path, const MemoryBound& memory = {});
Dataset open_netcdf(Bytes bytes, const MemoryBound& memory = {});

/// The bytes before the values of the last `deferred` variables, for a dataset too large for memory. These
/// variables are of doubles and hold no values yet; their values follow in the file as from encode_values,
/// variable by variable. The header takes `head_bytes` at least, zeros at its end: another one, of other
/// attributes, may take its place.
std::string encode_netcdf(const Dataset& dataset, std::size_t deferred = 0, std::size_t head_bytes = 0);
/// Passes the same bytes to `sink` in pieces, without a copy of the values.
void write_netcdf(const Dataset& dataset, const std::function<void(std::string_view)>& sink,
                  std::size_t deferred = 0, std::size_t head_bytes = 0);
/// Doubles as in the file, big-endian.
std::string encode_values(std::span<const double> values);

/// The name and version of the library of NetCDF-4.
std::string netcdf_version();

}  // namespace asperity
