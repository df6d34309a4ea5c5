/// Bytes that were read, and those that should not have been there.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace asperity {

/// They grow in place, and no memory is touched before it is filled.
class Bytes {
 public:
  Bytes() = default;
  /// A file's, to be read alone, when they are looked at. None where it cannot be mapped, as a pipe cannot.
  static Bytes mapped(const std::string& path);
  ~Bytes();
  Bytes(Bytes&& other) noexcept;
  Bytes(const Bytes&) = delete;
  Bytes& operator=(Bytes&& other) noexcept;

  operator std::string_view() const { return {data_, size_}; }
  std::size_t size() const { return size_; }
  /// Room for `more` bytes behind those that there are, zeros at first; add() says how many were written.
  char* room(std::size_t more);
  void add(std::size_t more) { size_ += more; }

 private:
  void grow(std::size_t capacity);

  char* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

/// Throws DataError(variable, …) with the number of bytes that follow a dataset or a map unless all are
/// zeros, which pad it: `cat a.nc b.nc | asperity-stats` would else lose the second without a word.
void refuse_rest(std::string_view rest, const std::string& variable);

}  // namespace asperity
