/// Bytes in and out: a file by name, or "-" for standard input and output.
///
/// A named file comes into being when it is whole: until then it has no name, or, where the file system knows no
/// files without one, a temporary name beside its own (cli/temporary.hpp). Nobody ever sees half of it, and a program
/// that is interrupted leaves nothing behind. Every write is checked, the last flush too; failures are
/// std::system_error with the file's name.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cli/temporary.hpp"
#include "grid/memory_bound.hpp"

namespace asperity::cli {

/// Bytes that were read. They grow in place, and no memory is touched before it is filled.
class Bytes {
 public:
  Bytes() = default;
  ~Bytes();
  Bytes(Bytes&& other) noexcept;
  Bytes(const Bytes&) = delete;
  Bytes& operator=(const Bytes&) = delete;

  operator std::string_view() const { return {data_, size_}; }
  std::size_t size() const { return size_; }
  /// Room for `more` bytes behind those that there are; add() says how many have been written there.
  char* room(std::size_t more);
  void add(std::size_t more) { size_ += more; }

 private:
  void grow(std::size_t capacity);

  char* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

/// All of a file, or of standard input, "-". Throws DataError(name, …) where it is larger than what is left of `memory`,
/// before that is taken.
Bytes read_all(const std::string& name, const MemoryBound& memory);
void write_all(const std::string& name, std::string_view bytes);

/// A file that is written piece by piece.
class OutputFile {
 public:
  explicit OutputFile(std::string name);
  ~OutputFile();  ///< without close(): as if nothing had been written, when the file has a name of its own
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);
  /// Whether rewrite() works: on a regular file, written from its beginning.
  bool rewritable() const { return rewritable_; }
  /// Replaces the first bytes.
  void rewrite(std::string_view bytes);
  /// Writes behind what has been written, `at` bytes from the beginning: in any order, where rewrite() works.
  void write_at(std::string_view bytes, std::int64_t at);
  /// Flushes, and gives the file its name.
  void close();

 private:
  void open_replacement();
  std::string temporary_path() const;

  std::string name_;
  std::string target_;  ///< of a file that is to be replaced
  std::optional<TemporaryName> temporary_;
  int fd_ = -1;
  bool rewritable_ = false;
};

/// One of several files: "surface_%04d.nc" and 7 → "surface_0007.nc". Throws ParameterError(option, …) when the
/// pattern has no place for the number.
std::string numbered(const std::string& option, const std::string& pattern, std::int64_t number);

bool stdin_is_terminal();
bool stdout_is_terminal();
bool stderr_is_terminal();

}  // namespace asperity::cli
