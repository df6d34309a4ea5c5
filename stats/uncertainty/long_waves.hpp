/// Standard errors of means over a field, whatever its correlation and the distribution of its heights.
///
/// The mean f̄ of a local function f of a field - z², a squared slope, 1 below some height - is its wave of
/// number zero, and its error follows from its K longest other waves (stats/uncertainty/wave_spectra.hpp),
///     c_k = 1/N Σ (f - f̄) u_k,                                                                        (1)
/// the products u_k of cosines of up to six half waves along either side, of mean square 1, with
///     0 < ν ≤ 20,     ν = ν_x²/e + ν_y² e,                                                              (2)
/// e the number of correlation lengths along x over that along y: K = 21 at e = 1, 6 on a long field. Along a
/// periodic axis they are sines and cosines of up to three whole waves, of all products of which the squares
/// add up to the same wherever the period is cut.
/// Over the points of a field with missing heights the cosines are neither of mean 0 nor of mean square 1,
/// nor orthogonal. There u_k are directions of their covariance over the points,
///     C = 1/N Σ (u - ū)(u - ū)ᵀ = Σ_k λ_k e_k e_kᵀ,     u_k = e_kᵀ (u - ū)/√λ_k,                         (3)
/// without those that hardly vary there, λ_k < λ_max/5, which are less and less like long waves, and turned
/// among themselves so that the numbers
///     ν_k = Σ_j e_kj² ν_j                                                                              (4)
/// are stationary: eigenvalues of the ν_j between directions. Of a complete field they are the cosines.
/// The error of a function g of several means is that of the local function Σ (∂g/∂f̄_a) f_a.
///
/// Symbols   N  points      ν_x, ν_y  half waves along the sides      N_p  independent patches
///           (stats/uncertainty/effective_size.hpp)
/// Scope     means over a field that holds some ten independent values or more.
/// Accuracy  docs/accuracy/asperity-stats.md, and wave_spectra.hpp.
/// Cost      for each of m functions 14 operations a point for the waves and m for Var[f]; 100 a point for
///           (3) where a row has missing heights.
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "core/field.hpp"
#include "stats/filter/axis_products.hpp"
#include "stats/uncertainty/wave_spectra.hpp"

namespace asperity {

/// How large a field is in terms of its correlation.
struct FieldExtent {
  double patches = 0;     ///< independent ones (stats/uncertainty/effective_size.hpp)
  double elongation = 1;  ///< correlation lengths along x over those along y
  double negative = 0;    ///< share of Σ ρ² where ρ < 0: hardly any but of a lay
};

/// The waves along an axis of n points, of mean square 1: 1, then the longest `count`, a column each.
Eigen::MatrixXd axis_waves(Index n, bool periodic, Index count);
/// The same at the places π (i + ½)/n = `phase`.
Eigen::MatrixXd axis_waves(const Eigen::ArrayXd& phase, bool periodic, Index count);
/// ν of its column j.
inline Index half_waves(Index j, bool periodic) { return periodic ? j + j % 2 : j; }

/// The products of waves along either axis of a grid: the waves of a field.
class AxisWaves {
 public:
  static constexpr Index most = 6;  ///< along an axis

  explicit AxisWaves(const Grid& grid);
  const Eigen::MatrixXd& x() const { return products_.x(); }  ///< a column each
  const Eigen::MatrixXd& y() const { return products_.y(); }
  /// Where the product of waves j along x and k along y stands in `Squares`.
  static constexpr Index number(Index j, Index k) { return j * (most + 1) + k; }
  /// Σ u_k u_l over the points of a field.
  using Squares = Eigen::MatrixXd;
  static Squares none() { return Squares::Zero(number(most + 1, 0), number(most + 1, 0)); }
  /// Adds those of row i, whose points are 1, others 0.
  void add_row(Squares& squares, Index i, const Eigen::VectorXd& points) const {
    products_.add_row(squares, i, points);
  }

 private:
  AxisProducts products_;
};

/// The waves (2), or those of lower ν.
class LongWaves {
 public:
  using Wave = AxisProducts::Term;               ///< columns of the axes' waves
  static constexpr double reach = 20, near = 5;  ///< ν

  LongWaves() = default;
  LongWaves(const Grid& grid, const FieldExtent& extent, double most = reach);
  const std::vector<Wave>& all() const { return all_; }
  const LongWaveNumbers& numbers() const { return numbers_; }

  /// (3), (4).
  struct Directions {
    Eigen::MatrixXd factors = {};  ///< e_k/√λ_k, a row each
    LongWaveNumbers numbers = {};  ///< (4), and ν_x, ν_y of the wave of the largest e_kj²
  };
  Directions directions(const AxisWaves::Squares& squares) const;

 private:
  std::vector<Wave> all_ = {};
  LongWaveNumbers numbers_ = {};
};

/// The means of some local functions and their long waves.
class LocalMeans {
 public:
  using Function = std::function<double(const Eigen::VectorXd& means)>;

  double operator()(const Function& g) const { return g(means_); }
  /// Of g; NaN if g is not a number beside the means, 0 if it does not vary.
  WaveError error(const Function& g) const;
  Index waves() const { return waves_.cols(); }  ///< K

 private:
  friend class LocalSums;
  WaveSpectra spectra_ = {};
  Eigen::VectorXd means_ = {};
  Eigen::MatrixXd waves_ = {};       ///< c_k, a row a function
  Eigen::VectorXd deviations_ = {};  ///< of the functions at one point
};

/// The sums of a field.
class LocalSums {
 public:
  /// A row a point along y, a column a function, after a first one; a point with a NaN counts for none.
  using Values = Eigen::MatrixXd;

  LocalSums(const Grid& grid, Index functions);
  /// Of the first rows: fill(i, values) sets columns 1, 2, … of row i < rows, which are NaN.
  void add_rows(Index rows, int threads, const std::function<void(Index i, Values& values)>& fill);
  double count() const { return sums_.waves[0](0, 0); }  ///< of the points
  LocalMeans means(const FieldExtent& extent) const;

 private:
  struct Sums {
    std::vector<Eigen::MatrixXd> waves;  // Σ u_jk f_a, by j: a row a function, the first of which is 1
    Eigen::VectorXd powers;              // Σ f_a²
    AxisWaves::Squares squares;

    void operator+=(const Sums& more) {
      for (std::size_t j = 0; j < waves.size(); ++j) waves[j] += more.waves[j];
      powers += more.powers, squares += more.squares;
    }
  };
  Sums none() const;
  void add_row(Sums& sums, Index i, Values& values) const;

  Grid grid_;
  Index functions_;
  AxisWaves along_;
  Sums sums_;
};

}  // namespace asperity
