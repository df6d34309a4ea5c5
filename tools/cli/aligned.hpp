/// Tables for people, on a terminal: columns one below the other, units with prefixes, numbers rounded.
///
/// No line is longer than the terminal is wide: meanings are wrapped, and a table with too many columns
/// continues below with its leading columns repeated.
#pragma once

#include <string>

#include "tools/cli/table.hpp"

namespace asperity::cli {

/// Neighbouring columns of the same unit share a prefix, chosen by their largest modulus. Columns in "SI"
/// have the unit of their row. A value beside its error, "standard_error" or the value's name and "_error",
/// ends where the second digit of the error ends, and so does its interval.
std::string aligned(const Table& table, std::size_t width);
/// Columns quantity, value ± error, 95 % interval, unit, meaning.
std::string aligned(const Parameters& parameters, std::size_t width);

}  // namespace asperity::cli
