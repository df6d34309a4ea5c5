#include "stats/uncertainty/empirical_process.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include "math/hermite.hpp"
#include "math/noise.hpp"

namespace asperity {
namespace {

// h_{k-1}(x)/√k in column k, k = 0…2 zero.
Eigen::MatrixXd hermite_terms(const Eigen::ArrayXd& x) {
  Eigen::MatrixXd terms = Eigen::MatrixXd::Zero(x.size(), EffectiveSize::powers + 1);
  for (Index a = 0; a < x.size(); ++a) {
    HermiteFunction h(x(a), gsl_ran_ugaussian_pdf(x(a)));
    h.next(), h.next();
    for (int k = 3; k <= EffectiveSize::powers; ++k) terms(a, k) = h.next() / std::sqrt(k);
  }
  return terms;
}

// The bracket of (2), x ≤ y.
double independent_covariance(double x, double y) {
  return gsl_cdf_ugaussian_P(x) * gsl_cdf_ugaussian_Q(y) -
         gsl_ran_ugaussian_pdf(x) * gsl_ran_ugaussian_pdf(y) * (1 + x * y / 2);
}

// L with L Lᵀ = C; eigenvalues that round-off made negative are zero.
Eigen::MatrixXd root(const Eigen::MatrixXd& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
}

// The largest value of a Brownian path from a to b whose variance grows by v: e is exponential of mean 1.
double bridge_maximum(double a, double b, double v, double e) {
  return 0.5 * (a + b + std::sqrt((b - a) * (b - a) + 2 * v * e));
}

// The largest |D| of a path, 0 at both ends of the line; two normals a gap make the exponentials.
double supremum(const Eigen::VectorXd& path, const Eigen::ArrayXd& variance, const double* normals) {
  double largest = 0;
  for (Index a = 0; a <= path.size(); ++a, normals += 2) {
    const double from = a > 0 ? path(a - 1) : 0, to = a < path.size() ? path(a) : 0;
    const double sign = from + to < 0 ? -1 : 1;
    const double e = 0.5 * (normals[0] * normals[0] + normals[1] * normals[1]);
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

Eigen::MatrixXd fitted_process_covariance(const Eigen::ArrayXd& x, const EffectiveSize& size) {
  const double last = size.sum(EffectiveSize::powers);
  const Eigen::VectorXd excess = Eigen::VectorXd::NullaryExpr(
      EffectiveSize::powers + 1, [&](Index k) { return k < 3 ? 0 : size.sum(static_cast<int>(k)) - last; });
  const Eigen::MatrixXd terms = hermite_terms(x);
  Eigen::MatrixXd out = terms * excess.asDiagonal() * terms.transpose();
  for (Index a = 0; a < x.size(); ++a)
    for (Index b = 0; b < x.size(); ++b)
      out(a, b) += last * independent_covariance(std::min(x(a), x(b)), std::max(x(a), x(b)));
  return out;
}

SupremumLaw::SupremumLaw(const Eigen::ArrayXd& x, const Eigen::MatrixXd& covariance, double roughness) {
  const Eigen::MatrixXd factor = root(covariance);
  const Eigen::ArrayXd variance = gap_variances(x, roughness);
  std::vector<double> normals(static_cast<std::size_t>(x.size() + 2 * (x.size() + 1)));
  WhiteNoise noise(1);
  suprema_.reserve(draws);
  for (int draw = 0; draw < draws; ++draw) {
    noise.row(draw, normals);
    const Eigen::VectorXd path = factor * Eigen::Map<const Eigen::VectorXd>(normals.data(), x.size());
    suprema_.push_back(supremum(path, variance, normals.data() + x.size()));
  }
  std::ranges::sort(suprema_);
}

double SupremumLaw::exceedance(double value) const {
  const auto above = suprema_.end() - std::ranges::lower_bound(suprema_, value);
  return static_cast<double>(above + 1) / (draws + 1);
}

}  // namespace asperity
