/// Units, by name and of variables; no other code calls UDUNITS-2.
///
/// CF uses the attribute `units`, contact.engineering `unit`; `units` takes precedence. Values are converted
/// on reading. Where a length or a pressure is needed, a variable is refused if it has no unit, a unit of
/// another quantity, or a unit with another zero.
///
/// A call sets UDUNITS' message handler, which belongs to the process, and restores the former one. Calls
/// lock each other out; a program that uses UDUNITS in another thread must synchronise with them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/dataset.hpp"

namespace asperity {

/// The factor f with 1 `from` = f `to`: unit_factor("nm", "m") = 1e-9, unit_factor("µm", "m") = 1e-6, in
/// UTF-8 or Latin-1. Throws std::invalid_argument when a unit is unknown, the two measure different
/// quantities, or have different zeros (a unit with an offset, or a logarithmic one).
double unit_factor(const std::string& from, const std::string& to);

/// The unit of the variable; "" if it has none.
std::string unit_of(const Variable& variable);
/// The unit in which a variable is read: the one that its name needs (dataset/catalogue.hpp); otherwise m or
/// Pa for lengths and pressures, its own unit for other quantities, "1" without a unit.
std::string si_unit_of(const Variable& variable);
/// The factor from the unit of a variable to `unit`; for "1" the variable needs no unit. Throws
/// DataError(name, …) when it has no unit, one of another quantity, or one with another zero.
double factor_to(std::string_view unit, const Variable& variable);

/// Lags in metres; nothing if they count samples: without a unit, "1" or "px". Throws DataError(name, …).
std::optional<std::vector<double>> lags_of(const Variable& axis);

}  // namespace asperity
