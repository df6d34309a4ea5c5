/// Standard errors of means over a field, whatever its correlation and the distribution of its heights.
///
/// The mean f̄ of a local function f of a field - z², a squared slope, 1 below some height - is its wave of
/// number zero. The longest other waves of f have nearly the same variance, and their mean is known to be
/// zero:
///     Var[f̄] ≈ 1/K Σ_k c_k² / (1 - L)²,     c_k = 1/N Σ (f - f̄) u_k,                                   (1)
/// with the K products u_k of cosines of up to four half waves along either side, of mean square 1, that are
/// longest in correlation lengths,
///     0 < ν_x²/e + ν_y² e ≤ 1.1 J²,     J² = 2, 5, 10, 20 from N_p = 0, 160, 640, 2560 on,               (2)
/// e the number of correlation lengths along x over that along y: K = 3, 7, 12, 21 at e = 1, 4 on a long
/// field. Along a periodic axis they are sines and cosines of up to two whole waves, and J² is 4 at least.
/// Over the points of a field with missing heights the cosines are neither of mean 0 nor of mean square 1,
/// nor orthogonal. There u_k are instead the directions of their covariance over the points,
///     C = 1/N Σ (u - ū)(u - ū)ᵀ = Σ_k λ_k e_k e_kᵀ,     u_k = e_kᵀ (u - ū)/√λ_k,                         (3)
/// without those that hardly vary there, λ_k < λ_max/5, which are less and less like long waves: K is lower.
/// Of a complete field C = 1.
/// The spectrum falls from wave number zero on; with ν = Var[f]/Var[f̄] independent values,
///     L = ¾ (0.3/√ν + (1.4 + 0.7 J²)/ν),  0.4 at most,                                                   (4)
/// is three quarters of what an exponential correlation loses, and three halves of what a Gaussian one does.
/// The error of a function g of several means is that of the local function Σ (∂g/∂f̄_a) f_a. On few patches
/// c_k² is skewed, and low where f̄ is low. Intervals use Student's t of
///     K N_p/(N_p + 20), 1.6 at least, K at most,                                                         (5)
/// degrees of freedom, fitted to eleven textures of N_p = 9 to 330.
///
/// Symbols   N  points      N_p  independent patches (stats/uncertainty/effective_size.hpp)
/// Scope     means over a field that holds some ten independent values or more.
/// Accuracy  the error itself is known to 1/√(2K); coverage: validation/error_coverage. Of 200 fields of
///           128 × 128 points with exponential and Gaussian correlation, N_eff 325, of which a half, a disc,
///           a corner of 45 % of the sides, all but a quarter, one row or one in 64, or a random half was
///           measured, errors of the mean, Sq, quantiles and shares are 0.91 to 1.39 of the true ones, and
///           87 to 98 % of the 95 % intervals hold the truth.
/// Cost      for each of m functions 10 operations a point for the waves and m for Var[f]; 50 a point for (3)
///           where a row has missing heights.
///
/// U. K. Müller, HAC corrections for strongly autocorrelated time series, J. Bus. Econ. Stat. 32 (2014)
/// 311-322, in one dimension.
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "core/field.hpp"
#include "stats/filter/axis_products.hpp"

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
  static constexpr Index most = 4;  ///< along an axis

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

/// The waves (2).
class LongWaves {
 public:
  using Wave = AxisProducts::Term;  ///< columns of the axes' waves
  /// Bounds of J².
  struct Range {
    double least = 0, most = 20;
  };
  LongWaves() = default;
  LongWaves(const Grid& grid, const FieldExtent& extent, const Range& range = {0, 20});
  const std::vector<Wave>& all() const { return all_; }
  /// The factors e_k/√λ_k of (3), a row each.
  Eigen::MatrixXd directions(const AxisWaves::Squares& squares) const;
  double degrees(Index waves, double half = 20) const;  ///< (5), of so many; half are left at N_p = half
  double loss(double independent) const;                ///< (4)
  /// √(1), of 1/K Σ c_k² and the variance of the local function at one point.
  double error(double variance, double at_point) const;

 private:
  double patches_ = 0, largest_ = 0;  // N_p, J²
  std::vector<Wave> all_ = {};
};

/// The means of some local functions and their long waves.
class LocalMeans {
 public:
  using Function = std::function<double(const Eigen::VectorXd& means)>;

  double operator()(const Function& g) const { return g(means_); }
  /// Standard error of g; NaN if g is not a number beside the means, 0 if it does not vary.
  double error(const Function& g) const;
  double degrees() const { return long_waves_.degrees(waves_.cols()); }  ///< of freedom, (5)
  Index waves() const { return waves_.cols(); }                          ///< K

 private:
  friend class LocalSums;
  LongWaves long_waves_ = {};
  Eigen::VectorXd means_ = {};
  Eigen::MatrixXd waves_ = {};       ///< c_k, a row a function
  Eigen::MatrixXd covariance_ = {};  ///< of the functions at one point
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
    Eigen::MatrixXd products;            // Σ f_a f_b
    AxisWaves::Squares squares;

    void operator+=(const Sums& more) {
      for (std::size_t j = 0; j < waves.size(); ++j) waves[j] += more.waves[j];
      products += more.products, squares += more.squares;
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
