/// How a layer at depth z answers to a load on the surface, mode by mode.
///
/// In a layer every stress component is a convolution of the pressure, or of a traction, with a kernel that
/// is even or odd in each direction, so its spectrum is a real transfer function S times a power of -i:
///     σ^(kx,ky) = (-i)^m S(kx,ky) p^(kx,ky),   m = [odd in x] + [odd in y]  (stress/component.hpp).      (1)
///
/// Free half-space, loaded on a bounded domain: the kernel is the stress below a loaded cell,
///     K(i,j) = S[f] / 2π  at x = iΔx, y = jΔy  (stress/influence.hpp),                                  (2)
/// on a torus that keeps the convolution linear. Exact for a load constant in each cell.
///
/// Periodic half-space, loaded by a pressure that repeats itself: the potential theory of one wave [1] gives
///     zz  -(1+qz) e                xz  -qx z e                xy  (qx qy/q) ((1-2ν)/q - z) e
///     xx  -2ν e - (qx²/q) ((1-2ν)/q - z) e,   yy, yz likewise,   e = exp(-qz), q² = qx² + qy²;          (3)
/// by a traction along x, with k = z + 2ν/q, w = e/q,
///     xx  -qx (2 + 2ν - k qx²/q) w   zz  -qx q z w            xz  -(q - z qx²) w
///     yy  -qx (2ν - k qy²/q) w       xy  -qy (1 - k qx²/q) w  yz  -qx qy z w;                           (4)
/// along y, x and y are exchanged. Exact for a trigonometric polynomial. A mean pressure p̄ acts on a body
/// held laterally, σzz = -p̄, σxx = σyy = -ν/(1-ν) p̄; a mean traction is met by itself, σxz = -q̄.
///
/// Symbols   qx, qy  wave numbers [1/m]     z  depth [m]     ν  Poisson's number     p^  spectrum of p
/// Cost      (2): nx ny corners and, per component and traction, half the complex transforms of the kernel;
///           (3), (4): one exponential a mode, component and traction. Memory: (2) nx ny doubles a traction.
///
/// [1] K. L. Johnson, Contact Mechanics, Cambridge 1985, ch. 13.
#pragma once

#include <memory>
#include <span>

#include "stress/load.hpp"
#include "stress/resolution.hpp"

namespace asperity {

/// Cells of a layer from which on threads share it, and components come one by one: at 512² that takes a
/// fifth longer, at 1024² as long (`volume` of validation/scaling).
inline constexpr Index shared_layer = 768 * 768;

/// Memory for kernels: in every block of columns, `stride` doubles after the one before, all of it.
struct KernelRoom {
  double* first = nullptr;
  Index stride = 0;
};

/// The transfer functions of one layer after the other, component by component; those of different blocks
/// may be requested by several threads, `worker` < threads telling them apart; of several ranks each asks for
/// its own blocks, and goes to depths and components with the others.
class LayerInfluence {
 public:
  static constexpr Index width = block_columns;
  static constexpr Index all_lags = -1;

  /// S for the columns of a block, by pairs: column 8b + 2c is the real, 8b + 2c+1 the imaginary part of
  /// pairs[c·stride + kx], 0 ≤ kx ≤ Px/2.
  struct TransferFunction {
    std::span<const Complex> pairs;
    Index stride = 0;
  };

  virtual ~LayerInfluence() = default;
  /// Goes to depth z [m], for the requested components; for the first `lags` alone, and then only for
  /// by_lags().
  virtual void set_depth(double z, stress::Set asked, Index lags = all_lags) = 0;
  /// Goes to one of them. Its kernels may be stored in `room`; a block is not read after its transfer
  /// functions.
  virtual void set_component(stress::Component c, KernelRoom room = {}) = 0;
  /// S under traction t for the columns 8b … 8b+7; good until the worker's next of the same traction.
  virtual TransferFunction transfer_function(stress::Traction t, Index b, int worker = 0) = 0;
  /// What the load seen from a plane x = const is multiplied with (stress/section.cpp), [m][8]: of (2), for
  /// the lag m + ½ in x, the corner function transformed along y, times (-i)^-[odd in y]; of (3), (4), S at m
  virtual std::span<const double> by_lags(stress::Traction t, Index b, int worker = 0) = 0;
};

/// Cells of this resolution under the acting tractions: (3), (4) when periodic, else (2), tapered; where they
/// are periodic along one axis, that of stress/images.hpp.
std::unique_ptr<LayerInfluence> make_layer_influence(const Resolution& resolution, double poisson,
                                                     stress::Tractions acting, int threads = 1);

}  // namespace asperity
