#include "stats/hypothesis/null_distribution.hpp"

#include <algorithm>
#include <cmath>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include "math/hermite.hpp"
#include "math/linear_algebra.hpp"
#include "math/noise.hpp"

namespace asperity {
namespace {

// h_{k-1}(x)/√k in column k, k = 0…2 zero.
Eigen::MatrixXd hermite_terms(const Eigen::ArrayXd& x) {
  Eigen::MatrixXd terms = Eigen::MatrixXd::Zero(x.size(), EffectiveSampleSize::powers + 1);
  for (Index a = 0; a < x.size(); ++a) {
    HermiteFunction h(x(a), gsl_ran_ugaussian_pdf(x(a)));
    h.next(), h.next();
    for (int k = 3; k <= EffectiveSampleSize::powers; ++k) terms(a, k) = h.next() / std::sqrt(k);
  }
  return terms;
}

// The bracket of (2), x ≤ y.
double independent_covariance(double x, double y) {
  return gsl_cdf_ugaussian_P(x) * gsl_cdf_ugaussian_Q(y) -
         gsl_ran_ugaussian_pdf(x) * gsl_ran_ugaussian_pdf(y) * (1 + x * y / 2);
}

// The largest |D| of a path, 0 at both ends of the line. Over a gap of variance v a Brownian path from a to b
// has the maximum ½(a + b + √((b-a)² + 2ve)), e exponential of mean 1, which two normals make.
double supremum(const Eigen::VectorXd& path, const Eigen::ArrayXd& variance,
                std::span<const double> normals) {
  double largest = 0;
  for (Index a = 0; a <= path.size(); ++a) {
    const double from = a > 0 ? path(a - 1) : 0, to = a < path.size() ? path(a) : 0;
    const auto pair = normals.subspan(2 * static_cast<std::size_t>(a), 2);
    const double e = 0.5 * (pair[0] * pair[0] + pair[1] * pair[1]);
    const double rise = to - from;
    largest = std::max(largest, 0.5 * (std::abs(from + to) + std::sqrt(rise * rise + 2 * variance(a) * e)));
  }
  return largest;
}

// S_∞ (Φ(x_a) - Φ(x_{a-1})), the line's ends included.
Eigen::ArrayXd gap_variances(const Eigen::ArrayXd& x, double roughness) {
  Eigen::ArrayXd out(x.size() + 1);
  out << x.unaryExpr(&gsl_cdf_ugaussian_P), 1;
  out.tail(x.size()) -= out.head(x.size()).eval();
  return roughness * out;
}

}  // namespace

Eigen::MatrixXd fitted_process_covariance(const Eigen::ArrayXd& x, const EffectiveSampleSize& size) {
  const double last = size.sum(EffectiveSampleSize::powers);
  const Eigen::VectorXd excess = Eigen::VectorXd::NullaryExpr(EffectiveSampleSize::powers + 1, [&](Index k) {
    return k < 3 ? 0 : size.sum(static_cast<int>(k)) - last;
  });
  const Eigen::MatrixXd terms = hermite_terms(x);
  Eigen::MatrixXd out = terms * excess.asDiagonal() * terms.transpose();
  for (Index a = 0; a < x.size(); ++a)
    for (Index b = 0; b < x.size(); ++b)
      out(a, b) += last * independent_covariance(std::min(x(a), x(b)), std::max(x(a), x(b)));
  return out;
}

NullDistribution supremum_distribution(const Eigen::ArrayXd& x, const Eigen::MatrixXd& covariance,
                                       double roughness) {
  const Eigen::ArrayXd variance = gap_variances(x, roughness);
  auto largest = [&](const Eigen::VectorXd& path, std::span<const double> normals) {
    return supremum(path, variance, normals);
  };
  return {covariance, largest, 2 * static_cast<std::size_t>(variance.size())};
}

NullDistribution::NullDistribution(const Eigen::MatrixXd& covariance, const Statistic& statistic,
                                   std::size_t beside) {
  const Eigen::MatrixXd root = covariance_root(covariance);
  std::vector<double> normals(static_cast<std::size_t>(root.cols()) + beside);
  WhiteNoise noise(1);
  drawn_.reserve(draws);
  for (int draw = 0; draw < draws; ++draw) {
    noise.row(draw, normals);
    const Eigen::VectorXd g = root * Eigen::Map<const Eigen::VectorXd>(normals.data(), root.cols());
    drawn_.push_back(statistic(g, std::span(normals).last(beside)));
  }
  std::ranges::sort(drawn_);
}

double NullDistribution::exceedance(double value) const {
  const auto above = drawn_.end() - std::ranges::lower_bound(drawn_, value);
  return static_cast<double>(above + 1) / (draws + 1);
}

double NullDistribution::quantile(double tail) const {
  return drawn_[static_cast<std::size_t>((1 - tail) * (draws - 1))];
}

}  // namespace asperity
