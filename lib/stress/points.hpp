/// The stress at points anywhere below a loaded surface, in the same field as stress/layers.hpp.
///
/// Free half-space: the load is constant in each cell, and the stress the sum over the loaded cells,
///     σ(x, y, z) = Σ_{i,j} p(i,j) s(x - x_i, y - y_j, z),                                              (1)
/// s being that below a unit load on a cell, with its friction (stress/influence.hpp).
///
/// Where the cells repeat along one axis, their sum over the images is that of stress/images.hpp:
///     σ = Σ_j P_j p̄_j + Σ_{i,j} (p(i,j) - p̄_j) S(x - x_i, y - y_j, z),                                 (2)
/// p̄ the mean along that axis, P the stress below a strip.
///
/// Periodic half-space: the load is the trigonometric polynomial through the pressures of the cells, and the
/// stress the sum over its modes, each with its symbol (stress/layer_influence.hpp),
///     σ(x, y, z) = Σ_{kx,ky} (-i)^m S(qx,qy,z) p^(kx,ky) exp(i (qx (x-x_0) + qy (y-y_0))).              (3)
/// A mode of half the cells stands for both its directions, half of it for each. Positions a period apart are
/// the same. At the surface the polynomial swings between the centres, by 14 % of a step of the pressure,
/// half a cell below it by 3 %, a cell below it by 0.6 %.
///
/// On a side of a cell, to 1e-9 of its length, (1) and (2) take the limits of stress/influence.hpp on the
/// edge of both cells: where the load steps, σzz at the surface is the mean of the two pressures, or of the
/// four about a corner.
///
/// Accuracy  (1) 4e-13 of the stress, however far; (2) 1e-11 of max p; (3) ε n max p on n × n cells, as
///           the layers.
/// Cost      (1) some 1 µs a loaded cell; (2) 20 times that, but 1 µs a row that is uniform; (3) a transform
///           once, then some 0.015 µs for each pair of modes ±kx that is felt: nx ny / 4 at the surface, at
///           most 32 Lx Ly / z² at depth z.
#pragma once

#include <optional>
#include <vector>

#include "stress/load.hpp"
#include "stress/resolution.hpp"

namespace asperity {

class StressPoints {
 public:
  /// Throws as LoadedBody::check does.
  explicit StressPoints(LoadedBody body, int threads = 1);

  /// Throws ParameterError("depth") as check_depth does, ("place") unless |x| and |y| are as bounded.
  stress::Tensor at(double x, double y, double z) const;

  /// Whether components are infinite there: at the surface of a free load, on a side of a cell across which
  /// the traction steps (σxx, σyy, σxy), or at a corner about which the pressures have a twist (σxy), by more
  /// than 1e-3 of the largest pressure. at() then has a finite value in place of the logarithm of the
  /// distance 0 (stress/influence.hpp), which is right to order 2 where the cells are those of a smooth load.
  bool singular(double x, double y, double z) const;

  const LoadedBody& body() const { return body_; }

 private:
  struct Axis;
  std::array<Axis, 2> axes(double x, double y) const;  ///< of a point that is not below waves
  stress::Tensor below_cells(double x, double y, double z) const;
  stress::Tensor below_images(double x, double y, double z) const;
  stress::Tensor of_cell(double x, double y, double z, double a, double b) const;
  stress::Tensor of_images(const Axis& along, Index cell, double across, double z) const;
  stress::Tensor below_waves(double x, double y, double z) const;
  double mean_at(Index k) const;  ///< likewise, across

  LoadedBody body_;
  LoadWeights weights_;
  std::optional<Resolution> modes_;  ///< of a periodic load
};

/// The same of a free load, much faster, for the many points of a search.
///
/// The sum (1) over the corners of the cells, each corner function times the twist of the pressures about it
/// (stress/influence.hpp), by the vector forms of stress/corner.hpp; corners without a twist are left out.
/// Where corners cancel, deeper than 100 √m cells below m that are loaded, and below loads that repeat, it is
/// StressPoints that sums.
///
/// Accuracy  1e-10 of the stress below the load.
/// Cost      11 to 30 ns a corner; one double a corner.
class CellSum {
 public:
  explicit CellSum(LoadedBody body, int threads = 1);

  stress::Tensor at(double x, double y, double z) const;

 private:
  /// Rows of eight corners, at least one with a twist.
  struct Block {
    Index i, j, rows;  ///< of the first corner
    std::size_t twists;
  };
  void add(const Block& block, double x, double y, double z, stress::Tensor& sum) const;

  Grid grid_;
  double poisson_, deepest_;
  LoadWeights weights_;
  StressPoints points_;
  std::vector<Block> blocks_;
  std::vector<double> twists_;  ///< [block][row][8]
};

}  // namespace asperity
