/// What no stress below a load exceeds, from its sum alone.
///
/// Under a unit force, along z or along the surface, the stress at depth z is s(t)/z², t the position beside
/// it over z. So under any load of the sum P = Σ|p| ΔxΔy, friction μ, ‖σ‖ = √(Σ σij²) is at most
///     (N + μ T) P / z²,   N = max ‖s‖ of the normal force, T of the tangential one,                     (1)
/// and the von Mises stress, the principal stresses, the maximum shear and every component at most √(3/2) of
/// it. At ν = ½, N = 3/2π, on the axis. Both maxima are taken over a lattice of t, spaced 0.04 as far as t =
/// 4, where the norm has fallen to a sixth, and raised by a percent; finer ones find 5e-4 more.
#pragma once

#include "stress/load.hpp"

namespace asperity {

/// √(3/2) times (1), times z² [N]; infinite of a periodic load, which no depth bounds.
double stress_bound(const LoadedBody& body);

}  // namespace asperity
