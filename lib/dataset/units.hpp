/// Units by name, the only door to UDUNITS-2.
///
/// UDUNITS is silent during a call, which sets its message handler, the process's, and puts the former one back. Calls exclude
/// one another; a program that uses UDUNITS itself in another thread at the same time must keep them apart.
#pragma once

#include <string>

namespace asperity {

/// The factor f with 1 `from` = f `to`: unit_factor("nm", "m") = 1e-9, unit_factor("µm", "m") = 1e-6, in UTF-8 or Latin-1.
/// Throws std::invalid_argument saying which unit is unknown, that the two measure different things, or that one counts from
/// another zero (a unit with an offset, or a logarithmic one).
double unit_factor(const std::string& from, const std::string& to);

/// Whether both are known and measure the same thing.
bool measures(const std::string& unit, const std::string& other);

}  // namespace asperity
