/// The same bodies under one load after another.
///
/// The solution depends on the load, not on those before, but they serve as a start: under Q₂ with
///     p ≈ max(0, p₁ + (p₁ - p₀) (Q₂ - Q₁)/(Q₁ - Q₀)),   after the first load p ≈ p₁ Q₂/Q₁,      (1)
/// and no coarser grids; influence coefficients and plans are made once. The stiffness is each solution's own
/// (contact/stiffness.hpp), no difference of loads.
///
/// Symbols   Q load [N]   p pressure [Pa]
/// Cost      as many convolutions a load as from coarser grids, for (1) knows the edge of the contact no
///           better. At 256 × 256 cells, ε = 1e-8, eighteen loads a decade: 5 for smooth spheres, 10 for
///           rough ones, half as many again for the stiffness.
#pragma once

#include <functional>
#include <span>

#include "contact/elastic_operator.hpp"
#include "contact/solver.hpp"

namespace asperity {

/// Presses with each of the loads, which increase, in place of parameters.load, and hands the solutions on as
/// they come. Throws before the first: ParameterError("sweep") when one is not above the load before it, or
/// more than the limit pressure carries, and as ContactParameters::check does.
void solve_load_sequence(const Grid& grid, const Field& undeformed_gap, ElasticOperator& influence,
                         ContactParameters parameters, std::span<const double> loads,
                         const std::function<void(const Contact&)>& take);

}  // namespace asperity
