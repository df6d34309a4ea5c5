/// A system F(u) = 0 as the iterations see it, and what they report.
///
/// J and M ≈ J⁻¹ belong to the iterate of the last `linearize`; only products J v and M v are asked for. Exceptions
/// thrown by the system pass through the iterations; a call of SUNDIALS that fails becomes a std::runtime_error
/// naming it. An iteration that does not arrive is no exception: the result says so.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace asperity {

struct NonlinearSystem {
  /// f = F(u); false when u lies outside the domain of F, whereupon a shorter step is tried.
  std::function<bool(std::span<const double> u, std::span<double> f)> residual;
  /// Prepares `jacobian` and `precondition` for the iterate u.
  std::function<void(std::span<const double> u)> linearize;
  /// out = J v
  std::function<void(std::span<const double> v, std::span<double> out)> jacobian;
  /// v = M v
  std::function<void(std::span<double> v)> precondition;
  /// d: the scale of the unknowns and of the equations, one positive number each.
  std::vector<double> scale;
};

struct IterationResult {
  bool converged = false;
  std::string reason;  ///< how it ended
  long steps = 0, residuals = 0, jacobian_products = 0, preconditionings = 0;
  double seconds = 0;
  double system_seconds = 0;  ///< of them in the system's functions, of Newton's iteration
};

/// The name and version of the library behind the iterations.
std::string sundials_version();

}  // namespace asperity
