/// The pressure as it is seen from a vertical plane x = x_i, for the stress in that plane alone.
///
/// Transformed along y, and only along y, a component's row in the plane is a sum over the lags m in x,
///     σ^(ky) = Σ_t w_t (-i)^[K_t odd in y] Σ_{m≥0} K_t(m, ky) P±(m, ky),                                  (1)
///     P±(m) = p^(x_i - mΔx) ± p^(x_i + mΔx),   P+(0) = p^(x_i),  P-(0) = 0,                               (2)
/// + for a kernel even in x, - for one odd in x. A kernel is the difference of the corner functions on both sides of a
/// cell, K(m) = t(m) (f(m) - f(m-1)) with the taper t; that too is taken over to the pressure, once for all layers:
///     Σ_m K(m) P±(m) = Σ_m f(m) D±(m),   D±(m) = t(m) P±(m) - t(m+1) P±(m+1),   D+(0) = 2 P+(0) - t(1) P+(1).  (3)
/// No layer is transformed in x, and of the lags there are only as many as the plane is away from the farthest load.
///
/// In a periodic half-space the sum is over the modes kx ≥ 0, with Q(kx) = p^(kx, ky) exp(i kx x_i) for p^(x),
/// D+(k) = Q(k) + Q(-k), D-(k) = -i (Q(k) - Q(-k)).
///
/// Symbols   p^  pressure of a row, transformed along y     w_t, K_t  weight of a traction, its kernel     f  corner
///           function (stress/layer_influence.hpp), transformed along y
/// Cost      that of one layer of one component. Memory: 4 (lags) Py doubles.
#pragma once

#include "stress/layer_influence.hpp"
#include "stress/resolution.hpp"

namespace asperity {

class PlaneLoad {
 public:
  static constexpr Index width = LayerInfluence::width;

  /// Of the plane of the cells i, seen with cells s times as wide (stress/resolution.hpp).
  PlaneLoad(const Grid& grid, const Field& pressure, Index i, Index s, int threads);

  const Resolution& resolution() const { return resolution_; }
  /// Of (1), (3).
  Index terms() const { return terms_; }
  /// sum[0 … 7] += Re, sum[8 … 15] += Im of Σ_m f(m, ky) D±(m, ky) for the columns 8b … 8b+7, f as [m][8].
  void add(const double* f, bool odd, Index b, double* sum) const;

 private:
  using Terms = AlignedVector<double>;  ///< [block][m][re, im][8]

  /// D± for the columns ky of block b, from the modes kx of p^ times exp(i kx x_i), 8 columns of `stride`.
  void fold_modes(const Complex* modes, Index stride, Index b);
  void fold_lags(const Complex* lags, Index stride, Index b);
  void set(bool odd, Index b, Index m, Index q, Complex value);

  Resolution resolution_;
  Index terms_;
  std::array<Terms, 2> terms_of_;  ///< even, odd
};

}  // namespace asperity
