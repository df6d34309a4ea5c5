#include "stats/uncertainty/null_distribution.hpp"

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

// The largest value of a Brownian path from a to b whose variance grows by v: e is exponential of mean 1.
double bridge_maximum(double a, double b, double v, double e) {
  return 0.5 * (a + b + std::sqrt((b - a) * (b - a) + 2 * v * e));
}

// The largest |D| of a path, 0 at both ends of the line; two normals a gap make the exponentials.
double supremum(const Eigen::VectorXd& path, const Eigen::ArrayXd& variance,
                std::span<const double> normals) {
  double largest = 0;
  for (Index a = 0; a <= path.size(); ++a) {
    const double from = a > 0 ? path(a - 1) : 0, to = a < path.size() ? path(a) : 0;
    const double sign = from + to < 0 ? -1 : 1;
    const auto pair = normals.subspan(2 * static_cast<std::size_t>(a), 2);
    const double e = 0.5 * (pair[0] * pair[0] + pair[1] * pair[1]);
    largest = std::max(largest, bridge_maximum(sign * from, sign * to, variance(a), e));
  }
  return largest;
}

// S_∞ (Φ(x_a) - Φ(x_{a-1})), the line's ends included.
Eigen::ArrayXd gap_variances(const Eigen::ArrayXd& x, double roughness) {
  Eigen::ArrayXd out(x.size() + 1);
  double below = 0;
  for (Index a = 0; a < x.size(); ++a) {
    const double here = gsl_cdf_ugaussian_P(x(a));
    out(a) = here - below;
    below = here;
  }
  out(x.size()) = 1 - below;
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
  return {covariance, 2 * static_cast<std::size_t>(variance.size()),
          [&](const Eigen::VectorXd& path, std::span<const double> normals) {
            return supremum(path, variance, normals);
          }};
}

NullDistribution::NullDistribution(const Eigen::MatrixXd& covariance, std::size_t beside,
                                   const Statistic& statistic) {
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

NullDistribution NullDistribution::of_largest(const Eigen::MatrixXd& correlation) {
  return {correlation, 0, [](const Eigen::VectorXd& g, auto) { return g.maxCoeff(); }};
}

NullDistribution NullDistribution::of_largest_magnitude(const Eigen::MatrixXd& correlation) {
  return {correlation, 0, [](const Eigen::VectorXd& g, auto) { return g.cwiseAbs().maxCoeff(); }};
}

double NullDistribution::exceedance(double value) const {
  const auto above = drawn_.end() - std::ranges::lower_bound(drawn_, value);
  return static_cast<double>(above + 1) / (draws + 1);
}

double NullDistribution::quantile(double tail) const {
  return drawn_[static_cast<std::size_t>((1 - tail) * (draws - 1))];
}

}  // namespace asperity
