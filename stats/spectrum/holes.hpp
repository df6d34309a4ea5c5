/// What missing points do to the densities of a spectrum, and where they leave nothing to be said of the
/// surface.
///
/// Missing points count as zero: the field is multiplied by M, 1 where a point is there, otherwise 0, and
/// each wave is spread over all wave numbers by the transform of M. An outline or scattered holes leave a
/// floor that hides short waves (spectrum.hpp (4)). As of a window (resolution.hpp), how much that raises C
/// is seen by spreading C once more,
///     b = ln C'(k)/C(k),   C' = F[a F⁻¹[C]],   a(p,q) = Σ M(i,j) M(i+p,j+q) / Σ M,                   (1)
/// F the discrete Fourier transform, the sums over the torus. Where C is nothing but other waves, b is about
/// ln 2. It is averaged over the same neighbours as degrees of freedom. A point where |b| is above half of
/// the relative error of C has no error; elsewhere |b| lengthens its interval.
///
/// Accuracy  (1) to round-off; without missing points C' is C.
/// Cost      five real transforms of the field's size.
#pragma once

#include <vector>

#include "stats/spectrum/pooled_degrees.hpp"
#include "stats/spectrum/spectrum.hpp"

namespace asperity {

/// C' of (1), of the spectrum of d.
LagField spread_by_holes(const LagField& psd, const Field& d);

/// Adds b to the bias of points, and takes the errors of those that holes hide; `once_more` has the same
/// means of C'.
void judge_holes(std::vector<SpectrumPoint>& points, const std::vector<SpectrumPoint>& once_more,
                 PointKind kind);

}  // namespace asperity
