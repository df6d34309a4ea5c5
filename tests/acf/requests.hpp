/// What the tests of kernels ask for.
#pragma once

#include <vector>

#include "acf/kernel.hpp"
#include "reference/exponential_target.hpp"
#include "support.hpp"

namespace asperity::test {

/// The exponential that has fallen to e⁻ᶜ at the last lags n × m, with all of them prescribed.
inline KernelRequest cut(Index n, Index m, double c, Formulation formulation = Formulation::symmetric) {
  KernelRequest request;
  request.target = ExponentialTarget{static_cast<double>(n), static_cast<double>(m), std::exp(-c)};
  request.lags = {n, m};
  request.formulation = formulation;
  return request;
}

/// The (n, m) of Creţu, Bălan and Urzică, lengths of the autocorrelation in samples.
inline const std::vector<Shape> paper{{7, 4}, {3, 3}, {17, 4}, {17, 14}, {13, 13}};

/// Newton's last step leaves ‖F‖ below 1e-10, and no eigenvalue of J is below 2 min a^ = 0.5 (at 31 x 31):
/// the coefficients are good to 2e-10, the references to 1e-12.
inline constexpr double coefficient_error = 1e-9;

}  // namespace asperity::test
