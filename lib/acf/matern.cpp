#include "acf/matern.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gsl/gsl_sf_bessel.h>

namespace asperity {

namespace {

constexpr double least_radius = 1e-8, most_radius = 1000, step = 1.0 / 32;

double log_bessel_k(double order, double r) { return gsl_sf_bessel_lnKnu(std::abs(order), r); }

// ln ρ and its first two derivatives in ln r, by (1) and (3).
QuinticTable::Node node(double nu, double r) {
  const double k = log_bessel_k(nu, r), u = -r * std::exp(log_bessel_k(nu - 1, r) - k);
  const double value = (1 - nu) * std::numbers::ln2 - std::lgamma(nu) + nu * std::log(r) + k;
  return {std::min(value, 0.0), u, 2 * nu * u + r * r - u * u};
}

}  // namespace

MaternCorrelation::MaternCorrelation(double smoothness) {
  std::vector<QuinticTable::Node> nodes;
  const double first = std::log(least_radius);
  for (int i = 0; first + (i - 1) * step < std::log(most_radius); ++i)
    nodes.push_back(node(smoothness, std::exp(first + i * step)));
  logarithm_ = QuinticTable(first, step, nodes);
  exponent_ = 2 * std::min(smoothness, 1.0);
  coefficient_ = -std::expm1(nodes[0][0]) * std::pow(least_radius, -exponent_);
}

double MaternCorrelation::operator()(double r) const {
  if (r < least_radius) return 1 - coefficient_ * std::pow(r, exponent_);
  return r < most_radius ? std::min(1.0, std::exp(logarithm_(std::log(r)))) : 0;
}

}  // namespace asperity
