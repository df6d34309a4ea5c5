/// The units of variables, and what they are read in.
///
/// CF says `units`, contact.engineering `unit`; the first counts where both stand. What is read is converted by UDUNITS
/// (dataset/units.hpp); where a length or a pressure is needed, a variable is refused that has no unit, measures something
/// else, or counts from another zero.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/dataset.hpp"

namespace asperity {

/// As the variable states it; "" where it does not.
std::string unit_of(const Variable& variable);
/// The unit that a variable is read in: m of heights, gaps and displacements, Pa of pressure and von Mises stress, which
/// must measure these; of any other name m or Pa where it measures that, else its own, "1" where it has none. Throws
/// DataError(name, …).
std::string si_unit_of(const Variable& variable);
/// The factor from the unit of a variable to this one; a pure number, "1", needs none. Throws DataError(name, …) where it has
/// none, or one that measures something else or counts from another zero.
double factor_to(std::string_view unit, const Variable& variable);

/// Lags in metres; none where they count samples, one each, and have no unit, "1" or "px". Throws DataError(name, …).
std::optional<std::vector<double>> lags_of(const Variable& axis);

}  // namespace asperity
