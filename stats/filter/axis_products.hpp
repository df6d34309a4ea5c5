/// Products of functions of x and functions of y, orthonormal over the measured points of a field.
///
/// With f_a along x and g_b along y, each orthonormal over its axis, the products φ_t = f_a g_b of a list of
/// terms t = (a, b) are orthonormal over a complete field. Over the points that are measured they have
///     G_st = Σ φ_s φ_t,                                                                              (1)
/// and by G = E Λ Eᵀ the combinations
///     ψ_k = Σ_t T_kt φ_t,     T = Λ^{-1/2} Eᵀ,     Σ ψ_k ψ_l = 1 if k = l, else 0.                     (2)
/// Those that hardly vary over the points, of a small λ_k, may be left out.
///
/// Forms (form.hpp), what they take (stats/uncertainty/form_modes.hpp) and long waves
/// (stats/uncertainty/long_waves.hpp) are such products.
///
/// Accuracy  ε λ_max/λ_k.
/// Cost      of (1) for M terms M² a row, and (number of g)² a point of rows with missing heights; of (2) M³.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/field.hpp"

namespace asperity {

class AxisProducts {
 public:
  struct Term {
    Index a, b;  ///< columns of the functions along x and y
  };
  AxisProducts() = default;
  /// A column a function.
  AxisProducts(Eigen::MatrixXd along_x, Eigen::MatrixXd along_y, std::vector<Term> terms);

  const Eigen::MatrixXd& x() const { return x_; }
  const Eigen::MatrixXd& y() const { return y_; }
  const std::vector<Term>& terms() const { return terms_; }
  Index count() const { return std::ssize(terms_); }

  Eigen::MatrixXd none() const { return Eigen::MatrixXd::Zero(count(), count()); }
  /// Adds to (1) the points of row i, which are 1, others 0.
  void add_row(Eigen::MatrixXd& gram, Index i, const Eigen::VectorXd& points) const;
  /// Adds those of all rows.
  void add(Eigen::MatrixXd& gram, const Field& points) const;
  /// Of each term, Σ φ_t z over heights, zero where missing.
  Eigen::VectorXd sums(const Field& z) const;
  /// Σ_t factors(t) φ_t.
  Field combined(const Eigen::VectorXd& factors) const;

 private:
  Eigen::MatrixXd x_ = {}, y_ = {}, of_complete_row_ = {};
  std::vector<Term> terms_ = {};
};

/// T of (2), a row each, ascending in λ_k, which is `share` of the largest and `least` at least.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& gram, double share, double least = 0);

// ---- axis ----

/// One of the two axes of a field.

enum class Axis1D { x, y };

}  // namespace asperity
