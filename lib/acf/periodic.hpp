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
/// A piece of a periodic surface is a surface that is not periodic. Of n × m lags, beyond which R is 0, it
/// has R at all of its lags where the period exceeds its sides by n-1 and m-1 points: then R° is R there
/// (circulant embedding). Of a positive definite R that needs no equations either.
///
/// Symbols   ^ the discrete Fourier transform over the torus
/// Accuracy  ε log2(N M) of the variance.
/// Cost      (1) one addition a lag of R; (2) a transform of the lags' rows, pruned. Memory: 4 bytes a point
///           of the torus for the root, 16 (M/2 + 1) for each row of lags meanwhile.
///
/// C. R. Dietrich, G. N. Newsam, Fast and exact simulation of stationary Gaussian processes through circulant
/// embedding of the covariance matrix, SIAM J. Sci. Comput. 18 (1997) 1088-1107.
#pragma once

#include <functional>

#include "core/field.hpp"
#include "transform/plan.hpp"

namespace asperity {

/// Whether a kernel of this shape correlates heights half a period apart or farther.
constexpr bool reaches_around(Shape kernel, Shape period) {
  return 2 * (kernel.nx - 1) >= period.nx || 2 * (kernel.ny - 1) >= period.ny;
}

/// (1) at the lags p = 0 …, q = -… + … up to half a period that the half plane reaches.
Field periodic_sum(const Field& half_plane, Shape period);

/// (2), column by column: values[k N + i] at wave i in x and k ≤ M/2 in y, of a kernel of unit variance.
struct SpectralRoot {
  Shape torus;
  AlignedVector<double> values = {};

  Index columns() const { return torus.ny / 2 + 1; }
  const double* column(Index k) const { return values.data() + k * torus.nx; }
};

/// Of a half plane of lags up to half the torus, zero where it ends.
SpectralRoot spectral_root(const Field& half_plane, Shape torus, int threads = 1);
/// The root's kernel, of the whole torus with lag zero at its middle.
Field kernel_of(const SpectralRoot& root, int threads = 1);
/// Takes R°/σ² at the lags q = -M/2 … M/2 of some rows, from `first` on; called by several threads at once.
using LagRows = std::function<void(Index first, const Eigen::Ref<const Field>& rows)>;
/// The correlation of the root's kernel at the rows of lags p = 0 … rows-1, at most N/2 + 1.
void correlation_of(const SpectralRoot& root, Index rows, const LagRows& sink, int threads = 1);

/// At all lags p = 0 … N/2, q = -M/2 … M/2.
Field correlation_of(const SpectralRoot& root, int threads = 1);

/// kernel_of(spectral_root).
Field periodic_kernel(const Field& half_plane, Shape torus);

/// Powers R°^ on the half spectrum of a torus, N × (M/2 + 1), real.
using PowerSpectrum = AlignedVector<Complex>;

/// (2) of powers in any unit, of unit variance.
Field kernel_of_power(PowerSpectrum power, Shape torus);
SpectralRoot root_of_power(const PowerSpectrum& power, Shape torus);
/// Σ power cos at the lags p = 0 … N/2, q = -M/2 … M/2.
Field correlation_of_power(PowerSpectrum power, Shape torus);
/// |kernel^| of a kernel of a whole torus: another kernel of the same correlation, at unit variance.
SpectralRoot root_of_kernel(const Field& kernel);
/// The correlation of a kernel of a whole torus, at the same lags.
Field periodic_autocorrelation(const Field& kernel);

}  // namespace asperity
