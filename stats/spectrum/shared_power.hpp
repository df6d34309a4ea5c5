/// How much power neighbouring wave numbers share, and what it does to means over them.
///
/// A window w over the points that are there, m = 1, and none elsewhere correlates the amplitudes at two wave
/// numbers a distance δ apart, in steps of 2π/Lx and 2π/Ly. Where the spectrum changes little over δ, the
/// estimates C of the power have the correlation
///     r(δ) = |Σ m w² exp(-2πi(δx i/nx + δy j/ny))|² / (Σ m w²)²,                                      (1)
/// along an axis 0 without a window, and with Hann's 4/9 and 1/36 for δ = 1 and 2. C(-k) is C(k) over again.
/// The mean over a set of n wave numbers k that holds -k with each k has the variance
///     Var = 2/n² Σ_k Σ_l r(k-l) E[C(k)] E[C(l)]                                                       (2)
/// over all pairs of the set. It is estimated without bias, by
///     E[C(k) C(l)] = E[C(k)] E[C(l)] (1 + r(k-l) + r(k+l)).                                           (3)
///
/// The mean is distributed nearly as χ²/ν with
///     ν = 2 mean²/Var - 2,  at most that of a flat spectrum,                                          (4)
/// 2 for the square of the estimate and Var, which have chance in common: with (3), exactly what a single
/// wave number needs, and on average what any number of equal ones does.
///
/// Symbols   k, l  wave numbers of the torus: modulo nx in x, ny in y
/// Scope     Gaussian fields; what others add: stats/spectrum/power_excess.hpp. r is taken
///           into account up to δ = 2 along each axis.
/// Accuracy  exact for white noise. Where the spectrum changes over δ, C of the steeper side counts too much.
/// Cost      (1) a pass with a window and holes; (2) a product per wave number and neighbour with r > 0.
#pragma once

#include <functional>
#include <vector>

#include "core/field.hpp"
#include "stats/spatial/pairs.hpp"

namespace asperity {

struct MeanPower {
  double mean = 0, variance = 0;
  double degrees = 0;  ///< ν of (4)
  double count = 0;    ///< n
};

class SharedPower {
 public:
  static constexpr Index reach = 2;
  struct Neighbour {
    Index dp, dq;
    double r;
  };

  /// (1) of w² along x and y, on the points of the field that are not missing.
  SharedPower(const Field& d, const Eigen::ArrayXd& squares_x, const Eigen::ArrayXd& squares_y);

  /// r between (0,0) and (p,q).
  double operator()(Index p, Index q) const;
  /// The sum of r over all neighbours: Σ m w⁴ times the number of points over (Σ m w²)².
  double overlap() const;
  /// The index of the same wave number within half a period, in (-n/2, n/2].
  Index within_x(Index p) const { return within(p, shape_.nx); }
  Index within_y(Index q) const { return within(q, shape_.ny); }
  /// The means of `psd` over `sets` sets. set(p,q) is the number of the set of (p,q) for p ≥ 0, which (-p,-q)
  /// belongs to as well; negative for none.
  std::vector<MeanPower> means(const LagField& psd, Index sets,
                               const std::function<Index(Index, Index)>& set) const;

 private:
  static Index within(Index k, Index n) {
    const Index from_zero = (k % n + n) % n;
    return 2 * from_zero > n ? from_zero - n : from_zero;
  }

  Shape shape_;
  std::vector<Neighbour> neighbours_;  ///< with r > 0, each wave number once, the first of them (0,0)
};

}  // namespace asperity
