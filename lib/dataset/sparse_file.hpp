/// A file in memory, without a name of its own, of which only what has been written takes room.
#pragma once

#include <cerrno>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace asperity {

class SparseFile {
 public:
  SparseFile() : fd_(::memfd_create("dataset", MFD_CLOEXEC)) {
    if (fd_ < 0) throw std::system_error(errno, std::generic_category(), "a file in memory");
  }
  ~SparseFile() {
    if (fd_ >= 0) ::close(fd_);
  }
  SparseFile(SparseFile&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  SparseFile(const SparseFile&) = delete;
  SparseFile& operator=(const SparseFile&) = delete;

  /// By which this process can open it.
  std::string name() const { return "/proc/self/fd/" + std::to_string(fd_); }
  std::size_t size() const { return static_cast<std::size_t>(::lseek(fd_, 0, SEEK_END)); }
  void append(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t put = ::write(fd_, bytes.data(), bytes.size());
      if (put <= 0) throw std::system_error(errno, std::generic_category(), "a file in memory");
      bytes.remove_prefix(static_cast<std::size_t>(put));
    }
  }
  void clear() const {
    if (::ftruncate(fd_, 0) != 0 || ::lseek(fd_, 0, SEEK_SET) != 0)
      throw std::system_error(errno, std::generic_category(), "a file in memory");
  }
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
