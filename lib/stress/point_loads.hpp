/// The stress below many point loads at once: the vector form of point_load_stress (stress/influence.hpp).
///
/// Accuracy  1e-14 of the largest component.
/// Cost      some 3 ns a load and traction.
#pragma once

#include <cstddef>

namespace asperity {

/// Loads stand on a lattice of `lattice_side` by as many places.
inline constexpr std::ptrdiff_t lattice_side = 8;

/// Adds 2π times the stress at the origin's depth z under the forces force[8m + n] at (-x[m], -y[n], 0),
/// times weights[t] along each axis: a pressure, a traction along x, one along y; those of weight 0 are left
/// out. The place is not on a load.
void add_point_loads(const double* x, const double* y, const double* force, double z, double poisson,
                     const double weights[3], double out[6]);

}  // namespace asperity
