/// A loaded half-space: the pressure on its surface, and the friction of what slides over it.
///
/// Where one body slides over the other everywhere, Coulomb's law gives the traction on the loaded surface
///     q = μ p (cos α, sin α),                                                                          (1)
/// α being the direction, from x towards y, in which the other body slides over this one. The traction is
/// taken not to alter the pressure, which is exact for bodies of the same material and small otherwise [1].
///
/// [1] K. L. Johnson, Contact Mechanics, Cambridge 1985, section 7.2.
#pragma once

#include <array>
#include <limits>

#include "core/extent.hpp"
#include "core/field.hpp"
#include "core/ranks.hpp"
#include "stress/component.hpp"

namespace asperity {

/// Of each traction per unit pressure, by stress::Traction.
using LoadWeights = std::array<double, 3>;

struct Friction {
  double coefficient = 0;  ///< μ ≥ 0
  double angle = 0;        ///< α [rad], a full circle either way at most

  /// Throws ParameterError("friction") or ("friction-angle").
  void check() const;
  /// 1, μ cos α, μ sin α. Within 1e-12 of a multiple of 90° only one traction acts.
  LoadWeights weights() const;
};

stress::Tractions acting(const LoadWeights& weights);

struct LoadedBody {
  Grid grid;
  Field pressure;  ///< of each cell [Pa]; of several ranks, the rows that this one has
  double poisson = std::numeric_limits<double>::quiet_NaN();  ///< ν, to be given
  Friction friction = {};
  const Ranks* ranks = &alone();  ///< that hold it together; what follows is then collective

  Slabs rows() const { return Slabs(grid.shape.nx, *ranks); }
  /// Of one rank: the pressure of a cell, also beyond the edges, where it is 0 or repeats.
  double at(Index i, Index j) const {
    const auto [nx, ny] = grid.shape;
    if (grid.periodic.x) i = wrapped(i, nx);
    if (grid.periodic.y) j = wrapped(j, ny);
    return i >= 0 && j >= 0 && i < nx && j < ny ? pressure(i, j) : 0;
  }
  /// The largest and the least pressure.
  double largest() const;
  double least() const;
  /// With all rows on the first rank, where it is alone; the others have none.
  LoadedBody on_the_first() const;

  /// Throws ParameterError("poisson") unless -1 < ν ≤ ½ (core/poisson.hpp), ("friction") or
  /// ("friction-angle") unless they are such and the traction at most 1e100 Pa, DataError("pressure") unless
  /// the pressure fits a grid of cells, is finite and its largest value 0 or 1e-100 … 1e100 Pa.
  void check() const;
};

/// Places and depths reach so far [m]: squares of them are numbers that doubles hold.
inline constexpr double farthest = 1e30;
/// Throws ParameterError("depth") unless 0 ≤ z ≤ farthest.
void check_depth(double z);

/// What no stress below a load exceeds, from its sum alone, times z² [N]; infinite of a periodic load, which
/// no depth bounds.
///
/// Under a unit force, along z or along the surface, the stress at depth z is s(t)/z², t the distance from
/// its axis over z. So under any load of the sum P = Σ|p| ΔxΔy, friction μ, ‖σ‖ = √(Σ σij²) is at most
///     (N + μ T) P / z²,   N = max ‖s‖ of the normal force, T of the tangential one,                     (2)
/// and the von Mises stress, the principal stresses, the maximum shear and every component at most √(3/2) of
/// it. At ν = ½, N = 3/2π, on the axis. Both maxima are taken over a lattice of t, spaced 0.04 as far as t =
/// 4, where the norm has fallen to a sixth, and raised by a percent; finer ones find 5e-4 more.
double stress_bound(const LoadedBody& body);

}  // namespace asperity
