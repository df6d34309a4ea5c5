/// The density of heights by a Gaussian kernel, its errors, and the Gaussian of the same mean and Sq.
///
///     f(t) = 1/(N h) Σ φ((t - z_i)/h)                                                               (1)
/// with the optimal bandwidth for N Gaussian heights (N as in stats/height/distribution.hpp),
///     h = (4/(3N))^{1/5} Sq = 1.06 Sq N^{-1/5}.                                                     (2)
/// The kernel widens the distribution. (1) is compared with its mean over Gaussian heights, in Sq, s² = 1 +
/// h²,
///     E[f(t)] = φ(t/s)/s.                                                                           (3)
/// The difference for the field's own mean and Sq, the misfit, is compared with the error that it has if
/// heights are Gaussian. With the Hermite coefficients c_k = He_k(t/s) φ(t/s) s^{-k-1}, of which k = 1 and 2
/// drop out (stats/uncertainty/effective_size.hpp)
///     Var[f - φ(t/s)/s] = 1/N Σ_{k≥3} (c_k²/k!) S_k.                                                (4)
/// The density itself has the error and the interval of stats/uncertainty/share_error.hpp, from the field's
/// own long waves: f is the mean of a function of height, the kernel on cells of half a bandwidth. It rests
/// on 2 √π N h f points.
///
/// (1) is summed over cells of half a bandwidth: with the moments M_k = Σ d^k/√k! of a cell's heights c + h
/// d, |d| ≤ 1/4, the Hermite series of the Gaussian about its centre c (the fast Gauss transform) is
///     Σ φ((t - z_i)/h) = Σ_k M_k He_k(u) φ(u)/√k!,   u = (t - c)/h,  k < 14.                        (5)
///
/// Symbols   z  heights      h  bandwidth      φ  the Gaussian's density      S_k  sums over the correlation
/// Accuracy  (5) to 2e-14 of the largest value, (1/4)^14/√14!, besides round-off. (4) to first order in 1/N,
///           for Gaussian heights. Errors of neighbouring points are correlated.
/// Cost      one pass of 14 multiplications per height; per point of the curve 40 cells of 14 terms, and 512
///           terms for (4). Another pass for errors. Memory 28 Sz/h numbers, 52 with errors.
///
/// B. W. Silverman, Density Estimation for Statistics and Data Analysis, Chapman and Hall 1986, eq. 3.28;
/// L. Greengard, J. Strain, The fast Gauss transform, SIAM J. Sci. Stat. Comput. 12 (1991) 79-94.
#pragma once

#include <vector>

#include "core/field.hpp"
#include "stats/height/distribution.hpp"
#include "stats/sample/moments.hpp"
#include "stats/uncertainty/effective_size.hpp"

namespace asperity {

/// Heights in the unit of the field, densities in its inverse.
struct DensityPoint {
  double height = 0;
  double density = 0;
  double gaussian = 0;       ///< (3)
  double misfit_error = 0;   ///< √(4), of density - gaussian
  Frequency frequency = {};  ///< the density again, with its error
};

constexpr double least_bandwidth = 1e-5;  ///< of the range of heights

/// (2), in the unit of the field.
double silverman_bandwidth(const Moments& moments, double points);

/// At `rows` equidistant heights, from three bandwidths below the lowest to three above the highest, or those
/// of a given range that includes them. Throws ParameterError("rows", …) below 2, ("bandwidth", …) unless it
/// is finite and at least the least one.
std::vector<DensityPoint> kernel_density(const Field& z, double bandwidth, int rows,
                                         std::optional<HeightRange> range = {});
/// Sets what a Gaussian of these moments would have.
void compare_with_gaussian(std::vector<DensityPoint>& curve, const Moments& moments,
                           const EffectiveSampleSize& size, double bandwidth);
/// Sets the frequencies; `sq` is the rms height of heights measured from their own mean, 0 of others.
void set_errors(std::vector<DensityPoint>& curve, const Field& z, const Grid& grid, const FieldExtent& extent,
                double bandwidth, double sq = 0);

}  // namespace asperity
