/// Bytes of a file, and the check for surplus bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace asperity {

/// Bytes that grow in place; memory is not touched before it is filled.
class Bytes {
 public:
  Bytes() = default;
  /// A file mapped read-only. Throws std::system_error where it cannot be opened or mapped.
  static Bytes mapped(const std::string& path);
  ~Bytes();
  Bytes(Bytes&& other) noexcept;
  Bytes(const Bytes&) = delete;
  Bytes& operator=(Bytes&& other) noexcept;

  operator std::string_view() const { return {data_, size_}; }
  std::size_t size() const { return size_; }
  /// Room for `more` bytes after the present ones, initially zero; add() takes how many were written.
  char* room(std::size_t more);
  void add(std::size_t more) { size_ += more; }

 private:
  void grow(std::size_t capacity);

  char* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

/// Throws DataError(variable, …) with the number of bytes that follow a dataset or a map, unless all are
/// zeros of padding: of two files that `cat` joins, the second would otherwise be ignored.
void refuse_rest(std::string_view rest, const std::string& variable);

}  // namespace asperity
