/// The same bodies under one load after another, up or down.
///
/// An elastic solution depends on its load alone. With a limit pressure the greatest load so far, Q_m, has
/// left its flattening w (contact/energy.hpp), and a smaller load presses what it left,
///     h + w in place of h,                                                                    (1)
/// which carries Q_m elastically and so, on the way down and up again, any load below. A load above Q_m
/// flattens on, as if it had come first. A way up to Q_m and down loses the energy
///     ∮ Q dδ = p_Y ∫ w dA                                    (contact/energy.hpp).            (2)
///
/// The solutions before serve as a start: under Q₂ with
///     p ≈ max(0, p₁ + (p₁ - p₀) (Q₂ - Q₁)/(Q₁ - Q₀)),   after the first load p ≈ p₁ Q₂/Q₁,      (3)
/// and no coarser grids; influence coefficients and plans are made once. The stiffness is each solution's own
/// (contact/stiffness.hpp), no difference of loads.
///
/// Symbols   Q load [N]   p pressure [Pa]   p_Y limit pressure [Pa]   h undeformed gap [m]
///           w flattening [m]   δ approach [m]
/// Cost      as many convolutions a load as from coarser grids, for (3) knows the edge of the contact no
///           better. At 256 × 256 cells, ε = 1e-8, eighteen loads a decade: 5 for smooth spheres, 10 for
///           rough ones, half as many again for the stiffness.
#pragma once

#include <functional>
#include <span>

#include "contact/elastic_operator.hpp"
#include "contact/solver.hpp"

namespace asperity {

/// Presses with each of the loads in turn, in place of parameters.load, and hands the solutions on as they
/// come. Throws before the first: ParameterError("sweep") when one equals the load before it, is not above 0
/// or is more than the limit pressure carries, and as ContactParameters::check does.
void solve_load_sequence(const Grid& grid, const Field& undeformed_gap, ElasticOperator& influence,
                         ContactParameters parameters, std::span<const double> loads,
                         const std::function<void(const Contact&)>& take);

}  // namespace asperity
