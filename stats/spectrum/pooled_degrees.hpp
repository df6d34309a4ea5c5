/// Degrees of freedom of a spectrum's points, from neighbours too.
///
/// The degrees of freedom ν of a mean of few wave numbers, and so its error, are estimated from the same few:
/// they come out high by chance, and by more the fewer they are. The relative variance
///     u = Var/C² = 2/(ν + 2)                                                                            (1)
/// (stats/spectrum/shared_power.hpp) changes little from point to point of profiles, and as 1/k of rings. The
/// mean ū of the points k - h … k + h, h = 1 + k/8, gives
///     ν' = 2/ū - 2,     ν = ν'²/(ν' + 1.5),     Var = 2 C²/(ν + 2),                                     (2)
/// at least the two of a single wave number where ν' is not less. 1.5 is what chance in ū leaves on average:
/// ν' of n equal waves is convex in ū, whose relative variance is a few times 1/ν.
///
/// Symbols   C  density of a point      k  its wave number, in steps
/// Accuracy  1.5 is fitted to eleven textures of 32 × 32 points, N_eff 8 to 35
///           (validation/error_coverage.cpp). Of 200 Gaussian fields of each of seven of 32 × 32 and of
///           64 × 64 points, the median ν of one point is on average 1.48 times the true one below ν = 8,
///           1.32 times from 8 to 14, 1.21 times from 14 to 30; with (2) 1.22, 1.16 and 1.10 times.
/// Cost      a few operations a point.
#pragma once

#include <vector>

#include "stats/spectrum/spectrum.hpp"

namespace asperity {

enum class PointKind { profile, ring };  ///< the first at wave number 0; at 1

/// (2)
void pool_degrees(std::vector<SpectrumPoint>& points, PointKind kind);

/// b = ln C'/C of each point, for a density C and what spreading it once more makes of it, C', averaged over
/// the neighbours of (2), in which chance cancels and bias does not; each at most 2.
std::vector<double> pooled_bias(const std::vector<double>& once_more, const std::vector<double>& densities,
                                PointKind kind);
/// Whether |b| is above half of the relative error of a point.
bool hidden_by(double bias, const SpectrumPoint& point);

}  // namespace asperity
