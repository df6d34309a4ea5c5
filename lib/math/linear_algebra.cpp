#include "math/linear_algebra.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace asperity {

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::MatrixXd covariance_root(const Eigen::MatrixXd& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
}

std::optional<Eigen::VectorXd> solve_positive(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                                              double least_pivot) {
  const Eigen::LDLT<Eigen::MatrixXd> factors(matrix);
  const Eigen::ArrayXd pivots = factors.vectorD();
  if (!(pivots.minCoeff() > least_pivot * pivots.maxCoeff())) return std::nullopt;
  return factors.solve(right);
}

Eigen::Vector3d solve(const Eigen::Matrix3d& matrix, const Eigen::Vector3d& right) {
  return matrix.fullPivLu().solve(right);
}

}  // namespace asperity
