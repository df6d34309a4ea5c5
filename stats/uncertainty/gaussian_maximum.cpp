#include "stats/uncertainty/gaussian_maximum.hpp"

#include <algorithm>

#include <Eigen/Eigenvalues>

#include "math/noise.hpp"

namespace asperity {

GaussianMaximum::GaussianMaximum(const Eigen::MatrixXd& correlation, Of of) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(correlation);
  const Eigen::MatrixXd root =
      solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
  Eigen::VectorXd normals(root.cols());
  WhiteNoise noise(1);
  maxima_.reserve(draws);
  for (int draw = 0; draw < draws; ++draw) {
    noise.row(draw, {normals.data(), static_cast<std::size_t>(normals.size())});
    const Eigen::VectorXd values = root * normals;
    maxima_.push_back(of == Of::values ? values.maxCoeff() : values.cwiseAbs().maxCoeff());
  }
  std::ranges::sort(maxima_);
}

double GaussianMaximum::exceedance(double value) const {
  const auto above = maxima_.end() - std::ranges::lower_bound(maxima_, value);
  return static_cast<double>(above + 1) / (draws + 1);
}

double GaussianMaximum::quantile(double tail) const {
  return maxima_[static_cast<std::size_t>((1 - tail) * (draws - 1))];
}

}  // namespace asperity
