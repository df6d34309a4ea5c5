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

/// Solves A x = b for a positive definite A, reading its lower triangle only; returns nothing if a pivot of
/// LDLᵀ does not exceed `least_pivot` times the largest.
std::optional<Eigen::VectorXd> solve_positive(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                                              double least_pivot);

/// Solves A x = b for any 3 × 3 matrix; for a singular one, gives one of the least-squares solutions.
Eigen::Vector3d solve(const Eigen::Matrix3d& matrix, const Eigen::Vector3d& right);

}  // namespace asperity
