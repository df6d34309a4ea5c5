/// The six components of a symmetric stress tensor, and sets of them.
///
/// Stress is positive in tension; z points into the body.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <string_view>

namespace asperity::stress {

enum Component : std::size_t { xx, yy, zz, xy, xz, yz };

inline constexpr std::array components{xx, yy, zz, xy, xz, yz};
inline constexpr std::array<std::string_view, 6> names{"xx", "yy", "zz", "xy", "xz", "yz"};

/// A stress state, indexed by Component.
using Tensor = std::array<double, 6>;

/// The components that somebody asks for: Set().set(zz), or all.
using Set = std::bitset<6>;
inline const Set all = Set().set();

/// Under a pressure that is even in x and in y, a component is even too, or odd: a shear component changes
/// sign with each axis in its name, z apart.
constexpr bool odd_in_x(Component c) { return c == xy || c == xz; }
constexpr bool odd_in_y(Component c) { return c == xy || c == yz; }

}  // namespace asperity::stress
