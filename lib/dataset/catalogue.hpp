/// What the tools write into a dataset: one table of results, their variables and their global attributes.
///
/// A result is what one run computes together. It rests on another one when it was computed from it:
///
///     kernel ← heights ← contact ← residual, stress          acf, psd ← the field that was measured
///
/// What the table does not name is a user's own.
#pragma once

#include <span>
#include <string_view>

namespace asperity {

/// A name of the table may end in *, which is any rest.
bool fits(std::string_view pattern, std::string_view name);

struct KnownResult {
  std::string_view name, rests_on;  ///< itself, and the results that it rests on, between blanks
  std::string_view prefix;          ///< of its attributes
  std::string_view variables;       ///< its own, between blanks
};

/// What a number is: asked for, computed, said by a solver of itself, or none that a report has a place for.
enum class Role { parameter, result, achieved, other };

struct KnownAttribute {
  std::string_view name;
  Role role;
  /// SI; "sample" counts cells of x and of y, "yes" is 0 or 1, "height" m or, of unit heights, 1; "" of text.
  std::string_view unit;
  std::string_view label;  ///< in words
  bool open = false;       ///< it may be infinite, or not known, which is NaN
};

std::span<const KnownResult> known_results();
/// In the order in which the tools run, of each tool that in which a reader asks.
std::span<const KnownAttribute> known_attributes();

/// Null where the name is a user's own.
const KnownAttribute* known_attribute(std::string_view name);
/// The result that a variable, or an attribute, belongs to; null where the name is a user's own.
const KnownResult* result_of_variable(std::string_view name);
const KnownResult* result_of_attribute(std::string_view name);
/// Of the name of either.
const KnownResult* result_of(std::string_view name);
/// What a variable must measure where a tool reads it by its name; "": anything.
std::string_view unit_needed(std::string_view variable);

}  // namespace asperity
