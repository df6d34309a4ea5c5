/// Names of enumerations: enum_words(Enum) has one per value, in the order of the values.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace asperity {

template <std::size_t n>
using EnumWords = std::array<std::string_view, n>;

template <class Enum>
requires requires(Enum value) { enum_words(value); }
std::string_view name_of(Enum value) { return enum_words(value)[static_cast<std::size_t>(value)]; }

/// Throws ParameterError(parameter) for an unknown word.
template <class Enum>
Enum enum_named(std::string_view word, const char* parameter) {
  const auto words = enum_words(Enum{});
  std::string all;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (word == words[i]) return static_cast<Enum>(i);
    all += (i == 0 ? "" : "|") + std::string(words[i]);
  }
  throw ParameterError(parameter, "'" + std::string(word) + "' is none of " + all);
}

}  // namespace asperity
