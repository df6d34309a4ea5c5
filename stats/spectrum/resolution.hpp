/// What a window does to the densities of a spectrum, and where it leaves nothing to be said of the surface.
///
/// A field that is not periodic is cut off by its window, of transform W, which spreads each wave over all
/// wave numbers: E[C] = κ * C_surface, with
///     κ(n) = ∫_{n-½}^{n+½} W² df / ∫ W² df,     W = sinc f without a window; Hann's sinc f/(1 - f²).   (1)
/// How much that raises or lowers C is seen by spreading C once more,
///     b = ln (κ * C)(k)/C(k),     over profiles Σ_j κ(k-j) C(j), over rings Σ_j κ(k-j) √(j/k) C(j),     (2)
/// each sum over that of a flat spectrum. √(j/k) makes the second derivative across the rings that of a
/// window along both axes, C'' + C'/k, whatever the direction of the texture. b is averaged over the same
/// neighbours as degrees of freedom (stats/spectrum/resolution.hpp), in which chance cancels and bias
/// does not. A removed form takes the waves below
///     k_0 = 2 + ⌈d/2⌉ with Hann's window, 1 + ⌈d/2⌉ without,                                           (3)
/// d its degree. In (2) they continue the slope of the next three. A point has no error where, in this order,
///     form        k < k_0;
///     leakage     κ(n) beyond the main lobe, n ≥ 2, n ≥ 1 without a window, brings more than a tenth of C
///                 from other waves, three tenths without a window; of a flat one without it is 0.23;
///     resolution  |b| is above half of the relative error of C.
/// Elsewhere the interval of C is longer by |b| on the side that the surface's own density lies on.
///
/// Scope     means over profiles and rings; not along a periodic axis, where nothing is cut off.
/// Accuracy  of 200 fields of 64 × 64 points with a Gaussian correlation of lengths 12 and 6, profiles
///           along y at wave numbers 3, 5, 7, 9, 12 are biased by -0.1, 0.4, 0.6, 0.8, 1.8 true errors; the
///           median b is 0.2, 0.4, 0.8, 1.3, 2.3 of them, and 13, 36, 91, 100, 100 % of the points have no
///           error. Coverage: stats/measure/spectra.hpp.
/// Cost      10 operations for each pair of points, with Hann's window for those within 1024 of each other.
///
/// F. J. Harris, Proc. IEEE 66 (1978) 51-83, for the lobes of windows.
#pragma once

#include <vector>

#include "stats/spectrum/spectrum.hpp"

namespace asperity {

// ---- degrees of freedom from neighbours ----

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

enum class PointKind { profile, ring };  ///< the first at wave number 0; at 1

/// (2)
void pool_degrees(std::vector<SpectrumPoint>& points, PointKind kind);

/// b = ln C'/C of each point, for a density C and what spreading it once more makes of it, C', averaged over
/// the neighbours of (2), in which chance cancels and bias does not; each at most 2.
std::vector<double> pooled_bias(const std::vector<double>& once_more, const std::vector<double>& densities,
                                PointKind kind);
/// Whether |b| is above half of the relative error of a point.
bool hidden_by(double bias, const SpectrumPoint& point);

struct WindowedSpectrum {
  PointKind kind;
  DataWindow window;
  Index degree = 0;  ///< of the form that was removed
  Index points = 0;  ///< of a profile; none: rings
};

/// Sets the bias of points, and takes the errors of those that have a reason to have none.
void judge_resolution(std::vector<SpectrumPoint>& points, const WindowedSpectrum& spectrum);

// ---- what holes spread ----

/// What missing points do to the densities of a spectrum, and where they leave nothing to be said of the
/// surface.
///
/// Missing points count as zero: the field is multiplied by M, 1 where a point is there, otherwise 0, and
/// each wave is spread over all wave numbers by the transform of M. An outline or scattered holes leave a
/// floor that hides short waves (spectrum.hpp (4)). As of a window (resolution.hpp), how much that raises C
/// is seen by spreading C once more,
///     b = ln C'(k)/C(k),   C' = F[a F⁻¹[C]],   a(p,q) = Σ M(i,j) M(i+p,j+q) / Σ M,                   (1)
/// F the discrete Fourier transform, the sums over the torus. Where C is nothing but other waves, b is about
/// ln 2. Of holes in a pattern, as every other line, a is 0 at some lags, where C knows nothing of the
/// surface and C' would be C: where a < 1/20, the mean of F⁻¹[C]/a at the lags beside stands in its place. b
/// is averaged over the same neighbours as degrees of freedom. A point where |b| is above half of the
/// relative error of C has no error; elsewhere |b| lengthens its interval.
///
/// Accuracy  (1) to round-off; without missing points C' is C. Of every other line and of a checkerboard up
///           to a sixth of the densities keep too small an error, between waves with too little and too much.
/// Cost      five real transforms of the field's size.

/// C' of (1), of the spectrum of d.
LagField spread_by_holes(const LagField& psd, const Field& d);

/// Adds b to the bias of points, and takes the errors of those that holes hide; `once_more` has the same
/// means of C'.
void judge_holes(std::vector<SpectrumPoint>& points, const std::vector<SpectrumPoint>& once_more,
                 PointKind kind);

}  // namespace asperity
