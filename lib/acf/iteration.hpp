/// The reports of an iteration: its steps while it runs, and its result.
///
/// Exceptions that the equations throw pass through the iterations; a call of SUNDIALS that fails becomes a
/// std::runtime_error naming it. An iteration that does not arrive is no exception: its result says so.
#pragma once

#include <functional>
#include <string>

namespace asperity {

struct IterationStep {
  long step = 0;        ///< 0: the start
  long products = 0;    ///< with the Jacobian, or transforms there and back where there is none
  double residual = 0;  ///< max |R - target| over the equations [σ²]
  double spent = 0;     ///< the share used up of the steps or products that it may take
};

using IterationObserver = std::function<void(const IterationStep&)>;

struct IterationResult {
  bool converged = false;
  std::string reason;  ///< how it ended
  long steps = 0, residuals = 0, jacobian_products = 0, preconditionings = 0;
  double equation_seconds = 0;  ///< in residuals, products and preconditionings of Newton's iteration
};

/// The name and version of the library behind Newton's iteration.
std::string sundials_version();

}  // namespace asperity
