/// Units by name, the only door to UDUNITS-2.
#pragma once

#include <string>

namespace asperity {

/// The factor f with 1 `from` = f `to`: unit_factor("nm", "m") = 1e-9, unit_factor("µm", "m") = 1e-6. Throws
/// std::invalid_argument saying which unit is unknown, or that the two measure different things.
double unit_factor(const std::string& from, const std::string& to);

}  // namespace asperity
