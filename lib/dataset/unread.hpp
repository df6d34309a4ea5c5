/// Values of a variable that are left in a file, of a classic NetCDF format, until they are needed.
///
/// A tool needs a few fields of a dataset in which many variables ride along: a kernel, tables of the
/// autocorrelation, volumes of stress. What nobody asks for is copied from file to file in the end, or not at
/// all.
///
/// Memory    of values in pieces, 256 KiB.
/// Errors    a file that has become shorter meanwhile: DataError("dataset").
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "dataset/bytes.hpp"
#include "dataset/dataset.hpp"

namespace asperity {

/// The bytes of a file, at any place and in any order.
class Source {
 public:
  Source() = default;
  virtual ~Source() = default;
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  virtual void read(std::uint64_t at, std::span<char> to) const = 0;
};
/// Bytes in memory, which must outlive the source or belong to it.
std::shared_ptr<const Source> source_of(std::string_view bytes);
std::shared_ptr<const Source> source_of(Bytes bytes);
/// A file on disk, which stays open and may lose its name.
std::shared_ptr<const Source> source_on_disk(const std::string& path);

/// Slabs of bytes, one for each record, a stride apart; without records there is one slab.
struct Unread {
  std::shared_ptr<const Source> source;
  std::uint64_t begin = 0, slab = 0, stride = 0;
  std::size_t count = 0;  ///< of values

  /// Bytes as in the file, from the byte numbered `first` of the values on.
  void read(std::uint64_t first, std::span<char> to) const;
};

/// Number of values, read or not, and bytes of one and of all.
std::size_t count(const Variable& variable);
std::size_t element_size(const Values& values);
std::size_t size_in_memory(const Variable& variable);

/// `count` of the values from `first` on.
Values values_of(const Variable& variable, std::size_t first, std::size_t count);
/// All values in order: those in memory at once, others in pieces.
void in_pieces(const Variable& variable, const std::function<void(const Values&)>& take);
/// Reads values that are still in the file.
void load(Variable& variable);
void load(Dataset& dataset);

}  // namespace asperity
