#include "stats/hypothesis/weighted_chi_squared.hpp"

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

// K(s); off the real axis no factor meets the logarithm's cut. (std::log of a complex number takes many times
// as long for the last digit of a modulus near 1.)
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

// (1), twice the half u > 0; to second order in u the integrand is exp(-u²f''/2).
double integral(const std::vector<double>& weights, double x) {
  constexpr int most_nodes = 100'000;
  const double vertex = saddle_point(weights, x);
  const double second = derivative(weights, vertex, 2) + 1 / (vertex * vertex);
  const double third = derivative(weights, vertex, 3) - 2 / (vertex * vertex * vertex);
  const double a = std::max(third / (6 * second), 0.1 / branch_point);
  const double to_pole = (std::sqrt(1 + 4 * a * vertex) - 1) / (2 * a);
  const double step = std::min(std::min(to_pole, branch_point - vertex) / 6, 1 / std::sqrt(second) / 1.5);
  double sum = 0, largest = 0;
  for (int k = 0; k < most_nodes; ++k) {
    const double u = k * step;
    const Complex s{vertex + a * u * u, u}, slope{1, -2 * a * u};  // ds/du, over i
    const Complex value = std::exp(cumulants(weights, s) - x * s) / s * slope;
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
