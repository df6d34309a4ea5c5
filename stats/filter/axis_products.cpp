#include "stats/filter/axis_products.hpp"

#include <algorithm>
#include <utility>

#include "math/linear_algebra.hpp"

namespace asperity {

AxisProducts::AxisProducts(Eigen::MatrixXd along_x, Eigen::MatrixXd along_y, std::vector<Term> terms)
    : x_(std::move(along_x)),
      y_(std::move(along_y)),
      of_complete_row_(y_.transpose() * y_),
      terms_(std::move(terms)) {}

void AxisProducts::add_row(Eigen::MatrixXd& gram, Index i, const Eigen::VectorXd& points) const {
  const bool complete = (points.array() == 1).all();
  const Eigen::MatrixXd of_row =
      complete ? of_complete_row_ : (y_.transpose() * points.asDiagonal() * y_).eval();
  const Eigen::MatrixXd of_x = x_.row(i).transpose() * x_.row(i);
  for (Index t = 0; const auto& [a, b] : terms_) {
    for (Index s = 0; const auto& [c, d] : terms_) gram(s++, t) += of_x(c, a) * of_row(d, b);
    ++t;
  }
}

void AxisProducts::add(Eigen::MatrixXd& gram, const Field& points) const {
  for (Index i = 0; i < points.rows(); ++i) add_row(gram, i, points.row(i).matrix().transpose());
}

Eigen::VectorXd AxisProducts::sums(const Field& z) const {
  const Eigen::MatrixXd all = x_.transpose() * (z.matrix() * y_);
  Eigen::VectorXd out(count());
  for (Index t = 0; const auto& [a, b] : terms_) out(t++) = all(a, b);
  return out;
}

Field AxisProducts::combined(const Eigen::VectorXd& factors) const {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(x_.cols(), y_.cols());
  for (Index t = 0; const auto& [a, b] : terms_) all(a, b) = factors(t++);
  return x_ * (all * y_.transpose());
}

Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& gram, double share, double least) {
  const Eigen::MatrixXd root = covariance_root(gram);
  const Eigen::VectorXd lambda = root.colwise().squaredNorm();  // ascending
  const Index count = (lambda.array() >= std::max(share * lambda.maxCoeff(), least)).count();
  return (root * lambda.cwiseInverse().asDiagonal()).rightCols(count).transpose();
}

}  // namespace asperity
