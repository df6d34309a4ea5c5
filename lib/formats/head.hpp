/// Heads of files: lines of a key, a separator and a value.
///
/// A head is a view of the file's text and is searched anew for each key, so that it takes no memory, however
/// long it is. Upper and lower case are the same in a key; the first line of a key counts.
#pragma once

#include <string_view>

#include "core/field.hpp"

namespace asperity {

class Head {
 public:
  /// `separators` are the characters of which the first one ends the key.
  Head(std::string_view lines, std::string_view separators) : lines_(lines), separators_(separators) {}

  std::size_t lines() const;
  bool has(std::string_view key) const { return text(key).data() != nullptr; }
  /// The value without blanks at its ends, "" where there is none.
  std::string_view text(std::string_view key) const;
  /// Throw DataError("map", …) where it is no finite number, no positive or no whole one from 0 on.
  double number(std::string_view key) const;
  double positive(std::string_view key) const;
  Index count(std::string_view key) const;

 private:
  std::string_view lines_, separators_;
};

/// The lines up to the first that ends a head, which is called `end`, taken off the bytes.
std::string_view take_head(std::string_view& bytes, bool (*ends)(std::string_view line),
                           std::string_view end);

}  // namespace asperity
