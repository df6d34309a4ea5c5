#include "stats/uncertainty/weighted_chi_squared.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace asperity {
namespace {

using Complex = std::complex<double>;

// Of weights up to 1.
constexpr double branch_point = 0.5;

// Each as a share of the largest.
std::vector<double> shares(const Eigen::ArrayXd& weights) {
  const double largest = weights.maxCoeff();
  std::vector<double> out;
  for (const double w : weights)
    if (w > 1e-13 * largest) out.push_back(w / largest);
  return out;
}

// K(s); off the real axis no factor meets the logarithm's cut. (std::log of a complex number takes many times as
// long for the last digit of a modulus near 1.)
Complex cumulants(const std::vector<double>& weights, Complex s) {
  double log_norm = 0, phase = 0;
  for (const double w : weights) {
    const Complex factor = 1.0 - 2 * w * s;
    log_norm += std::log(std::norm(factor));
    phase += std::arg(factor);
  }
  return {-0.25 * log_norm, -0.5 * phase};
}

// The k-th derivative of K at a real s, k ≥ 1.
double derivative(const std::vector<double>& weights, double s, int k) {
  double sum = 0;
  for (const double w : weights) sum += std::pow(2 * w / (1 - 2 * w * s), k);
  return 0.5 * std::tgamma(k) * sum;
}

// f' grows from -∞ to ∞ between pole and branch point.
double saddle_point(const std::vector<double>& weights, double x) {
  double below = 0, above = branch_point;
  for (int step = 0; step < 60; ++step) {
    const double s = 0.5 * (below + above);
    (derivative(weights, s, 1) - x - 1 / s < 0 ? below : above) = s;
  }
  return 0.5 * (below + above);
}

struct Parabola {
  double vertex, curvature;
  double width;  ///< 1/√f''(s_0): the integrand is exp(-u²/2 width²) to second order

  Complex at(double u) const { return {vertex + curvature * u * u, u}; }
  /// (ds/du)/i.
  Complex slope(double u) const { return {1, -2 * curvature * u}; }
  /// From u = 0 to the pole, or to the branch point if that is nearer.
  double distance() const {
    const double to_pole = (std::sqrt(1 + 4 * curvature * vertex) - 1) / (2 * curvature);
    return std::min(to_pole, branch_point - vertex);
  }
};

Parabola steepest_descent(const std::vector<double>& weights, double x) {
  const double s = saddle_point(weights, x);
  const double second = derivative(weights, s, 2) + 1 / (s * s);
  const double third = derivative(weights, s, 3) - 2 / (s * s * s);
  return {s, std::max(third / (6 * second), 0.1 / branch_point), 1 / std::sqrt(second)};
}

// (1), twice the half u > 0.
double integral(const std::vector<double>& weights, double x) {
  constexpr int most_nodes = 100'000;
  const Parabola path = steepest_descent(weights, x);
  const double step = std::min(path.distance() / 6, path.width / 1.5);
  double sum = 0, largest = 0;
  for (int k = 0; k < most_nodes; ++k) {
    const Complex s = path.at(k * step);
    const Complex value = std::exp(cumulants(weights, s) - x * s) / s * path.slope(k * step);
    sum += (k == 0 ? 0.5 : 1) * value.real();
    largest = std::max(largest, std::abs(value));
    if (std::abs(value) <= 1e-16 * largest) break;
  }
  return sum * step / std::numbers::pi;
}

}  // namespace

double weighted_chi_squared_exceedance(const Eigen::ArrayXd& weights, double x) {
  if (weights.size() == 0 || !(weights.maxCoeff() > 0)) return x < 0 ? 1 : 0;
  if (x <= 0) return 1;
  return std::clamp(integral(shares(weights), x / weights.maxCoeff()), 0.0, 1.0);
}

}  // namespace asperity
