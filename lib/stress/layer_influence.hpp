/// How a layer at depth z answers to the surface pressure, mode by mode.
///
/// In a layer every stress component is a convolution of the pressure with a kernel that is even or odd in
/// each direction, so its spectrum is a real symbol S times a power of -i:
///     σ^(kx,ky) = (-i)^m S(kx,ky) p^(kx,ky),   m = [odd in x] + [odd in y]  (stress/component.hpp).      (1)
///
/// Free half-space, loaded on a bounded domain: the kernel is the stress below a loaded cell,
///     K(i,j) = S[f] / 2π  at x = iΔx, y = jΔy  (stress/influence.hpp),                                  (2)
/// on a torus that keeps the convolution linear. Exact for a pressure constant in each cell.
///
/// Periodic half-space, loaded by a pressure that repeats itself: the potential theory of one wave [1] gives
///     zz  -(1+qz) e                xz  -qx z e                xy  (qx qy/q) ((1-2ν)/q - z) e
///     xx  -2ν e - (qx²/q) ((1-2ν)/q - z) e,   yy, yz likewise,   e = exp(-qz), q² = qx² + qy².          (3)
/// Exact for a pressure that is a trigonometric polynomial. Its mean p̄ acts on a body held laterally:
/// σzz = -p̄, σxx = σyy = -ν/(1-ν) p̄.
///
/// Symbols   qx, qy  wave numbers [1/m]     z  depth [m]     ν  Poisson's number     p^  spectrum of p
/// Cost      (2): nx ny corners and, per component, half the complex transforms of the kernel;
///           (3): one exponential a mode and component.
///
/// [1] K. L. Johnson, Contact Mechanics, Cambridge 1985, ch. 13.
#pragma once

#include <memory>

#include "grid/field.hpp"
#include "stress/component.hpp"
#include "transform/plan.hpp"

namespace asperity {

/// The symbol of one layer after the other; an object holds the work space of one thread.
class LayerInfluence {
 public:
  static constexpr Index width = 8;  ///< columns ky in a block

  /// S for the columns of a block, by pairs: column 8b + 2c is the real, 8b + 2c+1 the imaginary part of
  /// pairs[c·stride + kx], 0 ≤ kx ≤ Px/2.
  struct Symbol {
    const Complex* pairs;
    Index stride;
  };

  virtual ~LayerInfluence() = default;
  /// Goes to depth z [m] for the components asked.
  virtual void descend(double z, stress::Set asked) = 0;
  /// S of component c for the columns 8b … 8b+7; good until it is asked for again.
  virtual Symbol symbol(stress::Component c, Index b) = 0;
};

/// (3) when the grid is periodic, else (2). The torus is Px × Py; a periodic grid is its own.
std::unique_ptr<LayerInfluence> make_layer_influence(const Grid& grid, Shape torus, double poisson);

}  // namespace asperity
