#include "dataset/bytes.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "core/error.hpp"
#include "core/os.hpp"

namespace asperity {

Bytes::~Bytes() {
  if (data_) ::munmap(data_, capacity_);
}

Bytes::Bytes(Bytes&& other) noexcept { *this = std::move(other); }

Bytes& Bytes::operator=(Bytes&& other) noexcept {
  std::swap(data_, other.data_);
  std::swap(size_, other.size_);
  std::swap(capacity_, other.capacity_);
  return *this;
}

Bytes Bytes::mapped(const std::string& path) {
  Bytes out;
  struct stat status {};
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  void* data = fd < 0 || ::fstat(fd, &status) != 0 ? MAP_FAILED : nullptr;
  if (data != MAP_FAILED && status.st_size > 0) {
    out.size_ = out.capacity_ = static_cast<std::size_t>(status.st_size);
    data = ::mmap(nullptr, out.size_, PROT_READ, MAP_PRIVATE, fd, 0);
  }
  const int error = errno;
  if (fd >= 0) ::close(fd);
  if (data == MAP_FAILED) throw std::system_error(error, std::generic_category(), path);
  out.data_ = static_cast<char*>(data);
  return out;
}

char* Bytes::room(std::size_t more) {
  constexpr std::size_t least = std::size_t{64} << 20;
  if (size_ + more > capacity_) grow(std::max({size_ + more, 2 * capacity_, least}));
  return data_ + size_;
}

// Reserves address space only: untouched pages take no memory.
void Bytes::grow(std::size_t capacity) {
  data_ = static_cast<char*>(os::grown(data_, capacity_, capacity));
  capacity_ = capacity;
  os::prefer_large_pages(data_, capacity_);
}

void refuse_rest(std::string_view rest, const std::string& variable) {
  if (std::ranges::all_of(rest, [](char c) { return c == '\0'; })) return;
  throw DataError(variable,
                  std::to_string(rest.size()) +
                      " bytes follow its end, perhaps a second one: give each in its own file or stream");
}

}  // namespace asperity
