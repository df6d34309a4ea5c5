#include "stats/form.hpp"

#include <algorithm>
#include <string>

#include <Eigen/Core>

#include "grid/error.hpp"

namespace asperity {
namespace {

// Column a is P_a over n points: xP_{a-1} without what the columns before it hold, twice for the last digits.
Eigen::MatrixXd gram_polynomials(Index n, int degree) {
  const Eigen::ArrayXd x = Eigen::ArrayXd::LinSpaced(n, -1, 1);
  Eigen::MatrixXd p(n, std::min<Index>(degree + 1, n));
  p.col(0).setConstant(1 / std::sqrt(static_cast<double>(n)));
  for (Index a = 1; a < p.cols(); ++a) {
    Eigen::VectorXd next = x * p.col(a - 1).array();
    for (int pass = 0; pass < 2; ++pass) next -= p.leftCols(a) * (p.leftCols(a).transpose() * next).eval();
    p.col(a) = next.normalized();
  }
  return p;
}

}  // namespace

double mean(const Field& z) {
  const double shift = z(0, 0);
  return shift + (z - shift).rowwise().mean().mean();
}

Field without_form(const Field& z, int degree) {
  if (degree < 0 || degree > largest_form_degree)
    throw ParameterError(
        "level", std::to_string(degree) + " is no degree from 0 to " + std::to_string(largest_form_degree));
  Field heights = z - z(0, 0);
  heights -= heights.rowwise().mean().mean();
  if (degree == 0) return heights;
  const Eigen::MatrixXd along_x = gram_polynomials(z.rows(), degree),
                        along_y = gram_polynomials(z.cols(), degree);
  for (int pass = 0; pass < 2; ++pass) {
    Eigen::MatrixXd c = along_x.transpose() * (heights.matrix() * along_y);
    for (Index a = 0; a < c.rows(); ++a)
      for (Index b = std::max<Index>(0, degree + 1 - a); b < c.cols(); ++b) c(a, b) = 0;
    heights.matrix() -= along_x * (c * along_y.transpose());
  }
  return heights;
}

}  // namespace asperity
