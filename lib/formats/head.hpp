/// Headers of files: lines of a key, a separator and a value.
///
/// A header is a view of the file's text and is searched for each key, so that it needs no memory of its own.
/// Keys ignore case. A key with two values is refused.
#pragma once

#include <string_view>

#include "core/field.hpp"

namespace asperity {

class Head {
 public:
  /// The first of the characters `separators` ends the key.
  Head(std::string_view lines, std::string_view separators) : lines_(lines), separators_(separators) {}

  std::size_t lines() const;
  bool has(std::string_view key) const;
  /// The value without blanks at its ends, "" if there is none. Throws DataError("map", …) if there are two.
  std::string_view text(std::string_view key) const;
  /// Throw DataError("map", …) also unless the value is a finite number, a positive one, a whole one from 0.
  double number(std::string_view key) const;
  double positive(std::string_view key) const;
  Index count(std::string_view key) const;

 private:
  /// The next value, removed from the lines with all above it; null if there is none.
  std::string_view take(std::string_view& lines, std::string_view key) const;

  std::string_view lines_, separators_;
};

/// Removes the header from the bytes: the lines up to the first for which ends(line) holds.
std::string_view take_head(std::string_view& bytes, bool (*ends)(std::string_view line));

}  // namespace asperity
