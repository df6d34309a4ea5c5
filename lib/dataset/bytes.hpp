/// Bytes that were read. They grow in place, and no memory is touched before it is filled.
#pragma once

#include <cstddef>
#include <string_view>

namespace asperity {

class Bytes {
 public:
  Bytes() = default;
  ~Bytes();
  Bytes(Bytes&& other) noexcept;
  Bytes(const Bytes&) = delete;
  Bytes& operator=(const Bytes&) = delete;

  operator std::string_view() const { return {data_, size_}; }
  std::size_t size() const { return size_; }
  /// Room for `more` bytes behind those that there are, zeros at first; add() says how many have been written there.
  char* room(std::size_t more);
  void add(std::size_t more) { size_ += more; }

 private:
  void grow(std::size_t capacity);

  char* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace asperity
