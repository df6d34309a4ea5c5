#include "stats/form.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>

#include "grid/error.hpp"

namespace asperity {
namespace {

constexpr double least_pivot = 1e-10;  // of (3), of the largest: three passes then reach round-off

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

Mean mean_of_valid(const Field& z) {
  MeanSum sum;
  sum.add(z);
  return sum.mean();
}

struct Term {
  Index a, b;
};

std::vector<Term> terms_of(Index columns_x, Index columns_y, int degree) {
  std::vector<Term> out;
  for (Index a = 0; a < columns_x; ++a)
    for (Index b = 0; b < columns_y && a + b <= degree; ++b) out.push_back({a, b});
  return out;
}

// The products (3), the sum over j of a row first.
Eigen::MatrixXd products_over_valid(const Field& valid, const Eigen::MatrixXd& along_x,
                                    const Eigen::MatrixXd& along_y, const std::vector<Term>& terms) {
  const auto n = static_cast<Index>(terms.size());
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(n, n);
  for (Index i = 0; i < valid.rows(); ++i) {
    const Eigen::MatrixXd of_row =
        along_y.transpose() * valid.row(i).matrix().transpose().asDiagonal() * along_y;
    for (Index s = 0; s < n; ++s)
      for (Index t = 0; t <= s; ++t) {
        const auto [a, b] = terms[static_cast<std::size_t>(s)];
        const auto [a2, b2] = terms[static_cast<std::size_t>(t)];
        out(s, t) += along_x(i, a) * along_x(i, a2) * of_row(b, b2);
      }
  }
  return out;
}

// Heights of which some are missing, above the form that fits the others best.
Field without_form_of_valid(Field heights, const Eigen::MatrixXd& along_x, const Eigen::MatrixXd& along_y,
                            int degree) {
  const std::vector<Term> terms = terms_of(along_x.cols(), along_y.cols(), degree);
  const Eigen::LDLT<Eigen::MatrixXd> products(
      products_over_valid(validity(heights), along_x, along_y, terms));
  const Eigen::ArrayXd pivots = products.vectorD();
  if (!(pivots.minCoeff() > least_pivot * pivots.maxCoeff()))
    throw ParameterError(
        "level",
        std::to_string(degree) + ": the points that are not missing do not determine a form of this degree");
  for (int pass = 0; pass < 3; ++pass) {
    const Eigen::MatrixXd seen = along_x.transpose() * (zero_filled(heights).matrix() * along_y);
    Eigen::VectorXd right(terms.size());
    for (Index t = 0; t < right.size(); ++t) {
      const auto [a, b] = terms[static_cast<std::size_t>(t)];
      right(t) = seen(a, b);
    }
    const Eigen::VectorXd solved = products.solve(right);
    Eigen::MatrixXd c = Eigen::MatrixXd::Zero(along_x.cols(), along_y.cols());
    for (Index t = 0; t < right.size(); ++t) {
      const auto [a, b] = terms[static_cast<std::size_t>(t)];
      c(a, b) = solved(t);
    }
    heights.matrix() -= along_x * (c * along_y.transpose());
  }
  return heights;
}

}  // namespace

void MeanSum::add(const Field& strip) {
  if (!base_) {
    if (strip.isNaN().all()) return;
    base_ = first_valid(strip);
  }
  for (Index i = 0; i < strip.rows(); ++i) {
    const ValidSum row = sum_of_valid(strip.row(i) - *base_);
    total_.sum += row.sum;
    total_.count += row.count;
  }
}

Mean MeanSum::mean() const {
  if (!base_) throw DataError("heights", "every point is missing");
  return {*base_, total_.sum / total_.count};
}

Mean mean_above_base(const Field& z) {
  const double base = first_valid(z), above = (z - base).rowwise().mean().mean();
  return std::isnan(above) ? mean_of_valid(z) : Mean{base, above};
}

Field without_form(const Field& z, int degree) {
  if (degree < 0 || degree > largest_form_degree)
    throw ParameterError(
        "level", std::to_string(degree) + " is no degree from 0 to " + std::to_string(largest_form_degree));
  Field heights = z - first_valid(z);
  const double level = heights.rowwise().mean().mean();
  const bool complete = !std::isnan(level);
  heights -= complete ? level : mean_of_valid(heights).value();
  if (degree == 0) return heights;
  const Eigen::MatrixXd along_x = gram_polynomials(z.rows(), degree),
                        along_y = gram_polynomials(z.cols(), degree);
  if (!complete) return without_form_of_valid(std::move(heights), along_x, along_y, degree);
  for (int pass = 0; pass < 2; ++pass) {
    Eigen::MatrixXd c = along_x.transpose() * (heights.matrix() * along_y);
    for (Index a = 0; a < c.rows(); ++a)
      for (Index b = std::max<Index>(0, degree + 1 - a); b < c.cols(); ++b) c(a, b) = 0;
    heights.matrix() -= along_x * (c * along_y.transpose());
  }
  return heights;
}

}  // namespace asperity
