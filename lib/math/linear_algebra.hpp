/// Eigen's dense decompositions, compiled once.
///
/// Accuracy  ε times the condition of the matrix.
/// Cost      O(n³).
#pragma once

#include <optional>

#include <Eigen/Core>

namespace asperity {

/// The eigenvalues of a symmetric matrix, ascending.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix);

/// L with L Lᵀ = C, a covariance; eigenvalues that round-off made negative are zero.
Eigen::MatrixXd covariance_root(const Eigen::MatrixXd& covariance);

/// A x = b of a positive definite A, of which the lower triangle is read; nothing where a pivot of LDLᵀ is
/// not above `least_pivot` of the largest.
std::optional<Eigen::VectorXd> solve_positive(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                                              double least_pivot);

/// A x = b of any 3 × 3 matrix; of a singular one a solution of those that are nearest.
Eigen::Vector3d solve(const Eigen::Matrix3d& matrix, const Eigen::Vector3d& right);

}  // namespace asperity
