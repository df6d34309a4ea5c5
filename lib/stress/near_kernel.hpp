/// The near part of the influence of a cell, and the largest stress that any pattern of loads has under it.
///
/// w K of stress/shallow.hpp (1), for the lags to which w reaches, of a pressure with its friction.
#pragma once

#include <vector>

#include "stress/maximum.hpp"

namespace asperity {

/// w reaches this far [cells].
inline constexpr Index near_reach = 15;

struct NearKernel {
  /// Of cells `s` times as wide as those of the body, for the lags -n … n, at depth z [m].
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

}  // namespace asperity
