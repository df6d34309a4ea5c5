/// Units, by name and of variables; the only door to UDUNITS-2.
///
/// CF says `units`, contact.engineering `unit`; the first counts where both stand. What is read is converted;
/// where a length or a pressure is needed, a variable is refused that has no unit, measures something else,
/// or counts from another zero.
///
/// A call sets UDUNITS' message handler, which is the process's, and puts the former one back. Calls exclude
/// one another; a program that uses UDUNITS itself in another thread must keep them apart.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/dataset.hpp"

namespace asperity {

/// The factor f with 1 `from` = f `to`: unit_factor("nm", "m") = 1e-9, unit_factor("µm", "m") = 1e-6, in
/// UTF-8 or Latin-1. Throws std::invalid_argument saying which unit is unknown, that the two measure
/// different things, or that one counts from another zero (a unit with an offset, or a logarithmic one).
double unit_factor(const std::string& from, const std::string& to);

/// As the variable states it; "" where it does not.
std::string unit_of(const Variable& variable);
/// The unit that a variable is read in: what its name needs (dataset/catalogue.hpp); of any other name m or
/// Pa where it measures that, else its own, "1" where it has none.
std::string si_unit_of(const Variable& variable);
/// The factor from the unit of a variable to this one; a pure number, "1", needs none. Throws DataError(name,
/// …) where it has none, or one that measures something else or counts from another zero.
double factor_to(std::string_view unit, const Variable& variable);

/// Lags in metres; none where they count samples, without a unit, "1" or "px". Throws DataError(name, …).
std::optional<std::vector<double>> lags_of(const Variable& axis);

}  // namespace asperity
