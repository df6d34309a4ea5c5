/// The table of results that the tools write into a dataset, with their variables and global attributes.
///
/// A result is computed by one run. It depends on the results that it was computed from:
///
///     kernel ← heights ← contact ← residual, stress          acf, psd ← the field that was measured
///
/// Other names belong to the user.
#pragma once

#include <span>
#include <string_view>

namespace asperity {

/// A name in the table may end in *, which matches any rest.
bool fits(std::string_view pattern, std::string_view name);

struct KnownResult {
  std::string_view name, rests_on;  ///< its name, and the results it depends on, separated by blanks
  std::string_view prefix;          ///< of its attributes
  std::string_view variables;       ///< its own, separated by blanks
};

/// The role of a number: parameter, result, accuracy reached by a solver, or not part of a report.
enum class Role { parameter, result, achieved, other };

struct KnownAttribute {
  std::string_view name;
  Role role;
  /// SI; "sample": cells of x and y, "yes": 0 or 1, "height": m, or 1 for unit heights; "" for text.
  std::string_view unit;
  std::string_view label;  ///< in words
  bool open = false;       ///< may be infinite, or NaN: unknown
};

std::span<const KnownResult> known_results();
/// In the order of the tools, and for each tool in the order of interest.
std::span<const KnownAttribute> known_attributes();

/// Null for a name of the user.
const KnownAttribute* known_attribute(std::string_view name);
/// The result that a variable or an attribute belongs to; null for a name of the user.
const KnownResult* result_of_variable(std::string_view name);
const KnownResult* result_of_attribute(std::string_view name);
/// The same for a variable or an attribute.
const KnownResult* result_of(std::string_view name);
/// The unit that a variable of this name must have, up to a factor; "": any.
std::string_view unit_needed(std::string_view variable);

}  // namespace asperity
