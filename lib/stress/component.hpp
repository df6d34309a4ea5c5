/// The six components of a symmetric stress tensor, sets of them, and what they answer to.
///
/// Stress is positive in tension; z points into the body.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <span>
#include <string_view>

namespace asperity {

/// Stresses along a row of points: the values of each requested component; the others are empty.
using StressRow = std::array<std::span<const double>, 6>;

namespace stress {

enum Component : std::size_t { xx, yy, zz, xy, xz, yz };

inline constexpr std::array components{xx, yy, zz, xy, xz, yz};
inline constexpr std::array<std::string_view, 6> names{"xx", "yy", "zz", "xy", "xz", "yz"};

/// A stress state, indexed by Component.
using Tensor = std::array<double, 6>;

/// The requested components: Set().set(zz), or all.
using Set = std::bitset<6>;
inline const Set all = Set().set();

/// What loads the surface: a pressure, and tractions along x and along y that act on the body.
enum Traction : std::size_t { normal, shear_x, shear_y };

inline constexpr std::array tractions{normal, shear_x, shear_y};

/// Tractions that act.
using Tractions = std::bitset<3>;

/// Under a pressure that is even in x and in y, a component is even too, or odd: a shear component changes
/// sign with each axis in its name, z apart. A traction along an axis is odd where a pressure is even.
constexpr bool odd_in_x(Component c, Traction t = normal) { return (c == xy || c == xz) != (t == shear_x); }
constexpr bool odd_in_y(Component c, Traction t = normal) { return (c == xy || c == yz) != (t == shear_y); }

/// The component that takes the place of c when x and y are exchanged.
constexpr Component exchanged(Component c) {
  constexpr std::array other{yy, xx, zz, xy, yz, xz};
  return other[c];
}

inline Tensor exchanged(const Tensor& s) {
  Tensor out;
  for (Component c : components) out[c] = s[exchanged(c)];
  return out;
}

}  // namespace stress
}  // namespace asperity
