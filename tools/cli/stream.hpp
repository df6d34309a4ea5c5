/// Bytes in and out: a file by name, or "-" for standard input and output.
///
/// A file gets its name when it is complete. Until then it has none, or a temporary one next to its own where
/// the system has no unnamed files: nobody sees half of it, and an interrupted run leaves nothing behind. It
/// replaces a former file with its mode, and its owner and group where permitted; a write-protected file is
/// not replaced, as with cp. A device, a pipe or an open file (cli/output_name.hpp) is written from its
/// present position. Every write is checked, also the last flush; failures are std::system_error with a name.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "dataset/bytes.hpp"
#include "dataset/memory_bound.hpp"

namespace asperity::cli {

using asperity::Bytes;

/// All of a file, or of standard input, "-"; of one that gzip has made, its content. Throws DataError where
/// it is empty or larger than what is left of `memory`, before that is taken.
Bytes read_all(const std::string& name, const MemoryBound& memory);
/// The same of an open file, which may be empty.
Bytes read_to_end(int fd, const std::string& name, const MemoryBound& memory);
/// The first few, enough to know NetCDF by, of a regular file; none of any other.
std::string first_bytes(const std::string& name);
void write_to(int fd, std::string_view bytes, const std::string& name);
/// Before the work: throws where OutputFile would refuse this name, but opens nothing.
void require_writable(const std::string& name);
void write_all(const std::string& name, std::string_view bytes);

/// The temporary name of a file that will replace another; it does not outlive the process. The signals HUP,
/// INT, QUIT, PIPE, TERM, XCPU and XFSZ remove it first, unless they are ignored or handled already. Only
/// SIGKILL and a crash leave it.
class TemporaryName {
 public:
  /// The name is free to be given to a file from now on.
  explicit TemporaryName(std::string path);
  ~TemporaryName();  ///< removes the file, if it still has the name
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;

  const char* path() const { return path_.c_str(); }
  /// The file takes the place of `target`; false, with errno, where it cannot.
  bool replace(const std::string& target);
  /// The name is somebody else's: it is left alone.
  void forget();

 private:
  std::string path_;
  bool known_ = true;
};

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
  /// Writes after what has been written, `at` bytes from the beginning: in any order, where rewrite() works.
  void write_at(std::string_view bytes, std::int64_t at);
  /// Flushes, and gives the file its name.
  void close();

 private:
  void open_replacement();
  template <class Make>
  bool make_temporary(const Make& make);

  std::string name_;
  std::string target_;  ///< of a file that is to be replaced
  std::optional<TemporaryName> temporary_;
  int fd_ = -1;
  bool rewritable_ = false;
};

/// Whether a name is a pattern for several, and for one of several that happens to be alone.
bool has_place_for_number(const std::string& pattern);
/// "surface_%04d.nc" and 7 → "surface_0007.nc". Throws ParameterError(option, …) for a pattern without %d.
std::string numbered(const std::string& option, const std::string& pattern, std::int64_t number);

/// Throws ParameterError("output", …) if `what` would go to a terminal; `hint` ends the message.
void refuse_terminal(const std::string& output, const std::string& what = "a dataset",
                     const std::string& hint = "");
bool stdin_is_terminal();
bool stdin_is_device();  ///< a terminal, or /dev/null: nobody pipes anything in
bool stdout_is_terminal();
bool stderr_is_terminal();
/// Width of the terminal there, from 40 to `most`; 80 where there is none.
std::size_t columns_of(int fd, std::size_t most = 100);

}  // namespace asperity::cli
