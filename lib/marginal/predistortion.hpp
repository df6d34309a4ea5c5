/// The autocorrelation that a Gaussian field y needs so that its translation z = g(y) has the target's.
///
///     ρ(p,q) = R_z⁻¹(R(p,q)),    R_z of marginal/correlation_map.hpp,                                    (1)
/// is a target like any other: a surface z = σ g(y) drawn with its kernel has R_z of what the kernel
/// achieves.
///
/// No ρ gives a correlation below R_z(-1); there the target is R_z(-1). For a smooth target the spectrum of ρ
/// may become slightly negative; acf/attempts.hpp has the remedy.
///
/// M. Grigoriu, Simulation of stationary non-Gaussian translation processes, J. Eng. Mech. 124 (1998)
/// 121-126.
#pragma once

#include <memory>

#include "acf/kernel.hpp"
#include "acf/target.hpp"
#include "marginal/correlation_map.hpp"

namespace asperity {

class Predistortion {
 public:
  explicit Predistortion(const Translation& g) : map_(std::make_shared<const CorrelationMap>(g)) {}

  const CorrelationMap& map() const { return *map_; }
  /// (1), sampled as `heights` is.
  Target target(const Target& heights) const;
  /// The largest amount by which the autocorrelation of the heights falls below R_z(-1) [σ²].
  double change(const Target& heights) const;

  /// The kernel that the request asks for: its coefficients are those of y, of unit variance, its tables and
  /// errors those of the heights, but `residual` that of y. Throws as solve_kernel does, and
  /// ParameterError("marginal"), or DataError("acf") for a table, where the change is more than `infeasible`
  /// allows.
  Kernel solve(const KernelRequest& heights) const;

 private:
  void translate(Kernel& kernel, const Target& heights) const;

  std::shared_ptr<const CorrelationMap> map_;
};

}  // namespace asperity
