/// Displacement of an elastic half-space under cells of uniform pressure.
///
/// A unit pressure on the rectangle |x| ≤ a, |y| ≤ b displaces the surface at (x, y) by Love's [1]
///     u = [G(x+a; y,b) - G(x-a; y,b) + G(y+b; x,a) - G(y-b; x,a)] / (πE*),                   (1)
///     G(w; y,b) = w [asinh((y+b)/|w|) - asinh((y-b)/|w|)],
/// so that a grid of cells is displaced by the convolution
///     u(i,j) = Σ_{i',j'} K(i-i', j-j') p(i',j'),   K(i,j) = (1) at (iΔx, jΔy),               (2)
/// by transforms on a padded torus, without wrap-around [2]. Cells that repeat along one axis have
///     u(i,j) = Σ_{i',j'} K(i-i', j-j') p(i',j'),   K = S/πE* of contact/repeated_cell.hpp,   (3)
/// padded across alone. u counts from a datum: a line load in the middle does not move the domain's edges, so
/// that d is half the domain's size across. A surface that is periodic along both axes answers to waves,
///     u^(q) = 2 p^(q) / (E* |q|),   u^(0) = 0;                                               (4)
/// nothing is padded, and u has zero mean.
///
/// The preconditioner inverts K's transform on the torus of the field itself, M^ = 1/K^, K taken between
/// nearest images, or (4). It costs a third of (2) or less.
///
/// Where pressures vanish off a window of the grid, (2) takes the window's cells alone, (3) those of a whole
/// period. A window is grown to the cells that its torus has room for; none is made of more than three
/// quarters of the grid, or of (4). Grids, windows and M share one work space, and are made when first used.
///
/// Symbols   u displacement into the body [m]     p pressure [Pa]     E* composite modulus [Pa]
///           q wave vector [1/m]                  a, b half sides [m]
/// Accuracy  (1): 1e-12 relative up to 16 000 cells away, where the textbook form has lost ε (r/Δx)². From 20
///           cells on Gauss's rule over the rectangle takes over, from 160 the multipoles to the sixteenth:
///           1e-15. apply_single and M: 5e-7 of the largest value from 256² cells on, below to double.
/// Cost      set-up: one even transform and 10 ns a coefficient, of (3) 30 ns: together
///           0.6…1.2 of (2). Apply: transform/convolution.hpp; (3) 0.4…1 of (2). apply_single: half of apply.
///
/// [1] A. E. H. Love, The stress produced in a semi-infinite solid by pressure on part of the boundary,
///     Phil. Trans. R. Soc. A 228 (1929) 377-420.
/// [2] S. Liu, Q. Wang, G. Liu, A versatile method of discrete convolution and FFT (DC-FFT) for contact
///     analyses, Wear 243 (2000) 101-111.
#pragma once

#include <memory>

#include "contact/elastic_operator.hpp"
#include "core/field.hpp"

namespace asperity {

/// πE* u of (1) at (x, y) for the half sides a, b: ∬ dx'dy'/r over the rectangle [m].
double love_integral(double x, double y, double a, double b);

/// d of (3): the distance at which a line load displaces nothing [m]; 0 unless periodic along one axis.
double displacement_datum(const Grid& grid);

/// K of (2); of (3) where the grid is periodic along one axis, of (4) where it is along both.
std::unique_ptr<ElasticOperator> make_influence(const Grid& grid, double composite_modulus, int threads = 1,
                                                const Ranks& ranks = alone());

}  // namespace asperity
