/// Where a contact leaves the half-space model, as sentences for the user.
///
/// The model is that of half-spaces under small strains, on a domain that holds the contact. In doubt is
///     cells in contact < 50            too few for its outline and its pressure,                         (1)
///     p > 0 at the domain's free edge  what would be pressed beyond it is missing,                       (2)
///     max p > E*                       strains and slopes are of order one,                              (3)
///     L/2 > |R|                        the body has ended where its paraboloid goes on.                  (4)
/// (1): 50 cells are a circle 8 across; where the domain repeats every n < 7 cells, 8n are a strip as wide.
/// (2) states the sides that are needed: 3a × 3b of Hertz's semi-axes, or of a like ellipse that carries the
/// load at max p where that is larger, and half as much again where the domain has them already; 3b across
/// a line contact. (3): under p a square cell sinks by K₀₀ p = 1.12 Δx p/E*; solids yield long before: give a
/// limit pressure.
///
/// Symbols   p pressure [Pa]   E* composite modulus [Pa]   L side of the domain [m]   R radius of a body [m]
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "contact/bodies.hpp"
#include "contact/solver.hpp"

namespace asperity {

struct Doubt {
  std::string_view about;  ///< what such contacts have in common: "has few cells"
  std::string words;       ///< a sentence with the figures of this one, and what to do
};

/// (4), of bodies on their domain under any load.
std::vector<Doubt> doubts(const Grid& grid, const Bodies& bodies);
/// (1) to (3), of one contact of them.
std::vector<Doubt> doubts(const Grid& grid, const Bodies& bodies, const Contact& contact);

}  // namespace asperity
