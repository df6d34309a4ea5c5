#include "stats/filter/form.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "math/linear_algebra.hpp"

namespace asperity {
namespace {

constexpr double least_pivot = 1e-10;  // of (3), of the largest: three passes then reach round-off

double first_valid(const Field& z) {
  for (const double height : z.reshaped<Eigen::RowMajor>())
    if (!std::isnan(height)) return height;
  throw DataError("heights", "every point is missing");
}

// The mean of the rows' means; NaN where a height is missing.
double mean_of_rows(const Eigen::ArrayXd& means) {
  return std::accumulate(means.begin(), means.end(), 0.0) / static_cast<double>(means.size());
}

Mean mean_of_valid(const Field& z) {
  const double base = first_valid(z);
  ValidSum total;
  for (Index i = 0; i < z.rows(); ++i) {
    const ValidSum row = sum_of_valid(z.row(i) - base);
    total.sum += row.sum;
    total.count += row.count;
  }
  return {base, total.sum / total.count};
}

// What is left of c.
Eigen::VectorXd step_of(const AxisProducts& products, const Field& heights, const Eigen::MatrixXd& gram,
                        int degree) {
  const auto solution = solve_positive(gram, products.sums(zero_filled(heights)), least_pivot);
  if (!solution)
    throw ParameterError("remove-form", "'" + std::to_string(degree) +
                                            "' is too high a degree for the points that are not missing");
  return *solution;
}

}  // namespace

// xP_{a-1} without what the columns before it hold, twice for the last digits.
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

Mean mean_above_base(const Field& z) {
  const double base = first_valid(z), above = mean_of_rows((z - base).rowwise().mean());
  return std::isnan(above) ? mean_of_valid(z) : Mean{base, above};
}

AxisProducts polynomials(Shape field, int degree) {
  Eigen::MatrixXd along_x = gram_polynomials(field.nx, degree), along_y = gram_polynomials(field.ny, degree);
  std::vector<AxisProducts::Term> terms;
  for (Index a = 0; a < along_x.cols(); ++a)
    for (Index b = 0; b < along_y.cols() && a + b <= degree; ++b) terms.push_back({a, b});
  return {std::move(along_x), std::move(along_y), std::move(terms)};
}

Field remove_form(Field heights, int degree) {
  if (degree < 0 || degree > largest_form_degree)
    throw ParameterError("remove-form", "'" + std::to_string(degree) + "' is not a degree from 0 to " +
                                            std::to_string(largest_form_degree));
  heights -= first_valid(heights);
  const double level = mean_of_rows(heights.rowwise().mean());
  heights -= std::isnan(level) ? mean_of_valid(heights).value() : level;
  if (degree == 0) return heights;
  const AxisProducts products = polynomials(shape_of(heights), degree);
  const bool missing = has_missing(heights);
  Eigen::MatrixXd gram = products.none();  // (3)
  if (missing) products.add(gram, validity(heights));
  for (int pass = 0; pass < (missing ? 3 : 2); ++pass)
    heights -= products.combined(missing ? step_of(products, heights, gram, degree) : products.sums(heights));
  return heights;
}

}  // namespace asperity
