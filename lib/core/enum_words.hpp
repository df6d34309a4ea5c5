/// Enumerations by their words, one a value and in the order of the values.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace asperity {

template <std::size_t n>
using EnumWords = std::array<std::string_view, n>;

template <std::size_t n, class Enum>
std::string_view word_of(const EnumWords<n>& words, Enum value) {
  return words[static_cast<std::size_t>(value)];
}

/// Throws ParameterError(parameter) where the word is none of them.
template <class Enum, std::size_t n>
Enum enum_named(const EnumWords<n>& words, std::string_view word, const char* parameter) {
  std::string all;
  for (std::size_t i = 0; i < n; ++i) {
    if (word == words[i]) return static_cast<Enum>(i);
    all += (i == 0 ? "" : i + 1 == n ? " and " : ", ") + std::string(words[i]);
  }
  throw ParameterError(parameter, "'" + std::string(word) + "' is none of " + all);
}

}  // namespace asperity
