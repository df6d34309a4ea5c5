#include "dataset/bytes.hpp"

#include <algorithm>
#include <new>
#include <sys/mman.h>
#include <utility>

namespace asperity {

Bytes::~Bytes() {
  if (data_) ::munmap(data_, capacity_);
}

Bytes::Bytes(Bytes&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)),
      size_(std::exchange(other.size_, 0)),
      capacity_(std::exchange(other.capacity_, 0)) {}

char* Bytes::room(std::size_t more) {
  constexpr std::size_t least = std::size_t{64} << 20;
  if (size_ + more > capacity_) grow(std::max({size_ + more, 2 * capacity_, least}));
  return data_ + size_;
}

// Address space alone: what is not touched takes no memory.
void Bytes::grow(std::size_t capacity) {
  void* grown = data_ ? ::mremap(data_, capacity_, capacity, MREMAP_MAYMOVE)
                      : ::mmap(nullptr, capacity, PROT_READ | PROT_WRITE,
                               MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (grown == MAP_FAILED) throw std::bad_alloc();
  data_ = static_cast<char*>(grown);
  capacity_ = capacity;
  ::madvise(data_, capacity_, MADV_HUGEPAGE);
}

}  // namespace asperity
