/// The influence of a cell near the surface in two parts, (1) of stress/shallow.hpp: near and far.
///
/// The near part w K reaches 15 cells. The far part (1 - w) K is smooth: at four depths, at the middles of
/// cells four times as long and wide, it is the layer below their mean pressures less what w K makes of the
/// cells within 16; at other depths the cubic through the four.
#pragma once

#include <array>
#include <vector>

#include "stress/maximum.hpp"

namespace asperity {

/// w reaches this far [cells].
inline constexpr Index near_reach = 15;

struct NearKernel {
  /// For cells `s` times as wide as those of the body, for the lags -n … n, at depth z [m].
  NearKernel(const LoadedBody& body, Index s, Index n, double z);

  const stress::Tensor& at(Index i, Index j) const { return lags[size((n + i) * (2 * n + 1) + n + j)]; }
  /// Under a unit load everywhere.
  stress::Tensor sum() const;
  /// The largest value under any loads between 0 and 1: ascent from six states of stress, each step the loads
  /// whose K : ∂f/∂σ is positive. f being convex, a step never leads down.
  double largest(Criterion of) const;

  Index n;
  std::vector<stress::Tensor> lags;  ///< [2n+1][2n+1]
};

class FarStress {
 public:
  static constexpr Index wide = 4;
  using Weights = std::array<double, 4>;

  FarStress(const LoadedBody& body, int threads);

  Shape shape() const { return shape_of(layers_[0][0]); }
  /// Of the four layers, at depth z [m].
  Weights weights(double z) const;
  stress::Tensor at(const Weights& weights, Index i, Index j) const;

 private:
  Weights depths_;
  std::array<std::array<Field, 6>, 4> layers_;
};

}  // namespace asperity
