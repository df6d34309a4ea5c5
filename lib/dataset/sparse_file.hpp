/// A file in memory, without a name of its own, of which only what has been written takes room.
#pragma once

#include <cerrno>
#include <string>
#include <sys/mman.h>
#include <system_error>
#include <unistd.h>

namespace asperity {

class SparseFile {
 public:
  SparseFile() : fd_(::memfd_create("dataset", MFD_CLOEXEC)) {
    if (fd_ < 0) throw std::system_error(errno, std::generic_category(), "a file in memory");
  }
  ~SparseFile() { ::close(fd_); }
  SparseFile(const SparseFile&) = delete;
  SparseFile& operator=(const SparseFile&) = delete;

  /// By which this process can open it.
  std::string name() const { return "/proc/self/fd/" + std::to_string(fd_); }
  std::size_t size() const { return static_cast<std::size_t>(::lseek(fd_, 0, SEEK_END)); }
  /// Its first n bytes.
  std::string first(std::size_t n) const {
    std::string bytes(n, '\0');
    for (std::size_t at = 0; at < n;) {
      const ssize_t got = ::pread(fd_, bytes.data() + at, n - at, static_cast<off_t>(at));
      if (got <= 0) throw std::system_error(errno, std::generic_category(), "a file in memory");
      at += static_cast<std::size_t>(got);
    }
    return bytes;
  }

 private:
  int fd_;
};

}  // namespace asperity
