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

// Of the first rank's rows.
double first_valid(const Field& z, const Ranks& ranks) {
  std::vector<double> first;
  if (ranks.rank() == 0) first.push_back(first_valid(z));
  return gathered(ranks, first).front();
}

// The mean of the rows' means; NaN where a height is missing.
double mean_of_rows(const Eigen::ArrayXd& own, const Ranks& ranks) {
  const std::vector<double> all = gathered(ranks, std::vector<double>(own.begin(), own.end()));
  return std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
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

Mean mean_above_base(const Field& z, const Ranks& ranks) {
  const double base = first_valid(z, ranks), above = mean_of_rows((z - base).rowwise().mean(), ranks);
  return std::isnan(above) ? mean_of_valid(z) : Mean{base, above};
}

AxisProducts polynomials(Shape field, int degree) {
  Eigen::MatrixXd along_x = gram_polynomials(field.nx, degree), along_y = gram_polynomials(field.ny, degree);
  std::vector<AxisProducts::Term> terms;
  for (Index a = 0; a < along_x.cols(); ++a)
    for (Index b = 0; b < along_y.cols() && a + b <= degree; ++b) terms.push_back({a, b});
  return {std::move(along_x), std::move(along_y), std::move(terms)};
}

FormFit::FormFit(Shape field, int degree) : degree_(degree) {
  if (degree < 0 || degree > largest_form_degree)
    throw ParameterError("remove-form", "'" + std::to_string(degree) + "' is not a degree from 0 to " +
                                            std::to_string(largest_form_degree));
  products_ = polynomials(field, degree);
  gram_ = products_.none();
  sums_ = Eigen::VectorXd::Zero(products_.count());
}

void FormFit::add(const Field& strip, Index first) {
  Eigen::VectorXd sums = products_.sums(strip, first);
  if (sums.hasNaN()) {
    sums = products_.sums(zero_filled(strip), first);
    missing_ = true;
  }
  sums_ += sums;
  if (steps_.empty()) products_.add(gram_, validity(strip), first);
}

void FormFit::end_pass() {
  Eigen::VectorXd step = sums_;
  if (missing_) {
    const auto solution = solve_positive(gram_, sums_, least_pivot);
    if (!solution)
      throw ParameterError("remove-form", "'" + std::to_string(degree_) +
                                              "' is too high a degree for the points that are not missing");
    step = *solution;
  }
  steps_.push_back(std::move(step));
  sums_.setZero();
}

void FormFit::remove(Eigen::Ref<Field> heights, Index row, Index column, std::size_t pass) const {
  for (; pass < steps_.size(); ++pass)
    heights -= products_.combined(steps_[pass], row, column, {heights.rows(), heights.cols()});
}

Field remove_mean(Field heights, const Ranks& ranks) {
  heights -= first_valid(heights, ranks);
  const double level = mean_of_rows(heights.rowwise().mean(), ranks);
  heights -= std::isnan(level) ? mean_of_valid(heights).value() : level;
  return heights;
}

Field remove_form(Field heights, int degree) {
  FormFit fit(shape_of(heights), degree);
  heights = remove_mean(std::move(heights));
  if (degree == 0) return heights;
  for (std::size_t pass = 0; !fit.done(); ++pass) {
    fit.add(heights, 0);
    fit.end_pass();
    fit.remove(heights, 0, 0, pass);
  }
  return heights;
}

}  // namespace asperity
