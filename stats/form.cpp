#include "stats/form.hpp"

namespace asperity {
namespace {

// -(n-1)/2 … (n-1)/2.
Eigen::ArrayXd centred_indices(Index n) {
  const double half = 0.5 * static_cast<double>(n - 1);
  return Eigen::ArrayXd::LinSpaced(n, -half, half);
}

// (1), 0 on a single point.
double slope(const Eigen::ArrayXd& index, const Eigen::ArrayXd& means) {
  const double norm = index.square().sum();
  return norm > 0 ? (index * means).sum() / norm : 0.0;
}

}  // namespace

double mean(const Field& z) {
  const double shift = z(0, 0);
  return shift + (z - shift).rowwise().mean().mean();
}

Field without_form(const Field& z, Form form) {
  Field heights = z - z(0, 0);
  const Eigen::ArrayXd of_rows = heights.rowwise().mean();
  const double level = of_rows.mean();
  if (form == Form::mean) return heights - level;

  const Eigen::ArrayXd of_columns = heights.colwise().mean().transpose();
  const Eigen::ArrayXd i = centred_indices(z.rows()), j = centred_indices(z.cols());
  const Eigen::ArrayXd along_x = level + slope(i, of_rows) * i, along_y = slope(j, of_columns) * j;
  heights.colwise() -= along_x;
  heights.rowwise() -= along_y.transpose();
  return heights;
}

}  // namespace asperity
