#include "stats/filter/form.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

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

Mean mean_of_valid(const Field& z) {
  MeanSum sum;
  sum.add(z);
  return sum.mean();
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

FormFit::FormFit(Shape field, int degree) : degree_(degree) {
  if (degree < 0 || degree > largest_form_degree)
    throw ParameterError("remove-form", "'" + std::to_string(degree) + "' is not a degree from 0 to " +
                                            std::to_string(largest_form_degree));
  along_x_ = gram_polynomials(field.nx, degree);
  along_y_ = gram_polynomials(field.ny, degree);
  for (Index a = 0; a < along_x_.cols(); ++a)
    for (Index b = 0; b < along_y_.cols() && a + b <= degree; ++b) terms_.push_back({a, b});
  gram_ = Eigen::MatrixXd::Zero(std::ssize(terms_), std::ssize(terms_));
  sums_ = Eigen::MatrixXd::Zero(along_x_.cols(), along_y_.cols());
}

void FormFit::add(const Field& strip, Index first) {
  const auto rows = along_x_.middleRows(first, strip.rows());
  Eigen::MatrixXd sums = rows.transpose() * (strip.matrix() * along_y_);
  const bool complete = !sums.hasNaN();
  if (!complete) {
    sums = rows.transpose() * (zero_filled(strip).matrix() * along_y_);
    missing_ = true;
  }
  sums_ += sums;
  if (steps_.empty()) gram_ += products(strip, first, complete);
}

// What a strip adds to (3), the sum over j of a row first.
Eigen::MatrixXd FormFit::products(const Field& strip, Index first, bool complete) const {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(gram_.rows(), gram_.cols());
  auto add = [&](auto&& of_x, const Eigen::MatrixXd& of_y) {
    for (std::size_t s = 0; s < terms_.size(); ++s)
      for (std::size_t t = 0; t <= s; ++t)
        out(static_cast<Index>(s), static_cast<Index>(t)) +=
            of_x(terms_[s].a, terms_[t].a) * of_y(terms_[s].b, terms_[t].b);
  };
  const auto rows = along_x_.middleRows(first, strip.rows());
  if (complete) {
    add(Eigen::MatrixXd(rows.transpose() * rows),
        Eigen::MatrixXd::Identity(along_y_.cols(), along_y_.cols()));
    return out;
  }
  const Field valid = validity(strip);
  for (Index i = 0; i < strip.rows(); ++i) {
    const auto weights = valid.row(i).matrix().transpose().asDiagonal();
    add([&](Index a, Index a2) { return rows(i, a) * rows(i, a2); },
        along_y_.transpose() * weights * along_y_);
  }
  return out;
}

void FormFit::end_pass() {
  Eigen::VectorXd right(static_cast<Index>(terms_.size()));
  for (Index t = 0; const Term& term : terms_) right(t++) = sums_(term.a, term.b);
  if (missing_) {
    const auto solution = solve_positive(gram_, right, least_pivot);
    if (!solution)
      throw ParameterError("remove-form", "'" + std::to_string(degree_) +
                                              "' is too high a degree for the points that are not missing");
    right = *solution;
  }
  Eigen::MatrixXd step = Eigen::MatrixXd::Zero(along_x_.cols(), along_y_.cols());
  for (Index t = 0; const Term& term : terms_) step(term.a, term.b) = right(t++);
  steps_.push_back(std::move(step));
  sums_.setZero();
}

void FormFit::remove(Eigen::Ref<Field> heights, Index row, Index column, std::size_t pass) const {
  const auto along_x = along_x_.middleRows(row, heights.rows()),
             along_y = along_y_.middleRows(column, heights.cols());
  for (; pass < steps_.size(); ++pass) heights.matrix() -= along_x * (steps_[pass] * along_y.transpose());
}

Field remove_form(const Field& z, int degree) {
  FormFit fit(shape_of(z), degree);
  Field heights = z - first_valid(z);
  const double level = heights.rowwise().mean().mean();
  heights -= std::isnan(level) ? mean_of_valid(heights).value() : level;
  if (degree == 0) return heights;
  for (std::size_t pass = 0; !fit.done(); ++pass) {
    fit.add(heights, 0);
    fit.end_pass();
    fit.remove(heights, 0, 0, pass);
  }
  return heights;
}

}  // namespace asperity
