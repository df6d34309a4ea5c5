/// Autocorrelations and kernels of periodic surfaces.
///
/// A surface that continues itself after N × M points has an autocorrelation that does so too, of R its sum
/// over the periods,
///     R°(p,q) = Σ_j Σ_k R(p + jN, q + kM),                                                              (1)
/// whose spectrum is that of R at the waves that fit: every autocorrelation of the plane leaves one of the
/// period. Its variance R°(0,0) differs from R(0,0), by a factor of 17 for a profile of 1 × 4096 points and a
/// length of 20 samples: to keep the rms height, divide by it. Where R ends before half a period, R° is R.
///
/// On the torus nothing is left to solve: the kernel is the root of the spectrum,
///     kernel^ = √max(R°^, 0),                                                                           (2)
/// and has R° to round-off where R° is positive definite, otherwise the nearest by its spectrum.
///
/// Symbols   ^ the discrete Fourier transform over the torus
/// Accuracy  ε log2(N M) of the variance.
/// Cost      (1) one addition a lag of R; (2) one real transform there and back, 24 bytes a point of the
///           torus.
#pragma once

#include "core/field.hpp"
#include "transform/plan.hpp"

namespace asperity {

/// Whether a kernel of this shape correlates heights half a period apart or farther.
constexpr bool reaches_around(Shape kernel, Shape period) {
  return 2 * (kernel.nx - 1) >= period.nx || 2 * (kernel.ny - 1) >= period.ny;
}

/// (1) at the lags p = 0 …, q = -… + … up to half a period that the half plane reaches.
Field periodic_sum(const Field& half_plane, Shape period);

/// (2) of a half plane of lags up to half the torus, zero where it ends: a kernel of the whole torus with lag
/// zero at its middle, of unit variance.
Field periodic_kernel(const Field& half_plane, Shape torus);

/// Powers R°^ on the half spectrum of a torus, N × (M/2 + 1), real.
using PowerSpectrum = AlignedVector<Complex>;

/// (2) of powers in any unit, of unit variance.
Field kernel_of_power(PowerSpectrum power, Shape torus);
/// Σ power cos at the lags p = 0 … N/2, q = -M/2 … M/2.
Field correlation_of_power(PowerSpectrum power, Shape torus);
/// That of a kernel of a whole torus, at the same lags.
Field periodic_autocorrelation(const Field& kernel);

}  // namespace asperity
