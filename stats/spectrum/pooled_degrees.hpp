/// Degrees of freedom of a spectrum's points, from neighbours too.
///
/// The degrees of freedom ν of a mean of few wave numbers, and so its error, are estimated from the same few:
/// they come out high by chance, and by more the fewer they are. The relative variance
///     u = Var/C² = 2/(ν + 2)                                                                            (1)
/// (stats/spectrum/shared_power.hpp) changes little from point to point of profiles, and goes as 1/k of rings.
/// Its mean ū over the points k - h … k + h, h = 1 + k/8, gives
///     ν' = 2/ū - 2,     ν = ν'²/(ν' + 1.5),     Var = 2 C²/(ν + 2),                                     (2)
/// at least the two of a single wave number where ν' is not less. 1.5 is what chance in ū leaves on average:
/// ν' of n equal waves is convex in ū, whose relative variance is a few times 1/ν.
///
/// Symbols   C  density of a point      k  its wave number, in steps
/// Accuracy  the 1.5 is fitted to eleven textures of 32 × 32 points, N_eff 8 to 35
///           (validation/error_coverage.cpp), between 1 and 2, either of which serves. ν of 200 fields of
///           them, estimated from one point, is in the median up to 1.9 times the true one below ν = 10, and
///           so within a fifth.
/// Cost      a few operations a point.
#pragma once

#include <vector>

#include "stats/spectrum/spectrum.hpp"

namespace asperity {

enum class PointKind { profile, ring };  ///< the first at wave number 0; at 1

/// (2)
void pool_degrees(std::vector<SpectrumPoint>& points, PointKind kind);

/// h of (2).
inline Index pooled_reach(Index k) { return 1 + k / 8; }

}  // namespace asperity
